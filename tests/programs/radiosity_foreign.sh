# A model as modelling programs export them, unlike those of `generate`, for `radiosity transfer`: it is read
# whole, and its relit light equals a solution for each light.
. "$(dirname "$0")/radiosity_program.sh"
skip_unless convert perl

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
check "transfer" eval '"$radiosity" transfer foreign.obj -o foreign.prt --element 300 --rays 64 --check >printed 2>err'
check "... names its lamp" grep -q '^5 bands, 25 functions; lamps 1 Lamp.Ceiling$' printed
cat >notes <<'END'
radiosity: foreign.obj: material Lamp.Ceiling: its Ka is above 1 and is used as Ke
radiosity: foreign.obj: 97 triangles without area left out
radiosity: foreign.obj: 10 triangles given twice left out
radiosity: foreign.obj: coordinates of pictures are missing, and their means are used: Parquet_01
END
check "... reports what was odd, and nothing else" cmp notes err # three balls have two poles of 16 triangles
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

finish
