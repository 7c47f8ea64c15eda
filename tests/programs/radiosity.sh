# The radiosity program, as its users run it: models good and bad, and numbers that are known.
. "$(dirname "$0")/common.sh"
radiosity=$BUILD/radiosity
[ -x "$radiosity" ] || { echo "SKIPPED: radiosity is not built"; exit 77; }
cd "$WORK" || exit 1

for kind in cube columns corner; do
    check "generate $kind" bash -c "'$radiosity' generate $kind -o $kind.obj >out && grep -q polygons out"
    check "... whose materials are beside it" grep -q "^Ke 20 18 15" $kind.mtl
done
check "triangles of at most the area asked" bash -c "'$radiosity' generate cube -o fine.obj --area 0.5 >out && grep -q 'fine.obj: [0-9]* triangles' out"
check "... a hundred times as many as there were squares" test "$(grep -c '^f' fine.obj)" -ge 1200
check "solve" bash -c "'$radiosity' solve cube.obj -o cube.rad >out 2>err && [ ! -s err ]"
check "... tells patches, elements and times" bash -c "grep -q 'patches, [0-9]* elements' out && grep -q '^processor seconds' out && grep -q 'sweeps, residual' out"
check "export as a table" "$radiosity" export cube.rad --csv cube.csv
check "... with its head" test "$(head -n 1 cube.csv)" = "polygon,x,y,z,nx,ny,nz,area,r,g,b"
check "... a line for every element" test "$(($(wc -l <cube.csv) - 1))" = "$(sed -n 's/.* \([0-9]*\) elements/\1/p' out)"
check "... whose areas are the model's" awk -F, 'NR > 1 { a += $8 } END { exit !(a > 599.9 && a < 600.1) }' cube.csv
check "... red light on the wall beside the red one, green beside the green" \
    awk -F, 'NR > 1 && $7 == 1 { if ($2 < -4) { r += $9; g += $10 } if ($2 > 4) { R += $9; G += $10 } } END { exit !(r > 1.1 * g && r / g > 1.1 * R / G) }' cube.csv
check "a model in triangles is the same" bash -c "'$radiosity' solve fine.obj -o fine.rad >/dev/null && '$radiosity' export fine.rad --csv fine.csv && cmp -s cube.csv fine.csv || awk -F, 'FNR > 1 { s[FILENAME] += \$8 * \$10 } END { d = s[\"cube.csv\"] / s[\"fine.csv\"]; exit !(d > 0.999 && d < 1.001) }' cube.csv fine.csv"
check "export for viewers" bash -c "'$radiosity' export cube.rad --ply cube.ply && '$radiosity' export cube.rad --obj lit.obj"
check "... PLY counts its points and faces" bash -c "head -n 13 cube.ply | grep -q 'element face' && [ \$(awk '/^end_header/ { body = 1; next } body' cube.ply | wc -l) = \$(awk '/^element/ { n += \$3 } END { print n }' cube.ply) ]"
check "... OBJ has colours" grep -qE '^v( [-0-9.e]+){6}$' lit.obj
for tone in log film; do
    check "render, tone $tone" bash -c "'$radiosity' render cube.rad -o $tone.png --eye 0,5,4.9 --at 0,4,-5 --size 160x90 --tone $tone && [ \$(od -An -tx1 -j16 -N8 $tone.png | tr -d ' ') = 000000a00000005a ]"
done

# A furnace: everything shines with 1 and reflects a half, so everything has 2, at any size
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
    check "a furnace of size $scale" bash -c "'$radiosity' solve furnace.obj -o f.rad --hemicube 64 >/dev/null && '$radiosity' export f.rad --csv f.csv"
    # Everything but what is nearest to the edges, where light comes from a hair's breadth
    check "... comes out even" awk -F, -v s=$scale 'NR > 1 { a += $8; r += $8 * $9; g += $8 * $10; b += $8 * $11 } END { r /= a; g /= a; b /= a; exit !(r > 1.985 && r < 2.015 && g > 1.32 && g < 1.347 && b > 0.999 && b < 1.001) }' f.csv
done

# Knobs
for knob in "--hemicube 32" "--patch 2" "--element 0.05" "--bounces 3" "--residual 1e-6" "--lamp-samples 64" "--direct hemicube --hemicube 64" --adaptive "--memory 500"; do
    check "solve $knob" bash -c "'$radiosity' solve cube.obj -o k.rad $knob >out && '$radiosity' export k.rad --csv k.csv && awk -F, 'FNR > 1 { s[FILENAME] += \$8 * \$10; n[FILENAME] += \$8 } END { d = s[\"k.csv\"] / s[\"cube.csv\"]; exit !(d > 0.93 && d < 1.02) }' cube.csv k.csv"
done
check "no bounce is direct light alone" bash -c "'$radiosity' solve cube.obj -o b.rad --bounces 0 >/dev/null && '$radiosity' export b.rad --csv b.csv && awk -F, 'NR > 1 && \$6 == -1 && \$9 < 15 && \$9 > 0 { exit 1 }' b.csv"
check "adaptive elements are fewer, and of several sizes" bash -c "'$radiosity' solve columns.obj -o a.rad --adaptive >out && '$radiosity' export a.rad --csv a.csv && [ \$(wc -l <a.csv) -lt 33000 ] && [ \$(awk -F, 'NR > 1 { printf \"%.3f\n\", \$8 }' a.csv | sort -u | wc -l) -gt 6 ]"
check "... and cover what uniform ones do" awk -F, 'NR > 1 { a += $8 } END { exit !(a > 4745.5 && a < 4745.7) }' a.csv

# Models that are not as they should be
plain='usemtl m\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\n'
printf 'newmtl m\nKd 0.5 0.5 0.5\nnewmtl l\nKe 5 5 5\n' >m.mtl
model() { printf "mtllib ${2:-m.mtl}\n$plain$1" >m.obj; }
solves() { timeout 60 "$radiosity" solve m.obj -o m.rad >out 2>err && "$radiosity" export m.rad --csv m.csv && ! grep -qi nan m.csv; }
model 'f 1 4 3 2\nusemtl l\nf 5 6 7 8\n'
check "open, with holes all around" solves
model 'f 1 4 3 2\nf 1 4 3 2\nf 4 3 2 1\nusemtl l\nf 5 6 7 8\n'
check "polygons given twice" bash -c "$(declare -f solves); radiosity='$radiosity'; solves && grep -q 'given twice' err"
model 'v 0.5 0 0\nf 1 9 2\nf 1 1 2\nf 1 4 3 2\nusemtl l\nf 5 6 7 8\n'
check "polygons without area" bash -c "$(declare -f solves); radiosity='$radiosity'; solves && grep -q 'without area' err"
model 'v 0.5 0.000002 0.5\nv 1.2 0.5 0.0001\nf 1 2 9\nf 2 10 1\nf 1 4 3 2\nusemtl l\nf 5 6 7 8\n'
check "slivers" solves
model 'v 0.5 0 0.3\nf 1 4 9 3 2\nusemtl l\nf 5 6 7 8\n'
check "a polygon that is not convex" solves
model 'f 1 4 3 2\n'
check "nothing that shines" refuses 2 "nothing shines" "$radiosity" solve m.obj -o x.rad
model 'f 1 4 3 2\nusemtl l\nf 5 6 7 8\n' none.mtl
timeout 60 "$radiosity" solve m.obj -o x.rad >out 2>err
check "materials that are missing" bash -c "[ $? = 2 ] && grep -q 'materials cannot be read' err && grep -q 'nothing shines' err"
model 'v 1 nan 0\nf 1 4 3 2\nusemtl l\nf 5 6 7 8\n'
check "NaN, with its line" refuses 2 "m.obj:11: a coordinate is not a number" "$radiosity" solve m.obj -o x.rad
model 'v 1 x 0\nf 1 4 3 2\n'
check "no number, with its line" refuses 2 "m.obj:11: a point needs three" "$radiosity" solve m.obj -o x.rad
model 'f 1 4 3 2\nf 1 2 99\n'
check "a point that is not there, with its line" refuses 2 "m.obj:12: there is no point 99" "$radiosity" solve m.obj -o x.rad
model 'f 1 4\n'
check "a polygon of two points, with its line" refuses 2 "m.obj:11: a polygon needs three" "$radiosity" solve m.obj -o x.rad
model 'f 1 1 1\n'
check "nothing with an area" refuses 2 "holds no polygon" "$radiosity" solve m.obj -o x.rad
printf 'newmtl m\nKd 2 0 0\n' >bad.mtl
model 'f 1 4 3 2\n' bad.mtl
check "a reflectance above 1" refuses 2 "Kd must lie between 0 and 1" "$radiosity" solve m.obj -o x.rad
check "none of them left a file" test ! -e x.rad

# What else users do
check "a missing model" refuses 2 "cannot read" "$radiosity" solve none.obj -o x.rad
check "too little memory" refuses 1 "more than the 3 of --memory" "$radiosity" solve cube.obj -o x.rad --memory 3
check "no place to write" refuses 2 "cannot write" "$radiosity" solve cube.obj -o none/x.rad
check "an odd hemicube" refuses 2 "even number" "$radiosity" solve cube.obj -o x.rad --hemicube 25
check "a number out of range" refuses 2 "from 4 to 1024" "$radiosity" solve cube.obj -o x.rad --hemicube 2
check "no number" refuses 2 "takes a number" "$radiosity" solve cube.obj -o x.rad --patch big
check "an unknown option" refuses 2 "cannot use '--fast'" "$radiosity" solve cube.obj -o x.rad --fast
check "an unknown model" refuses 2 "name one of them" "$radiosity" generate sphere -o x.obj
check "no command" refuses 2 "say what to do" "$radiosity"
check "a solution that is none" refuses 1 "was not written by" "$radiosity" export cube.obj --csv x.csv
head -c 100000 cube.rad >cut.rad
check "a solution cut short" refuses 1 "damaged" "$radiosity" export cut.rad --csv x.csv
cp cube.rad bit.rad && printf '\x55' | dd of=bit.rad bs=1 seek=200000 conv=notrunc 2>/dev/null
check "a solution with a wrong byte" refuses 1 "damaged" "$radiosity" render bit.rad -o x.png --eye 0,1,0 --at 0,0,0
check "a picture without a camera" refuses 2 "render needs" "$radiosity" render cube.rad -o x.png
check "a size that is none" refuses 2 "--size takes pixels" "$radiosity" render cube.rad -o x.png --eye 0,1,0 --at 1,1,0 --size big
check "a full disk" refuses 1 "cannot write" "$radiosity" export cube.rad --csv /dev/full/x.csv
check "a closed pipe" bash -c "'$radiosity' --help | head -n 1 | grep -q usage"

# Ctrl-C: direct light and the rows that are there
"$radiosity" generate columns -o big.obj --area 0.5 >/dev/null
"$radiosity" solve big.obj -o big.rad --hemicube 512 >out 2>err &
PIDS+=($!)
sleep 3
kill -INT ${PIDS[-1]}
wait ${PIDS[-1]}
check "Ctrl-C ends it well" test $? = 0
check "... and says so" grep -q "stopped: direct light, and the rows of [1-9]" out
check "... and writes what is there" bash -c "'$radiosity' export big.rad --csv big.csv && [ \$(wc -l <big.csv) -gt 1000 ] && ! grep -qi nan big.csv"
finish
