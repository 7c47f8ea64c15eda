# radiosity --reflectance and --power: other materials than the model's, for generate and solve.
. "$(dirname "$0")/radiosity_program.sh"

few=(--rays 32 --element 1 --residual 1e-7)

check "generate with other materials" prints polygons "$radiosity" generate cube -o bright.obj --power lamp=2 --reflectance red=0.5 --reflectance floor=.1,.2,.3
check "... has them in its file" test "$(grep -A 2 -E '^newmtl (lamp|red|floor)' bright.mtl | grep K | tr '\n' ' ')" = "Kd 0.325 0.05 0.04 Ke 0 0 0 Kd 0.1 0.2 0.3 Ke 0 0 0 Kd 0.5 0.5 0.5 Ke 40 36 30 "
"$radiosity" generate cube -o cube.obj >/dev/null
check "the others are as they were" test "$(grep -A 2 white cube.mtl)" = "$(grep -A 2 white bright.mtl)"
check "solve with these" solved bright bright.obj "${few[@]}"
check "... and with the same as options" solved options cube.obj "${few[@]}" --power lamp=2 --reflectance red=0.5 --reflectance floor=.1,.2,.3
check "... gives the same bytes" cmp bright.rad options.rad
check "as it was" solved cube cube.obj "${few[@]}"
check "... that is another solution" bash -c '! cmp -s cube.rad bright.rad'
check "all lamps of another colour" solved green cube.obj "${few[@]}" --power 0,18,0
check "... whose green is as before, without red and blue" \
    bash -c "paste -d, cube.csv green.csv | awk -F, 'NR > 1 { d = \$21 / \$10 - 1; if (d > 1e-5 || d < -1e-5 || \$20 != 0 || \$22 != 0) bad = 1 } END { exit bad || NR < 500 }'"

# scaled NAME FACTOR: everything is that many times what it is in cube.csv, to 1e-5 of the largest
scaled() {
    awk -F, -v f="$2" 'FNR == 1 { next } NR == FNR { for (k = 9; k < 12; ++k) { a[FNR, k] = $k; if ($k > most) most = $k }; next }
        { for (k = 9; k < 12; ++k) { d = $k / f - a[FNR, k]; if (d < 0) d = -d; if (d > off) off = d } ++lines }
        END { exit !(lines > 500 && off <= 1e-5 * most) }' cube.csv "$1.csv"
}
for factor in 1 3 1e-9 1e-20 1e9 1e10; do
    check "power $factor" solved power cube.obj "${few[@]}" --power $factor
    check "... gives that much light" scaled power $factor
done
check "... by hemicubes" solved power cube.obj --hemicube 16 --element 1 --power 1e-9
check "without power" solved dark cube.obj "${few[@]}" --power 0
check "... it is dark" table dark.csv 's += $9 + $10 + $11' 's == 0 && lines > 500'
check "... without an even sky" test ! -s dark.err
check "... by hemicubes" solved dark cube.obj --hemicube 16 --element 1 --power lamp=0,0,0
check "... likewise" table dark.csv 's += $9 + $10 + $11' 's == 0 && lines > 500'
check "without reflectance" solved black cube.obj "${few[@]}" --reflectance 0
check "... only the lamp is seen" table black.csv 'if ($3 < 9.99 || $2 * $2 > 1 || $4 * $4 > 1) s += $9; else { n += $9 == 20; t += 1 }' 's == 0 && n == t && n > 3'
check "a dark material gets power" solved wall cube.obj "${few[@]}" --power red=0,0,5
check "... and lights the room" table wall.csv 'if ($7 == 1 && $2 < -4) s += $11' 's > 1'

# A furnace of options: all emit 1, and E / (1 - rho) everywhere
sed 's/^usemtl .*/usemtl white/' cube.obj >furnace.obj
for way in "--rays 32" "--hemicube 16 --direct hemicube"; do
    check "a furnace that reflects .999 ($way)" solved furnace furnace.obj $way --element 4 --residual 1e-7 --power white=1,1,1 --reflectance white=0.999,0.5,0
    check "... shines by the formula" table furnace.csv 'a += $8; r += $8 * $9; g += $8 * $10; b += $8 * $11' 'r / a > 985 && r / a < 1015 && g / a > 1.99 && g / a < 2.01 && b / a > 0.9999 && b / a < 1.0001'
done

# Names as files have them
sed -i 's/^newmtl red/newmtl a wall=left/' cube.mtl
sed 's/^usemtl red/usemtl a wall=left/' cube.obj >odd.obj
check "a name with a blank and an =" solved odd odd.obj "${few[@]}" --reflectance 'a wall=left=0.5' --power lamp=2 --reflectance floor=.1,.2,.3
check "... is found" cmp odd.rad bright.rad
printf 'v 0 0 0\nv 1 0 0\nv 1 0 1\nf 3 2 1\n' >plain.obj
check "polygons without a material" solved plain plain.obj --power '(none)=1,2,3'
check "... have one named (none)" table plain.csv 'if ($9 == 1 && $10 == 2 && $11 == 3) ++n' 'n == lines'

# What is refused
for what in generate solve; do
    model=(cube.obj)
    [ $what = solve ] || model=(cube)
    check "$what: no such material" refuses 2 "no polygon has this material; there are" "$radiosity" $what "${model[@]}" -o x.obj --power sun=1,1,1
    check "... it names those that there are" grep -q "there are .*lamp" err
    check "$what: no colour" refuses 2 "radiosity: --reflectance white=1,1" "$radiosity" $what "${model[@]}" -o x.obj --reflectance white=1,1
    check "$what: no value" refuses 2 "radiosity: --reflectance" "$radiosity" $what "${model[@]}" -o x.obj --reflectance
    check "$what: more than all light" refuses 2 "white would reflect 1.5, and the most is 1" "$radiosity" $what "${model[@]}" -o x.obj --reflectance white=2
done
check "none of them left a file" test ! -e x.obj
check "view of a solution" refuses 2 "--power is an option for models" "$radiosity" view cube.rad --power 2
finish
