# `radiosity transfer`: rooms lit by any environment and their lamps, against solutions for that light; the output of
# --check; pictures of the bands; gloss; and what is refused.
. "$(dirname "$0")/radiosity_program.sh"
. "$SOURCE/tests/programs/room.sh"
needs_built compare
skip_unless convert perl

# sky FILE DEGREES: a picture of all directions, 64 x 32: a bright spot over an even sky, DEGREES of azimuth from the
# middle
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

open_room room
fine=(--element 0.01 --rays 64)
check "transfer" prints '^5 bands, 25 functions; lamps 1 lamp, 2 spot$' "$radiosity" transfer room.obj -o room.prt "${fine[@]}"
check "... prints its clusters" grep -qE '^[0-9]+ clusters of 24 axes: [0-9.]+ MB instead of' printed
size=(--size 240x160 --eye 0,1.5,7 --at 0,1.5,0)

# What solve gives for the same light from the same rays
solved() { # solved NAME OPTION...: a picture of a solution
    local name=$1
    shift
    "$radiosity" solve room.obj -o solved.rad "${fine[@]}" "$@" >out && "$radiosity" render solved.rad -o "$name" "${size[@]}" >out
}
cp room.mtl whole.mtl
check "an even sky" "$radiosity" render room.prt -o even.png "${size[@]}" --sky 2,3,4 --lamps none
sed '/^Ke/d' whole.mtl >room.mtl
solved even-solved.png --sky 2,3,4
check "... is the solution's" like even.png even-solved.png 55
cp whole.mtl room.mtl
check "all lamps" "$radiosity" render room.prt -o lamps.png "${size[@]}"
solved lamps-solved.png
check "... are the solution's" like lamps.png lamps-solved.png 45
sed 's/^Ke 9 8 6/Ke 0 0 0/' whole.mtl >room.mtl
solved spot-solved.png
cp whole.mtl room.mtl
for name in 2 spot spot=1; do
    check "--lamps $name" "$radiosity" render room.prt -o spot.png "${size[@]}" --lamps $name
    check "... is that lamp's light alone" like spot.png spot-solved.png 45
done
check "an environment" prints '^east.hdr: 5 bands hold 9[0-9.]* % of its energy and lose [0-9.]* %$' "$radiosity" render room.prt -o east.png "${size[@]}" --sky east.hdr --lamps none
sed '/^Ke/d' whole.mtl >room.mtl
solved east-solved.png --sky east.hdr
cp whole.mtl room.mtl
check "... is much like the solution for all of it" like east.png east-solved.png 35
check "... turned" "$radiosity" render room.prt -o turned.png "${size[@]}" --sky ahead.hdr --turn 90 --lamps none
check "... is the one to which it was turned" like turned.png east.png 50
check "... not the other" eval '! like east.png even.png 40'
check "... clusters" "$radiosity" render room.prt -o clusters.png "${size[@]}" --sky east.hdr --lamps none --rank 24
check "... look like rows" like clusters.png east.png 45
check "... few axes less so" "$radiosity" render room.prt -o few.png "${size[@]}" --sky east.hdr --lamps none --rank 1
check "... measurably" eval '! like few.png east.png 45'
check "export" "$radiosity" export room.prt --csv room.csv --sky 1,1,1 --lamps none
check "... has light everywhere" table room.csv 'if ($9 < 0 || $9 > 1.2) ++off; s += $9' 'off + 0 == 0 && s > 100'
check "export of a lamp at twice its strength" "$radiosity" export room.prt --csv twice.csv --lamps lamp=2
"$radiosity" export room.prt --csv once.csv --lamps lamp
check "... is twice its light" eval '[ "$(awk -F, "FNR > 1 { s[FILENAME] += \$9 } END { d = s[\"twice.csv\"] / s[\"once.csv\"]; print (d > 1.9999 && d < 2.0001) }" twice.csv once.csv)" = 1 ]'
check "an atlas" "$radiosity" export room.prt --atlas atlas --sky 1,1,1
check "... with a page" test -s atlas/light-0.hdr
awk '/^v/ { print $1, $2, -$4, $3; next } 1' room.obj >tall.obj
"$radiosity" transfer tall.obj -o tall.prt "${fine[@]}" --up z >out
check "where z is up" "$radiosity" render tall.prt -o tall.png --size 240x160 --eye 0,-7,1.5 --at 0,0,1.5 --up z --sky ahead.hdr --turn 90 --lamps none
check "... the same picture" like tall.png turned.png 50
# Without --up the camera stands as the room does
for up in "" "--up z" "--up y"; do
    "$radiosity" render tall.prt -o "tall$up.png" --size 240x160 $up >"camera$up"
done
check "... and without --up" cmp "tall.png" "tall--up z.png"
check "... from the same place" cmp camera "camera--up z"
check "... unlike where y is up" eval '! cmp -s camera "camera--up y"'

# The output of --check: errors, and a table of clusters and one subspace
for bands in 1 2 3 4 5 6; do
    check "--check, $bands bands" "$radiosity" transfer room.obj -o b.prt --element 0.04 --rays 64 --bands $bands --check --sky east.hdr >checked
    errors() { awk '/^    (even|gradient|glow|two lights|random) / { sub(/two /, ""); if ($2 + 0 > rows) rows = $2; if ($3 + 0 > most) most = $3; ++n } END { print n, rows + 0, most + 0 }' checked; }
    echo "    skies, worst by rows, by clusters, %: $(errors)"
    check "... five skies: rows within .01 %, clusters within 1 %" eval '[ "$(errors | awk "{ print (\$1 == 5 && \$2 <= 0.01 && \$3 <= 1) }")" = 1 ]'
    # (a lamp alone gets more shadow rays than beside a larger one)
    check "... and the lamps within .3 %" eval '[ "$(awk "/all lamps/ { print (\$3 <= 0.3 && \$4 <= 1) }" checked)" = 1 ]'
    check "... and what the bands lose" grep -qE "east.hdr: $bands bands hold [0-9.]+ %" checked
done
"$radiosity" transfer room.obj -o b.prt "${fine[@]}" --clusters 40 --check >checked
check "clusters beat one subspace of the same memory" eval '[ "$(awk "/CPCA/ { on = 1 } on && NF == 7 && \$2 > 0 { ++n; bad += \$3 >= \$6 } END { print (n >= 4 && !bad) }" checked)" = 1 ]'

for rank in 1 3 6; do # also where it is no multiple of four
    "$radiosity" transfer room.obj -o b.prt --element 0.04 --rays 64 --rank $rank --check >checked
    table_rows() { awk '/CPCA/ { on = 1 } on && /^ +[0-9.]+ +[0-9]+ / { all = all $2 " " } END { print all }' checked; }
    check "--rank $rank: the table ends with it" eval '[ "$(table_rows)" = "$([ $rank = 6 ] && echo "4 ")$rank " ]'
done
check "the room's own clusters are in it" eval '[ "$(awk "/^    [a-z]/ && \$NF ~ /[0-9]/ { sub(/two /, \"\"); if (\$3 > most) most = \$3 } /CPCA/ { on = 1 } on && \$2 == 6 { print (most == \$4) }" checked)" = 1 ]'
# Ctrl-C while it compares: the room is there
behind "$radiosity" transfer room.obj -o stopped.prt --element 0.004 --rays 128 --check
stopped_at '^processor seconds' out
check "Ctrl-C ends it with status 1" test $? = 1
check "... before its end" eval '! grep -q "^of the rows" out'
check "... with one line" eval '[ "$(cat err)" = "radiosity: interrupted: the check is incomplete; stopped.prt is saved" ]'
check "... which is true" "$radiosity" render stopped.prt -o stopped.png --size 80x60

check "gloss" prints '^gloss in [0-9]* squares' "$radiosity" transfer room.obj -o glossy.prt --element 0.04 --glossy red --gloss 0.5,60
check "... shows" "$radiosity" render glossy.prt -o glossy.png "${size[@]}" --lamps lamp
"$radiosity" transfer room.obj -o dull.prt --element 0.04 >out
"$radiosity" render dull.prt -o dull.png "${size[@]}" --lamps lamp
check "... on the polished wall" eval '! like glossy.png dull.png 40'
right() { convert "$1" -crop 120x160+120+0 +repage "right-$1"; }
right glossy.png && right dull.png

# Refusals
check "no model" refuses 2 "name a model" "$radiosity" transfer
check "no file" refuses 2 "name a file for the room" "$radiosity" transfer room.obj
check "too many bands" refuses 2 "--bands" "$radiosity" transfer room.obj -o x.prt --bands 7
check "options of solve that it has not" refuses 2 "cannot use '--patch'" "$radiosity" transfer room.obj -o x.prt --patch 1
check "a material that is not there" refuses 2 "no polygon has the material gold" "$radiosity" transfer room.obj -o x.prt "${fine[@]}" --glossy gold
check "a sky without --check" refuses 2 "--sky belongs to --check" "$radiosity" transfer room.obj -o x.prt --sky east.hdr
check "too little memory" refuses 1 "more than the 1 of --memory" "$radiosity" transfer room.obj -o x.prt --memory 1
check "a lamp that is not there" refuses 2 "no lamp 'moon'; there are 1 lamp, 2 spot" "$radiosity" render room.prt -o x.png --lamps moon
check "a lamp without a strength" refuses 2 "a strength is from 0" "$radiosity" render room.prt -o x.png --lamps lamp=
check "more bands than there are" refuses 2 "the room has 5 bands" "$radiosity" render room.prt -o x.png --bands 6
check "a sky that is not there" refuses 2 "cannot read none.hdr" "$radiosity" render room.prt -o x.png --sky none.hdr
check "options for a room with a solution" refuses 2 "is for a room that" "$radiosity" render solved.rad -o x.png --turn 3
head -c 5000 room.prt >cut.prt
check "a file that was cut short" refuses 1 "cut.prt: is damaged" "$radiosity" render cut.prt -o x.png
check "no place for it" refuses 2 "cannot write" "$radiosity" transfer room.obj -o none/x.prt
check "a full disk" refuses 1 "cannot write" "$radiosity" transfer room.obj -o /dev/full --element 1
check "none of them left a file" eval '! ls x.* none 2>/dev/null'
finish
