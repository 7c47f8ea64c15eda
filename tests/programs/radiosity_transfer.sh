# `radiosity transfer`: a room relit by environments and lamps, against solutions for the same light; a model of many
# small polygons, with --check; gloss; and Ctrl-C.
. "$(dirname "$0")/radiosity_program.sh"
. "$SOURCE/tests/programs/room.sh"
needs_built compare
skip_unless convert perl

# sky FILE DEGREES: writes a picture of all directions, 64 x 32: an even sky with a bright spot, DEGREES of azimuth from
# the middle
sky() {
    perl -e 'print "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
        for $j (0 .. 31) { for $i (0 .. 63) {
            $down = 3.14159265 * ($j + .5) / 32; $around = 2 * 3.14159265 * (($i + .5) / 64 - .5 - $ARGV[0] / 360);
            $c = .8 * sin($down) * cos($around) + .6 * cos($down);
            $b = .4 + 3 * ($c > 0 ? $c ** 6 : 0); $e = int(log($b) / log(2) + 8) - 7;
            print pack("C4", 200 * $b / 2 ** $e, 180 * $b / 2 ** $e, 128 * $b / 2 ** $e, $e + 128) } }' "$2" >"$1"
}
sky east.hdr 90
sky ahead.hdr 0

# --- Against solutions for the same light, with the same number of rays ---
open_room room
fine=(--element 0.02 --rays 64) size=(--size 160x100)
at=("${size[@]}" --eye 0,1.5,7 --at 0,1.5,0)
check "transfer" prints '^5 bands, 25 functions; lamps 1 lamp, 2 spot$' "$radiosity" transfer room.obj -o room.prt "${fine[@]}" --clusters 40
check "... prints its clusters" grep -qE '^40 clusters of [0-9]+ axes: [0-9.]+ MB instead of' printed
lit() { "$radiosity" render room.prt -o "$1" "${at[@]}" "${@:2}" >out; }
cp room.mtl whole.mtl
picture() { # picture NAME SED OPTION...: renders a solution whose lamps were altered
    sed "$2" whole.mtl >room.mtl && solved fresh room.obj "${fine[@]}" "${@:3}" && "$radiosity" render fresh.rad -o "$1" "${at[@]}" >out
}
check "an environment" eval "lit east.png --sky east.hdr --lamps none && picture fresh.png '/^Ke/d' --sky east.hdr"
check "... is like the solution for the whole environment" like east.png fresh.png 35
check "... and what the bands lose is printed" grep -qE 'east.hdr: 5 bands hold 9[0-9.]* % of its energy and lose [0-9.]* %$' <(lit east.png --sky east.hdr --lamps none; cat out)
check "one lamp of two" eval "lit spot.png --lamps spot && lit number.png --lamps 2=1 && picture fresh.png 's/^Ke 9 8 6/Ke 0 0 0/'"
check "... is that lamp's light alone" like spot.png fresh.png 45
check "... and the same by its number" cmp spot.png number.png
check "a sky that is turned" lit turned.png --sky ahead.hdr --turn 90 --lamps none
check "... is like the sky whose spot lies there" like turned.png east.png 50
check "... and unlike the sky before the turn" eval 'lit ahead.png --sky ahead.hdr --lamps none && ! like turned.png ahead.png 40'
light() { "$radiosity" export room.prt --csv light.csv "$@" >out && awk -F, 'FNR > 1 { s += $9 * $8 } END { print s }' light.csv; }
check "a lamp at twice its strength gives twice its light" eval 'awk "BEGIN { d = $(light --lamps lamp=2) / $(light --lamps lamp); exit !(d > 1.9999 && d < 2.0001) }"'
check "an atlas" eval '"$radiosity" export room.prt --atlas atlas --sky 1,1,1 >out && test -s atlas/light-0.hdr'
awk '/^v/ { print $1, $2, -$4, $3; next } 1' room.obj >tall.obj
cp whole.mtl room.mtl
"$radiosity" transfer tall.obj -o tall.prt "${fine[@]}" --up z >out
check "where z is up, the same picture without --up" eval '"$radiosity" render tall.prt -o tall.png "${size[@]}" --eye 0,-7,1.5 --at 0,0,1.5 --sky ahead.hdr --turn 90 --lamps none && like tall.png turned.png 50'
check "gloss" prints '^gloss in [0-9]* squares' "$radiosity" transfer room.obj -o glossy.prt "${fine[@]}" --glossy red --gloss 0.5,60
check "... shows on the polished wall" eval '"$radiosity" render glossy.prt -o glossy.png "${at[@]}" --lamps lamp >out && lit dull.png --lamps lamp && ! like glossy.png dull.png 40'

# --- Any model, and --check ---
# Hills of hundreds of small triangles beneath a lamp, in centimetres
awk 'BEGIN { n = 20; print "mtllib hills.mtl\nusemtl grey"
    for (j = 0; j <= n; ++j) for (i = 0; i <= n; ++i) printf "v %g %g %g\n", i * 20 - 200, 40 * sin(i / 3) * cos(j / 3), j * 20 - 200
    for (j = 0; j < n; ++j) for (i = 0; i < n; ++i) { a = j * (n + 1) + i + 1; print "f", a, a + n + 1, a + 1; print "f", a + 1, a + n + 1, a + n + 2 }
    print "usemtl lamp\nv -40 150 -40\nv 40 150 -40\nv 40 150 40\nv -40 150 40\nf -4 -3 -2 -1" }' >hills.obj
printf 'newmtl grey\nKd 0.5 0.4 0.3\nnewmtl lamp\nKd 0 0 0\nKe 30 28 25\n' >hills.mtl
check "transfer of hills" eval '"$radiosity" transfer hills.obj -o hills.prt --rays 64 --check --sky east.hdr --element 400 >printed 2>err'
check "... and what the bands lose" grep -qE "east.hdr: 5 bands hold [0-9.]+ %" printed
errors() { awk '/^    (even|gradient|glow|two lights|random|all lamps) / { sub(/(two|all) /, ""); if ($2 > rows) rows = $2; if ($3 > most) most = $3; ++n } END { print n, rows + 0, most + 0 }' printed; }
echo "    lights, worst by rows, by clusters, %: $(errors)"
check "... six lights: rows within .01 %, clusters within 1 %" eval '[ "$(errors | awk "{ print (\$1 == 6 && \$2 <= 0.01 && \$3 <= 1) }")" = 1 ]'
check "a table of its light" "$radiosity" export hills.prt --csv hills.csv --sky 1,1,1
check "... holds no more than the sky and the lamp give" table hills.csv 'if ($9 < 0 || $9 > 50) ++off' 'lines >= 800 && off + 0 == 0'

# Ctrl-C during --check: the room is saved
interrupted() { # fails if the check had already ended: then it is tried again
    in_background "$radiosity" transfer room.obj -o stopped.prt --element 0.004 --rays 128 --check
    stopped_at '^processor seconds' out
    [ $? = 1 ] && [ "$(cat err)" = "radiosity: interrupted: the check is incomplete; stopped.prt is saved" ]
}
check "Ctrl-C ends it with status 1 and one line" await interrupted
check "... and the room can be rendered" "$radiosity" render stopped.prt -o stopped.png --size 80x60

check "an unknown lamp" refuses 2 "no lamp 'moon'; the room has 1 lamp, 2 spot" "$radiosity" render room.prt -o x.png --lamps moon
check "options for a room with a solution" refuses 2 "is for a room that" "$radiosity" render fresh.rad -o x.png --turn 3
check "refusals leave no files" eval '! ls x.* 2>/dev/null'
finish
