# `radiosity transfer`: a room lit by any environment and its lamps, against solutions for that light; a model as
# modelling programs export them, with --check; gloss; and Ctrl-C.
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

# --- Against solutions for the same light from the same rays ---
open_room room
fine=(--element 0.02 --rays 64) size=(--size 160x100)
at=("${size[@]}" --eye 0,1.5,7 --at 0,1.5,0)
check "transfer" prints '^5 bands, 25 functions; lamps 1 lamp, 2 spot$' "$radiosity" transfer room.obj -o room.prt "${fine[@]}" --clusters 40
check "... prints its clusters" grep -qE '^40 clusters of [0-9]+ axes: [0-9.]+ MB instead of' printed
lit() { "$radiosity" render room.prt -o "$1" "${at[@]}" "${@:2}" >out; }
cp room.mtl whole.mtl
picture() { # picture NAME SED OPTION...: of a solution with altered lamps
    sed "$2" whole.mtl >room.mtl && solved fresh room.obj "${fine[@]}" "${@:3}" && "$radiosity" render fresh.rad -o "$1" "${at[@]}" >out
}
check "an even sky" eval "lit even.png --sky 2,3,4 --lamps none && picture fresh.png '/^Ke/d' --sky 2,3,4"
check "... is the solution's" like even.png fresh.png 50
check "an environment" eval "lit east.png --sky east.hdr --lamps none && picture fresh.png '/^Ke/d' --sky east.hdr"
check "... is much like the solution for all of it" like east.png fresh.png 35
check "... and what the bands lose is printed" grep -qE 'east.hdr: 5 bands hold 9[0-9.]* % of its energy and lose [0-9.]* %$' <(lit east.png --sky east.hdr --lamps none; cat out)
check "one lamp of two" eval "lit spot.png --lamps spot && lit number.png --lamps 2=1 && picture fresh.png 's/^Ke 9 8 6/Ke 0 0 0/'"
check "... is that lamp's light alone" like spot.png fresh.png 45
check "... and the same by its number" cmp spot.png number.png
check "a sky that is turned" lit turned.png --sky ahead.hdr --turn 90 --lamps none
check "... is the one to which it was turned" like turned.png east.png 50
check "... not the other" eval '! like turned.png even.png 40'
check "clusters" eval 'lit clusters.png --sky east.hdr --lamps none --rank 24 && lit few.png --sky east.hdr --lamps none --rank 1'
check "... look like rows; few axes less so" eval 'like clusters.png east.png 45 && ! like few.png east.png 45'
light() { "$radiosity" export room.prt --csv light.csv "$@" >out && awk -F, 'FNR > 1 { s += $9 * $8 } END { print s }' light.csv; }
check "a lamp at twice its strength is twice its light" eval 'awk "BEGIN { d = $(light --lamps lamp=2) / $(light --lamps lamp); exit !(d > 1.9999 && d < 2.0001) }"'
check "an atlas" eval '"$radiosity" export room.prt --atlas atlas --sky 1,1,1 >out && test -s atlas/light-0.hdr'
awk '/^v/ { print $1, $2, -$4, $3; next } 1' room.obj >tall.obj
cp whole.mtl room.mtl
"$radiosity" transfer tall.obj -o tall.prt "${fine[@]}" --up z >out
check "where z is up, the same picture without --up" eval '"$radiosity" render tall.prt -o tall.png "${size[@]}" --eye 0,-7,1.5 --at 0,0,1.5 --sky ahead.hdr --turn 90 --lamps none && like tall.png turned.png 50'
check "gloss" prints '^gloss in [0-9]* squares' "$radiosity" transfer room.obj -o glossy.prt "${fine[@]}" --glossy red --gloss 0.5,60
check "... shows on the polished wall" eval '"$radiosity" render glossy.prt -o glossy.png "${at[@]}" --lamps lamp >out && lit dull.png --lamps lamp && ! like glossy.png dull.png 40'

# --- Any model, and --check ---
# foreign_room NAME: writes NAME.obj, "NAME of it.mtl" and a picture, as modelling programs export them: centimetres,
# lines that end with CR LF, quads, triangles and polygons of many points, points repeated for each object, negative
# numbers, materials that change within a group, polygons without area and twice, a lamp by Ka alone, and a picture on
# the floor
foreign_room() {
    convert -size 64x64 pattern:checkerboard -depth 8 -type TrueColor "$1.png"
    perl -e '
        print "# an exporter\nmtllib $ARGV[0] of it.mtl\no Room\n";
        my ($points, $s) = (0, 7);
        sub random { $s = ($s * 1103515245 + 12345) % 2147483648; return ($s >> 8) / 8388608 }
        # A grid of quads over a surface, all of its points given again; every fifth one as two triangles
        sub grid {
            my ($m, $n, $at, @materials) = @_;
            my $before = $points;
            for my $j (0 .. $n) { for my $i (0 .. $m) {
                printf "v %.6f %.6f %.6f\nvt %.4f %.4f\nvn 0 1 0\n", $at->($i / $m, $j / $n), $i / $m, $j / $n; ++$points } }
            for my $j (0 .. $n - 1) { for my $i (0 .. $m - 1) {
                my $k = $before + $j * ($m + 1) + $i + 1;
                my @p = ($k, $k + 1, $k + $m + 2, $k + $m + 1);
                @p = map { $_ - $points - 1 } @p if $j % 2;
                print "usemtl $materials[($i + $j) % @materials]\n" if @materials > 1 || !$i && !$j;
                my @q = map { "$_/$_/$_" } @p;
                print +($i + $j) % 5 ? "f @q\n" : "f $p[0] $p[1] $p[2]\nf $p[0]//$p[0] $p[2]//$p[2] $p[3]//$p[3]\n" } }
        }
        sub side { my ($c, $u, $v) = @_; return sub { my ($x, $y) = @_; return map { $c->[$_] + $x * $u->[$_] + $y * $v->[$_] } 0 .. 2 } }
        print "g floor walls\ns off\n";
        grid(8, 8, side([-200, 0, 200], [400, 0, 0], [0, 0, -400]), "Parquet_01");
        grid(6, 5, side([-200, 0, -200], [400, 0, 0], [0, 260, 0]), "Plaster white", "Plaster_grey");
        grid(6, 5, side([-200, 0, 200], [0, 0, -400], [0, 260, 0]), "Plaster white");
        grid(6, 5, side([200, 0, -200], [0, 0, 400], [0, 260, 0]), "Plaster_grey");
        grid(3, 3, side([-200, 260, -200], [400, 0, 0], [0, 0, 400]), "Plaster white");
        print "g\n";
        grid(1, 1, side([-40, 255, -40], [80, 0, 0], [0, 0, 80]), "Lamp.Ceiling");
        for my $k (1 .. 9) { # balls and turned boxes
            my ($x, $z, $size, $turn) = (300 * random() - 150, 300 * random() - 150, 15 + 20 * random(), 6 * random());
            print "o Thing.00$k\ns 1\n";
            if ($k % 3) {
                my ($c, $s) = ($size * cos $turn, $size * sin $turn);
                my @u = ($c, 0, $s); my @v = (-$s, 0, $c);
                grid(2, 2, side([$x, $size, $z], \@v, \@u), "Cloth");
                for my $w (0 .. 3) {
                    my @corner = ([0, 0], [1, 0], [1, 1], [0, 1])[$w, ($w + 1) % 4];
                    my ($from, $to) = map { my $p = $_; [map { ($x, 0, $z)[$_] + $p->[0] * $u[$_] + $p->[1] * $v[$_] } 0 .. 2] } @corner;
                    grid(1, 2, side($to, [map { $from->[$_] - $to->[$_] } 0 .. 2], [0, $size, 0]), "Cloth", "Plaster_grey");
                }
            } else { # with poles: triangles without area
                grid(16, 9, sub { my ($a, $b) = ($_[0] * 6.2831853, $_[1] * 3.14159265);
                    return ($x + $size * sin($b) * cos($a), 80 + $size * cos($b), $z + $size * sin($b) * sin($a)) }, "Glass-like");
            }
        }
        print "g rug\nusemtl Cloth\n"; # a polygon of twelve points
        printf "v %.4f 1 %.4f\n", 60 * cos($_ * .5235988), 60 - 60 * sin($_ * .5235988) for 0 .. 11;
        print "f -12 -11 -10 -9 -8 -7 -6 -5 -4 -3 -2 -1\nf -12 -11 -10 -9 -8 -7 -6 -5 -4 -3 -2 -1\nf -1 -1 -2\nl -1 -2\n"' "$1" |
        sed 's/$/\r/' >"$1.obj"
    printf '%s\r\n' 'newmtl Parquet_01' 'Ka 1 1 1' 'Kd 0.8 0.8 0.8' 'Ks 0.5 0.5 0.5' 'illum 2' 'map_Kd -s 4 4 1 C:\work\'"$1.png" '' 'newmtl Plaster white' 'Ns 10' \
        'Ka 0 0 0' 'Kd 0.75 0.74 0.7' 'newmtl Plaster_grey' 'Kd 0.5 0.5 0.52' 'Tf 1 1 1' 'newmtl Cloth' 'Kd 0.6 0.15 0.1' 'newmtl Lamp.Ceiling' \
        'Ka 30 28 25' 'Kd 0 0 0' 'newmtl Glass-like' 'Kd 0.2 0.4 0.6' 'd 0.3' 'Ni 1.5' >"$1 of it.mtl"
}

foreign_room foreign
check "transfer of a foreign model" eval '"$radiosity" transfer foreign.obj -o foreign.prt --element 1000 --rays 64 --check --sky east.hdr >printed 2>err'
check "... names its lamp" grep -q '^5 bands, 25 functions; lamps 1 Lamp.Ceiling$' printed
cat >notes <<'END'
radiosity: foreign.obj: material Lamp.Ceiling: its Ka is above 1 and is used as Ke
radiosity: foreign.obj: 97 triangles without area left out
radiosity: foreign.obj: 10 triangles given twice left out
radiosity: foreign.obj: coordinates of pictures are missing, and their means are used: Parquet_01
END
check "... reports what was odd, and nothing else" cmp notes err # three balls have two poles of 16 triangles
check "... and what the bands lose" grep -qE "east.hdr: 5 bands hold [0-9.]+ %" printed
errors() { awk '/^    (even|gradient|glow|two lights|random|all lamps) / { sub(/(two|all) /, ""); if ($2 > rows) rows = $2; if ($3 > most) most = $3; ++n } END { print n, rows + 0, most + 0 }' printed; }
echo "    lights, worst by rows, by clusters, %: $(errors)"
check "... six lights: rows within .01 %, clusters within 1 %" eval '[ "$(errors | awk "{ print (\$1 == 6 && \$2 <= 0.01 && \$3 <= 1) }")" = 1 ]'
# Its area, counted here: polygons are convex, and the last one of twelve points is there twice
area=$(awk '{ sub(/\r/, "") } /^v / { ++n; x[n] = $2; y[n] = $3; z[n] = $4 }
    /^f / { for (k = 2; k <= NF; ++k) { p[k] = int($k); if (p[k] < 0) p[k] += n + 1 }
        for (k = 3; k < NF; ++k) { a = p[2]; b = p[k]; c = p[k + 1]
            ux = x[b] - x[a]; uy = y[b] - y[a]; uz = z[b] - z[a]; vx = x[c] - x[a]; vy = y[c] - y[a]; vz = z[c] - z[a]
            one = sqrt((uy * vz - uz * vy) ^ 2 + (uz * vx - ux * vz) ^ 2 + (ux * vy - uy * vx) ^ 2) / 2
            all += one; if (NF == 13) twelve = 10800 } }
    END { print all - twelve }' foreign.obj)
check "a table of its light" "$radiosity" export foreign.prt --csv foreign.csv --sky 1,1,1
check "... has all of its area, $area" table foreign.csv 'a += $8; if ($9 < 0 || $9 > 50) ++off' "a > 0.999 * $area && a < 1.001 * $area && off + 0 == 0"

# Ctrl-C while it compares: the room is there
behind "$radiosity" transfer room.obj -o stopped.prt --element 0.004 --rays 128 --check
stopped_at '^processor seconds' out
check "Ctrl-C ends it with status 1" test $? = 1
check "... with one line" eval '[ "$(cat err)" = "radiosity: interrupted: the check is incomplete; stopped.prt is saved" ]'
check "... which is true" "$radiosity" render stopped.prt -o stopped.png --size 80x60

check "a material that is not there" refuses 2 "no polygon has the material gold" "$radiosity" transfer room.obj -o x.prt "${fine[@]}" --glossy gold
check "a lamp that is not there" refuses 2 "no lamp 'moon'; there are 1 lamp, 2 spot" "$radiosity" render room.prt -o x.png --lamps moon
check "options for a room with a solution" refuses 2 "is for a room that" "$radiosity" render fresh.rad -o x.png --turn 3
check "a full disk" refuses 1 "cannot write" "$radiosity" transfer room.obj -o /dev/full --element 1
check "none of them left a file" eval '! ls x.* 2>/dev/null'
finish
