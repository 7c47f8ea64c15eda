# The radiosity program as its users run it: good and bad models, and results that are known.
. "$(dirname "$0")/radiosity_program.sh"
skip_unless script

for kind in cube columns corner; do
    check "generate $kind" prints polygons "$radiosity" generate $kind -o $kind.obj
    check "... whose materials are beside it" grep -q "^Ke 20 18 15" $kind.mtl
done
check "triangles of at most the area given" prints 'fine.obj: [0-9]* triangles' "$radiosity" generate cube -o fine.obj --area 0.5
check "... a hundred times as many as there were squares" test "$(grep -c '^f' fine.obj)" -ge 1200
check "solve" bash -c "'$radiosity' solve cube.obj -o cube.rad >out 2>err && [ ! -s err ]"
check "... prints elements, sites and times" bash -c "grep -q 'elements, [0-9]* sites with [0-9]* rays' out && grep -q '^processor seconds' out && grep -q 'sweeps, residual' out"
check "export as a table" "$radiosity" export cube.rad --csv cube.csv
check "... with its head" test "$(head -n 1 cube.csv)" = "polygon,x,y,z,nx,ny,nz,area,r,g,b"
check "... a line for every element" test "$(($(wc -l <cube.csv) - 1))" = "$(sed -n 's/.* \([0-9]*\) elements.*/\1/p' out)"
check "... whose areas are the model's" table cube.csv 'a += $8' 'a > 599.9 && a < 600.1'
check "... red light on the wall beside the red one, green beside the green" \
    table cube.csv 'if ($7 == 1) { if ($2 < -4) { r += $9; g += $10 } if ($2 > 4) { R += $9; G += $10 } }' 'r > 1.1 * g && r / g > 1.1 * R / G'
# ratio A B SUM LOW HIGH: a sum over the lines of table A is LOW to HIGH times that of B, the more accurate one
ratio() {
    table "$1" "s += $3" 's > 0' && table "$2" "s += $3" 's > 0' &&
        awk -F, "FNR > 1 { s[FILENAME] += $3 } END { d = s[\"$1\"] / s[\"$2\"]; exit !(d > $4 && d < $5) }" "$1" "$2"
}
check "solve it in triangles" eval 'solved fine fine.obj && grep -q triangles fine.out'
check "... the same light" ratio cube.csv fine.csv '$8 * $10' 0.999 1.001
check "export for viewers" "$radiosity" export cube.rad --ply cube.ply
check "... of two kinds" "$radiosity" export cube.rad --obj lit.obj
check "... PLY counts its points and faces" awk '/^element/ { n += $3; faces += $2 == "face" } /^end_header/ { body = NR } END { exit !(faces == 1 && n > 1000 && NR - body == n) }' cube.ply
check "... OBJ has colours" grep -qE '^v( [-0-9.e]+){6}$' lit.obj
for tone in log film; do
    check "render, tone $tone" bash -c "'$radiosity' render cube.rad -o $tone.png --eye 0,5,4.9 --at 0,4,-5 --size 160x90 --tone $tone && [ \$(od -An -tx1 -j16 -N8 $tone.png | tr -d ' ') = 000000a00000005a ]"
done

# A furnace: all surfaces emit 1 and reflect a half, so all have 2, at any size
even_furnace() { table f.csv 'if ($9 < 1.996 || $9 > 2.004 || $10 < 1.3307 || $10 > 1.336 || $11 != 1) ++off' 'off + 0 == 0'; }
for scale in 0.001 1 1000; do
    cat >furnace.mtl <<END
newmtl all
Kd 0.5 0.25 0
Ke 1 1 1
END
    awk -v s=$scale 'BEGIN {
        print "mtllib furnace.mtl\nusemtl all"
        for (k = 0; k < 8; ++k) print "v", (k % 2) * s, (int(k / 2) % 2) * s, int(k / 4) * s
        print "f 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\nf 1 2 4 3\nf 5 7 8 6" }' >furnace.obj
    check "a furnace of size $scale" solved f furnace.obj
    check "... comes out even, everywhere within .2 %" even_furnace
    check "... and by hemicubes" solved f furnace.obj --hemicube 32
    # Everything except what lies nearest to the edges
    check "... in the mean" table f.csv 'a += $8; r += $8 * $9; g += $8 * $10; b += $8 * $11' 'r / a > 1.985 && r / a < 2.015 && g / a > 1.32 && g / a < 1.347 && b / a > 0.999 && b / a < 1.001'
done

# A furnace of 84 triangles, in a room
"$radiosity" generate cube -o lit.obj --area 8.4 >/dev/null && sed -i 's/^usemtl .*/usemtl all/; s/^mtllib .*/mtllib furnace.mtl/' lit.obj
check "a furnace of many lamps" solved f lit.obj
check "... comes out even, everywhere within .2 %" even_furnace
# The same room far from the origin, where floats have only three digits for it
for far in 0 1000 20000; do
    printf 'newmtl grey\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 10 10 10\n' >far.mtl
    awk -v s=$far 'BEGIN {
        print "mtllib far.mtl\nusemtl grey"
        for (k = 0; k < 8; ++k) print "v", (k % 2) + s, (int(k / 2) % 2) + s, int(k / 4) + s
        print "f 1 5 6 2\nf 1 3 7 5\nf 2 6 8 4\nf 1 2 4 3\nf 5 7 8 6\nusemtl lamp\nf 3 4 8 7" }' >far.obj
    check "a room at $far" solved far$far far.obj
    check "... has its light" ratio far$far.csv far0.csv '$8 * $10' 0.995 1.005
done
sed 's/^v .*/&/; s/^v \([^ ]*\) \([^ ]*\) \([^ ]*\)/v \1e-15 \2e-15 \3e-15/' furnace.obj >tiny.obj
check "a model too small for floats" refuses 2 "is smaller than 1e-10: give --scale" "$radiosity" solve tiny.obj -o x.rad
printf 'newmtl all\nKd 1 1 1\nKe 1 1 1\n' >furnace.mtl
check "light that does not converge is reported" prints 'does not converge' bash -c "'$radiosity' solve lit.obj -o f.rad --rays 8 --element 40 2>&1"

# Light given by options, against closed forms
printf 'newmtl grey\nKd 0.5 0.25 0.8\nnewmtl black\nKd 0 0 0\nnewmtl old\nKd 0 0 0\nKa 3 2 1\n' >out.mtl
box='v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\nusemtl grey\nf 4 3 2 1\nusemtl black\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n'
plate='v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nusemtl grey\nf 1 2 3 4\n'
lit() { # lit MODEL OPTION...: out.csv
    local model=$1
    shift
    printf "mtllib out.mtl\n$model" >out.obj
    rm -f out.rad out.csv
    "$radiosity" solve out.obj -o out.rad "$@" >out 2>err && "$radiosity" export out.rad --csv out.csv
}
check "a sky over a box without a lid" lit "$box" --sky 1,2,3
# The form factor of two equal squares at the distance of their side is 0.19982; the rms error over the corners
floor='if ($6 == 1) { F = 0; for (i = 0; i < 4; ++i) { X = i % 2 ? $2 : 1 - $2; Y = i < 2 ? $4 : 1 - $4; p = sqrt(1 + X * X); q = sqrt(1 + Y * Y)
    F += (X / p * atan2(Y / p, 1) + Y / q * atan2(X / q, 1)) / 6.2831853 } ++n; a += $9 / 0.5; b += $10 / 0.5; c += $11 / 2.4; d = $9 / (0.5 * F) - 1; off += d * d }'
check "... lights its floor by the form factor, in three colours" table out.csv "$floor" 'a / n > 0.1988 && a / n < 0.2008 && b / a > 0.999 && b / a < 1.001 && c / a > 0.999 && c / a < 1.001'
check "... everywhere, within 2 % (rms)" table out.csv "$floor" 'sqrt(off / n) < 0.02'
check "... and notes that black walls stay black" grep -q 'material black stays black: it reflects nothing' err
even() { table out.csv "if (\$9 < 0.999 * $1 || \$9 > 1.001 * $1) ++off" 'off + 0 == 0'; }
check "a sun, 30 degrees high, from +x" lit "$plate" --sun 30,90,10,10,10
check "... gives the half of what it gives straight on" even 2.5
check "... and a second one the same again" lit "$plate" --sun 30,90,10,10,10 --sun 30,270,10,10,10
check "... together" even 5
check "a sun behind it" lit "$plate" --sun -30,90,10,10,10
check "... gives nothing" table out.csv 's += $9' 's == 0'
check "where z is up, from the zenith" lit 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl grey\nf 1 2 3 4\n' --up z --sun 90,0,10,10,10
check "... all of it" even 5
check "a lamp" lit "$plate" --lamp 0,2,0,0.2,100,100,100
check "... by its distance and angle" table out.csv 'r2 = $2 * $2 + $4 * $4 + 4; d = $9 / (0.5 * 100 * 0.01 / r2 * 2 / sqrt(r2)) - 1; if (d < -0.005 || d > 0.005) ++off' 'off + 0 == 0'
# A shining square opposite a plate: the closed form sums the form factors of rectangles with a corner above the place
printf 'newmtl panel\nKd 0 0 0\nKe 1000 1000 1000\n' >>out.mtl
panel() { # panel HALF HEIGHT
    lit "${plate}usemtl panel\nv -$1 $2 -$1\nv $1 $2 -$1\nv $1 $2 $1\nv -$1 $2 $1\nf 5 6 7 8\n"
}
below() { # below HALF HEIGHT PERCENT [COLUMN KD]: what the panel gives, everywhere
    table out.csv 'if ($6 == 1) { F = 0; for (i = 0; i < 4; ++i) { X = ('"$1"' + (i % 2 ? $2 : -$2)) / '"$2"'; Y = ('"$1"' + (i < 2 ? $4 : -$4)) / '"$2"'; p = sqrt(1 + X * X); q = sqrt(1 + Y * Y)
        F += (X / p * atan2(Y / p, 1) + Y / q * atan2(X / q, 1)) / 6.2831853 } d = $'"${4-9}"' / ('"${5-0.5}"' * 1000 * F) - 1; ++n; if (d < -0.01 * '"$3"' || d > 0.01 * '"$3"') ++off }' 'n > 1000 && off + 0 == 0'
}
check "a square that shines" panel 0.5 1
check "... everywhere by its form factor" below 0.5 1 0.5
check "... one that is near" panel 0.5 0.125
check "... near it" below 0.5 0.125 1
# A small blue lamp beneath a board, which blocks a lamp ten thousand times as bright
printf 'newmtl bright\nKd 0 0 0\nKe 1e7 1e7 1e7\nnewmtl weak\nKd 0 0 0\nKe 0 0 1000\n' >>out.mtl
check "a weak lamp in the shadow of a strong one" lit "${plate}usemtl weak\nv -.5 1 -.5\nv .5 1 -.5\nv .5 1 .5\nv -.5 1 .5\nf 5 6 7 8\nusemtl black\nv -1.5 2 -1.5\nv 1.5 2 -1.5\nv 1.5 2 1.5\nv -1.5 2 1.5\nf 9 10 11 12\nusemtl bright\nv -.2 3 -.2\nv .2 3 -.2\nv .2 3 .2\nv -.2 3 .2\nf 13 14 15 16\n"
check "... gives all of its light" below 0.5 1 1 11 0.8
check "... and the strong one none" table out.csv 'if ($6 == 1) s += $9' 's == 0'
check "... a grain of one" panel 0.0005 10
check "... far away" table out.csv 'if ($6 == 1) { r2 = $2 * $2 + $4 * $4 + 100; d = $9 / (0.5 * 1000 * 1e-6 * 100 / (3.14159265 * r2 * r2)) - 1; ++n; if (d < -0.001 || d > 0.001) ++off }' 'n > 1000 && off + 0 == 0'
check "backs are black" lit "$plate" --sun -30,90,10,10,10
check "... and with --two-sided they are not" lit "$plate" --two-sided --sun -30,90,10,10,10
check "... but as bright as fronts" table out.csv '$6 < 0 ? back += $8 * $9 : front += $8 * $9' 'back > 9.99 && back < 10.01 && front == 0'
check "--scale" lit "$plate" --scale 100
check "... makes it a hundred times as long" table out.csv 'a += $8' 'a > 39999 && a < 40001'
check "an ambient colour above 1 shines" lit "${plate/grey/old}"
check "... and is reported" grep -q 'Ka is above 1 and is used as Ke' err
check "... as bright as it is" even 3
# An even picture of 8 x 4 pixels is an even sky
{ printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n'; for _ in $(seq 32); do printf '\200\200\200\201'; done; } >even.hdr
check "a picture of the sky" lit "$plate" --sky even.hdr
check "... that is even" even 0.5
sed 's/$/\r/; s/^FORMAT/EXPOSURE=0\r\n&/; 4q' even.hdr >windows.hdr
tail -c 128 even.hdr >>windows.hdr
check "... as FreeImage and editors of Windows write it" lit "$plate" --sky windows.hdr
check "... that is even" even 0.5
{ head -c 122 even.hdr; printf '\377\377\377\377'; tail -c 60 even.hdr; } >bright.hdr # sums of it are no floats
for bad in "--sky 1,2" "--sky none.hdr" "--sky out.mtl" "--sky bright.hdr" "--sun 1,2,3,4" "--sun 1,2,3,4,x" "--sun 1,2,3,4,-5" "--lamp 0,0,0,0,1,1,1" "--up x" "--scale 0"; do
    check "$bad is refused" refuses 2 "${bad#--sky }" bash -c "'$radiosity' solve out.obj -o x.rad $bad 2>&1 >/dev/null | sed 's/^radiosity: /radiosity: $bad: /' >&2; exit \${PIPESTATUS[0]}"
done

# Without --eye and --at the camera shows all of the plate, which fills the picture; also where z is up
sees_all() { # OPTION...: nothing touches the picture's edges, and some of it comes near
    "$radiosity" render out.rad -o all.png --size 160x90 "$@" >out && grep -q '^--eye .* --at ' out &&
        [ "$(convert all.png -threshold 2% -format '%@' info: | awk -F '[x+]' '{ print ($3 > 0 && $4 > 0 && $1 + $3 < 160 && $2 + $4 < 90 && ($3 < 8 || $4 < 5 || $1 + $3 > 152 || $2 + $4 > 85)) }')" = 1 ]
}
if command -v convert >/dev/null; then
    check "a plate" lit "$plate"
    check "... is seen whole" sees_all
    check "... by a wide lens" sees_all --lens 120
    check "... by a long one" sees_all --lens 5
    check "... and the same by the place that it prints" eval '"$radiosity" render out.rad -o again.png --size 160x90 --lens 5 $(cat out) && cmp all.png again.png'
    bright() { "$radiosity" render out.rad -o all.png --size 160x90 "$@" >/dev/null && convert all.png -format '%[fx:maxima]' info:; }
    check "... brighter by two stops" less "$(bright --exposure -2)" "$(bright)"
    check "a plate where z is up" lit 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl grey\nf 1 2 3 4\n'
    check "... is seen whole" sees_all --up z
    check "a plate that faces down" lit 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl grey\nf 4 3 2 1\n'
    check "... is seen from below" sees_all --up z
fi

# Knobs
for knob in "--rays 64" "--final 64" "--hemicube 32" "--patch 2" "--element 0.05" "--bounces 3" "--residual 1e-6" "--lamp-samples 64" "--direct hemicube --hemicube 64" --adaptive "--memory 500"; do
    check "solve $knob" solved k cube.obj --element 0.2 $knob
    check "... alike" ratio k.csv cube.csv '$8 * $10' 0.93 1.02
done
check "no bounce" eval 'solved b cube.obj --bounces 0 && grep -q "^0 bounces" b.out'
check "... is direct light alone: the ceiling is dark except for its lamp, the floor is not" \
    table b.csv 'if ($6 == -1) { $9 == 0 ? ++dark : $9 >= 15 ? ++lamp : ++lit } if ($6 == 1 && $9 > 0) ++floor' 'dark > 100 && lamp > 0 && lit == 0 && floor > 100'
check "adaptive elements" solved a columns.obj --adaptive
check "... are fewer, and of several sizes" table a.csv 'size = sprintf("%.3f", $8); sizes += !seen[size]++' 'lines < 33000 && sizes > 6'
check "... and cover what uniform ones do" table a.csv 'a += $8' 'a > 4745.5 && a < 4745.7'

# Wrong use
check "a missing model" refuses 2 "cannot read" "$radiosity" solve none.obj -o x.rad
check "it prints how much memory it needs" prints 'needs about [1-9][0-9]* MB' "$radiosity" solve cube.obj -o k.rad
check "too little memory" refuses 1 "more than the 3 of --memory" "$radiosity" solve cube.obj -o x.rad --memory 3
check "no place to write" refuses 2 "cannot write" "$radiosity" solve cube.obj -o none/x.rad
check "two methods at once" refuses 2 "--rays and --patch do not go together" "$radiosity" solve cube.obj -o x.rad --rays 64 --patch 2
check "an odd hemicube" prints 'hemicubes\)' "$radiosity" solve cube.obj -o odd.rad --hemicube 25 --patch 4
check "shots instead of rows" prints '^[1-9][0-9]* shots, [0-9.e-]+ % of the light is not shot$' "$radiosity" solve cube.obj -o shot.rad --direct hemicube --patch 4 --shots 500
check "... which are followed to the residual" refuses 2 "--shots and --bounces do not go together" "$radiosity" solve cube.obj -o x.rad --shots 9 --bounces 2
check "a number out of range" refuses 2 "from 4 to 1024" "$radiosity" solve cube.obj -o x.rad --hemicube 2
check "an option's value that is no number" refuses 2 "takes a number" "$radiosity" solve cube.obj -o x.rad --patch big
check "an unknown option" refuses 2 "cannot use '--fast'" "$radiosity" solve cube.obj -o x.rad --fast
check "... of two lines, reported in one" refuses 2 "cannot use '--fa?st'" "$radiosity" solve cube.obj -o x.rad $'--fa\nst'
check "an unknown model" refuses 2 "name one of them" "$radiosity" generate sphere -o x.obj
check "no command" refuses 2 "a command is missing" "$radiosity"
check "a solution that is none" refuses 1 "was not written by" "$radiosity" export cube.obj --csv x.csv
head -c 100000 cube.rad >cut.rad
check "a solution cut short" refuses 1 "damaged" "$radiosity" export cut.rad --csv x.csv
cp cube.rad bit.rad && printf '\x55' | dd of=bit.rad bs=1 seek=200000 conv=notrunc 2>/dev/null
check "a solution with a wrong byte" refuses 1 "damaged" "$radiosity" render bit.rad -o x.png --eye 0,1,0 --at 0,0,0
check "a picture with half a camera" refuses 2 "--eye and --at go together" "$radiosity" render cube.rad -o x.png --eye 0,1,0
check "a lens that is none" refuses 2 "--lens takes a number from 1 to 170" "$radiosity" render cube.rad -o x.png --lens 180
check "a size that is none" refuses 2 "--size takes pixels" "$radiosity" render cube.rad -o x.png --eye 0,1,0 --at 1,1,0 --size big
check "a full disk" refuses 1 "cannot write" "$radiosity" export cube.rad --csv /dev/full/x.csv
"$radiosity" --help | head -n 1 >help
check "a closed pipe" grep -q "Computes the light" help

# Ctrl-C when the bar on the terminal shows that there are some rows: the result has direct light and those rows
"$radiosity" generate columns -o big.obj --area 0.5 >/dev/null
behind script -qefc "echo \$\$ >pid; exec '$radiosity' solve big.obj -o big.rad --hemicube 512" terminal </dev/null
check "it shows its progress" await grep -sqaE 'form factors +\[.*\] +[1-9][0-9]? %' terminal
kill -INT "$(cat pid)"
check "Ctrl-C ends it well" ended $pid
check "... and is reported" grep -q "stopped: direct light, and the rows of [1-9]" terminal
check "... and writes what is there" "$radiosity" export big.rad --csv big.csv
check "... all of it" table big.csv 'a += $8' 'lines > 1000 && a > 0'
finish
