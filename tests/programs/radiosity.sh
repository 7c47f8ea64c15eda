# The radiosity program as its users run it: models and their materials, solutions against closed forms, exports, the
# camera, progress and Ctrl-C.
. "$(dirname "$0")/radiosity_program.sh"
skip_unless script convert

# --- A model, its solution, and exports ---
check "generate" prints polygons "$radiosity" generate cube -o cube.obj
check "... with other materials" prints polygons "$radiosity" generate cube -o bright.obj --power lamp=2 --reflectance red=0.5 --reflectance floor=.1,.2,.3
check "... has them in its file" test "$(grep -A 2 -E '^newmtl (lamp|red|floor)' bright.mtl | grep K | tr '\n' ' ')" = "Kd 0.325 0.05 0.04 Ke 0 0 0 Kd 0.1 0.2 0.3 Ke 0 0 0 Kd 0.5 0.5 0.5 Ke 40 36 30 "
few=(--rays 64 --element 0.25)
check "solve" solved cube cube.obj "${few[@]}"
check "... prints elements, sites, sweeps and memory, and nothing on stderr" eval 'grep -q "elements; [0-9]* sites (their corners) with [0-9]* rays" cube.out && grep -q "sweeps, residual" cube.out && grep -qE "needs about [1-9][0-9]* MB" cube.out && [ ! -s cube.err ]'
check "... a table with its head" test "$(head -n 1 cube.csv)" = "polygon,x,y,z,nx,ny,nz,area,r,g,b,material"
check "... a line for every element" test "$(($(wc -l <cube.csv) - 1))" = "$(sed -n 's/.* \([0-9]*\) elements.*/\1/p' cube.out)"
check "... whose areas are the model's" table cube.csv 'a += $8' 'a > 599.9 && a < 600.1'
check "... red light on the wall next to the red one, green next to the green" \
    table cube.csv 'if ($7 == 1) { if ($2 < -4) { r += $9; g += $10 } if ($2 > 4) { R += $9; G += $10 } }' 'r > 1.1 * g && r / g > 1.1 * R / G'
check "the other materials as options" eval 'solved bright bright.obj "${few[@]}" && solved options cube.obj "${few[@]}" --power lamp=2 --reflectance red=0.5 --reflectance floor=.1,.2,.3'
check "... give the same bytes" cmp bright.rad options.rad
# ratio A B LOW HIGH: succeeds if the light of table A is LOW to HIGH times the light of table B
ratio() { awk -F, "FNR > 1 { s[FILENAME] += \$8 * \$10 } END { d = s[\"$1\"] / s[\"$2\"]; exit !(d > $3 && d < $4) }" "$1" "$2"; }
check "100 times the triangles" prints 'fine.obj: [0-9]* triangles' "$radiosity" generate cube -o fine.obj --area 0.5
check "... give the same light" eval 'test "$(grep -c ^f fine.obj)" -ge 1200 && solved fine fine.obj "${few[@]}" && ratio cube.csv fine.csv 0.99 1.01'
for knobs in "--final 64 --memory 500 --lamp-samples 64" "--hemicube 32 --patch 2 --residual 1e-6" "--direct hemicube --hemicube 25 --patch 4" "--direct hemicube --patch 4 --shots 500"; do
    check "solve $knobs" solved k cube.obj "${few[@]:2}" $knobs
    check "... gives about the same light" ratio k.csv cube.csv 0.93 1.02
done
check "without bounces" solved b cube.obj --element 0.25 --bounces 0
check "... is direct light alone: the ceiling is dark except for its lamp, the floor is not" \
    table b.csv 'if ($6 == -1) { $9 == 0 ? ++dark : $9 >= 15 ? ++lamp : ++lit } if ($6 == 1 && $9 > 0) ++floor' 'dark > 100 && lamp > 0 && lit == 0 && floor > 100'
check "export for viewers" eval '"$radiosity" export cube.rad --ply cube.ply && "$radiosity" export cube.rad --obj lit.obj'
check "... PLY counts its points and faces" awk '/^element/ { n += $3; faces += $2 == "face" } /^end_header/ { body = NR } END { exit !(faces == 1 && n > 1000 && NR - body == n) }' cube.ply
check "... OBJ has colours" grep -qE '^v( [-0-9.e]+){6}$' lit.obj
for tone in log film; do
    check "render, tone $tone" bash -c "'$radiosity' render cube.rad -o $tone.png --eye 0,5,4.9 --at 0,4,-5 --size 160x90 --tone $tone && [ \$(od -An -tx1 -j16 -N8 $tone.png | tr -d ' ') = 000000a00000005a ]"
done

# --- Closed forms: first against the means that solve prints for two example models, then for small models ---
check "polygons have the name of their material" grep -qE '^0,-.*,floor$' cube.csv
mean() { # mean KIND MATERIAL LEAST MOST OPTION...: succeeds if the material's mean is within these limits
    "$radiosity" generate $1 -o known.obj >/dev/null && "$radiosity" solve known.obj -o known.rad --element 0.004 "${@:5}" >means 2>/dev/null &&
        awk -v name=$2 -v least=$3 -v most=$4 '$1 == name { for (i = 4; i <= 6; ++i) good += $i >= least && $i <= most } END { exit good != 3 }' means
}
check "a furnace" mean furnace furnace 1.999 2.001
check "... that reflects a tenth" mean furnace furnace 1.110 1.112 --reflectance furnace=0.2
check "two squares" mean squares receives 0.198 0.2015
check "... by hemicubes" mean squares receives 0.198 0.2015 --hemicube 100
cat >out.mtl <<'END'
newmtl grey
Kd 0.5 0.25 0.8
newmtl black
Kd 0 0 0
newmtl old
Kd 0 0 0
Ka 3 2 1
newmtl all
Kd 0.5 0.25 0
Ke 1 1 1
newmtl panel
Kd 0 0 0
Ke 1000 1000 1000
newmtl bright
Kd 0 0 0
Ke 1e7 1e7 1e7
newmtl weak
Kd 0 0 0
Ke 0 0 1000
END
points='v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\n'
box="${points}usemtl grey\nf 4 3 2 1\nusemtl black\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n"
plate='v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nusemtl grey\nf 1 2 3 4\n'
element=0.004
lit() { # lit MODEL OPTION...: solves the model, and writes out.csv
    printf "mtllib out.mtl\n$1" >out.obj
    solved out out.obj --element $element "${@:2}"
}
even() { table out.csv "if (\$9 < 0.999 * $1 || \$9 > 1.001 * $1) ++off" 'off + 0 == 0'; }
# A furnace: all surfaces emit 1 and reflect a half, so their radiance is 2, at any size
furnace="usemtl all\nf 4 3 2 1\nf 6 7 8 5\nf 2 6 5 1\nf 4 8 7 3\nf 5 8 4 1\nf 3 7 6 2\n"
check "a furnace of a millimetre" eval 'printf "mtllib out.mtl\n${points//1/0.001}$furnace" >out.obj; solved out out.obj --element 4e-9'
check "... has the same light everywhere, within .2 %" table out.csv 'if ($9 < 1.996 || $9 > 2.004 || $10 < 1.3307 || $10 > 1.336 || $11 != 1) ++off' 'off + 0 == 0'
check "... and of a kilometre, by hemicubes" eval 'printf "mtllib out.mtl\n${points//1/1000}$furnace" >out.obj; solved out out.obj --element 4000 --patch 10000 --hemicube 32'
# (near edges hemicubes are less exact)
check "... in the mean" table out.csv 'a += $8; r += $8 * $9; g += $8 * $10; b += $8 * $11' 'r / a > 1.985 && r / a < 2.015 && g / a > 1.32 && g / a < 1.347 && b / a > 0.999 && b / a < 1.001'
check "a sky over a box without a lid" lit "$box" --sky 1,2,3
# The form factor of two equal squares at the distance of their side is 0.19982. The rms error is over all elements
floor='if ($6 == 1) { F = 0; for (i = 0; i < 4; ++i) { X = i % 2 ? $2 : 1 - $2; Y = i < 2 ? $4 : 1 - $4; p = sqrt(1 + X * X); q = sqrt(1 + Y * Y)
    F += (X / p * atan2(Y / p, 1) + Y / q * atan2(X / q, 1)) / 6.2831853 } ++n; a += $9 / 0.5; b += $10 / 0.5; c += $11 / 2.4; d = $9 / (0.5 * F) - 1; off += d * d }'
check "... lights its floor by the form factor, in three colours, everywhere within 3 % (rms)" table out.csv "$floor" 'a / n > 0.197 && a / n < 0.203 && b / a > 0.999 && b / a < 1.001 && c / a > 0.999 && c / a < 1.001 && sqrt(off / n) < 0.03'
check "... and notes that black walls stay black" grep -q 'material black stays black: it reflects nothing' out.err
check "a sun behind a plate, with --two-sided" lit "$plate" --two-sided --sun -30,90,10,10,10
check "... lights the back, as bright as fronts, and not the front" table out.csv '$6 < 0 ? back += $8 * $9 : front += $8 * $9' 'back > 9.99 && back < 10.01 && front == 0'
check "a lamp" lit "$plate" --lamp 0,2,0,0.2,100,100,100
check "... by its distance and angle" table out.csv 'r2 = $2 * $2 + $4 * $4 + 4; d = $9 / (0.5 * 100 * 0.01 / r2 * 2 / sqrt(r2)) - 1; if (d < -0.01 || d > 0.01) ++off' 'off + 0 == 0'
check "an ambient colour above 1" lit "${plate/grey/old}" --scale 10
check "... is reported, and shines" eval 'grep -q "Ka is above 1 and is used as Ke" out.err && even 3'
check "... --scale makes it ten times as long" table out.csv 'a += $8' 'a > 399.9 && a < 400.1'
# Parallel plates: the closed form sums the form factors of rectangles with a corner above the point
opposite() { # opposite HALF HEIGHT PERCENT COLUMN KD: all elements must have the light of a square lamp within PERCENT
    table out.csv 'if ($6 == 1) { F = 0; for (i = 0; i < 4; ++i) { X = ('"$1"' + (i % 2 ? $2 : -$2)) / '"$2"'; Y = ('"$1"' + (i < 2 ? $4 : -$4)) / '"$2"'; p = sqrt(1 + X * X); q = sqrt(1 + Y * Y)
        F += (X / p * atan2(Y / p, 1) + Y / q * atan2(X / q, 1)) / 6.2831853 } d = $'"$4"' / ('"$5"' * 1000 * F) - 1; ++n; if (d < -0.01 * '"$3"' || d > 0.01 * '"$3"') ++off }' 'n > 900 && off + 0 == 0'
}
element=0.0002
check "an emitting square near a plate" lit "${plate}usemtl panel\nv -.5 .125 -.5\nv .5 .125 -.5\nv .5 .125 .5\nv -.5 .125 .5\nf 5 6 7 8\n"
check "... everywhere by its form factor" opposite 0.5 0.125 1 9 0.5
# A small blue lamp beneath a board, which blocks a lamp that is ten thousand times brighter
check "a weak lamp in the shadow of a strong one" lit "${plate}usemtl weak\nv -.5 1 -.5\nv .5 1 -.5\nv .5 1 .5\nv -.5 1 .5\nf 5 6 7 8\nusemtl black\nv -1.5 2 -1.5\nv 1.5 2 -1.5\nv 1.5 2 1.5\nv -1.5 2 1.5\nf 9 10 11 12\nusemtl bright\nv -.2 3 -.2\nv .2 3 -.2\nv .2 3 .2\nv -.2 3 .2\nf 13 14 15 16\n"
check "... gives all of its light" opposite 0.5 1 1 11 0.8
check "... and the strong one none" table out.csv 'if ($6 == 1) s += $9' 's == 0'

# --- Without --eye and --at the camera shows all of a plate, which fills the picture; also where z is up ---
sees_all() { # sees_all OPTION...: the plate touches no edge of the picture, and comes near one
    "$radiosity" render plate.rad -o all.png --size 160x90 "$@" >out && grep -q '^--eye .* --at ' out &&
        [ "$(convert all.png -threshold 2% -format '%@' info: | awk -F '[x+]' '{ print ($3 > 0 && $4 > 0 && $1 + $3 < 160 && $2 + $4 < 90 && ($3 < 8 || $4 < 5 || $1 + $3 > 152 || $2 + $4 > 85)) }')" = 1 ]
}
lit "$plate" && cp out.rad plate.rad
check "a wide lens shows all of a plate" sees_all --lens 120
check "... and so does a long one" sees_all --lens 5
check "... and the camera that it prints makes the same picture" eval '"$radiosity" render plate.rad -o again.png --size 160x90 --lens 5 $(cat out) && cmp all.png again.png'
lit 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl grey\nf 4 3 2 1\n' && cp out.rad plate.rad
check "... where z is up and it faces down" sees_all --up z
bright() { "$radiosity" render cube.rad -o all.png --size 160x90 "$@" >/dev/null && convert all.png -format '%[fx:mean]' info:; }
check "a picture is brighter by two stops" less "$(bright --exposure -2)" "$(bright)"

# --- Wrong use ---
check "too little memory" refuses 1 "more than the 3 of --memory" "$radiosity" solve cube.obj -o x.rad --memory 3
check "two methods at once" refuses 2 "--rays and --patch do not go together" "$radiosity" solve cube.obj -o x.rad --rays 64 --patch 2
head -c 100000 cube.rad >cut.rad
check "a solution cut short" refuses 1 "damaged" "$radiosity" export cut.rad --csv x.csv
# No output may replace an input, by whatever name, nor a model, from which the solution may have been made
printf 'newmtl m\nKd .5 .5 .5\nmap_Kd kd.ppm\nmap_bump -bm 1 bump.ppm\n' >in.mtl
printf 'mtllib in.mtl\nv 0 0 0\nv 1 0 0\nv 1 0 -1\nusemtl m\nf 1 2 3\n' >in.obj
printf '{"asset":{"version":"2.0"},"images":[{"uri":"kd.ppm"}],"buffers":[{"uri":"in.obj","byteLength":9}]}' >in.gltf
printf 'P6 2 1 255 abcdef' | tee kd.ppm bump.ppm >sky.ppm
cp cube.rad in.rad && ln -s in.rad in.link && ln -s in.obj soft && ln in.obj hard && cksum in.* soft hard ./*.ppm cube.obj >before
while read -r words; do
    check "refused: $words" refuses 2 "would be overwritten" "$radiosity" $words
done <<'END'
solve in.obj -o in.obj
solve in.obj -o soft
solve soft -o hard
solve in.obj -o ./in.mtl
solve in.obj -o kd.ppm
transfer in.obj -o bump.ppm
transfer in.obj --check --sky sky.ppm -o sky.ppm
solve in.gltf -o kd.ppm
solve in.obj --sky sky.ppm -o sky.ppm
export in.rad --csv in.rad
export in.rad --obj cube.obj
render in.rad -o in.link
render in.link -o soft
END
check "... and nothing was overwritten" cmp before <(cksum in.* soft hard ./*.ppm cube.obj)
check "... but a later export replaces an earlier one" eval '"$radiosity" export cube.rad --obj lit.obj && grep -q "^f" lit.obj'

# Outputs may be pipes and open descriptors
check "a pipe as standard output" cmp cube.csv <("$radiosity" export cube.rad --csv /dev/stdout | cat)
check "... as another descriptor" cmp cube.csv <({ "$radiosity" export cube.rad --csv /dev/fd/3 3>&1 >&2; } | cat)
mkfifo pipe
cat pipe >piped &
check "... a named pipe, which stays one" eval '"$radiosity" export cube.rad --csv pipe && wait $! && cmp piped cube.csv && [ -p pipe ]'
check "a file that is appended to" eval 'echo first >appended && "$radiosity" export cube.rad --csv /dev/stdout >>appended && cmp appended <(echo first; cat cube.csv)'
check "a picture into a pipe" cmp film.png <("$radiosity" render cube.rad -o /dev/stdout --eye 0,5,4.9 --at 0,4,-5 --size 160x90 --tone film | cat)
check "a solution into a pipe, which keeps no state" eval '"$radiosity" solve cube.obj "${few[@]}" --keep-every 0.01 -o /dev/stdout 2>out >piped && cmp piped cube.rad && grep -q "^needs about" out && ! ls /dev/fd/*.state /dev/*.state 2>/dev/null'
check "a descriptor that is closed" refuses 2 "cannot write /dev/fd/9: Bad file descriptor" "$radiosity" export cube.rad --csv /dev/fd/9
check "a file beyond the limit" refuses 1 "cannot write x.csv: File too large" bash -c "ulimit -f 8; exec '$radiosity' export cube.rad --csv x.csv"
check "... leaves no half-written file" eval '! ls | grep -E "^x.csv|part$"'
"$radiosity" --help | head -n 1 >help
check "a closed pipe" grep -q "Computes the light" help

# --- Progress: lines for scripts, a bar on a terminal ---
check "with --progress" solved again cube.obj "${few[@]:2}" --final 8 --progress
check "... every line has the same form, and every step ends once and never goes back" awk '!/^progress: (dividing|form factors|direct light|solving|final rays) [0-9]+ %(, residual [-+0-9.e]+)?(, [0-9]+ s left)?$/ { bad = 1 }
    { n = $0; sub(/ %.*/, "", n); sub(/.* /, "", n); s = $0; sub(/ [0-9]+ %.*/, "", s); if (n + 0 < was[s]) bad = 1; was[s] = n + 0; ends[s] += / 100 %/ }
    END { for (s in ends) { ++steps; if (ends[s] != 1) bad = 1 } exit bad || steps != 5 || NR > 200 }' again.err
# Ctrl-C when the bar on the terminal shows that some rows are done: the result has direct light and those rows
"$radiosity" generate columns -o big.obj --area 0.5 >/dev/null
interrupted() { # fails if the program ended first: then it is tried again
    in_background script -qefc "echo \$\$ >pid; exec '$radiosity' solve big.obj -o big.rad --hemicube 512" terminal </dev/null
    await eval "grep -sqaE 'form factors +\[.*\] +[1-9][0-9]? %' terminal || gone $pid"
    kill -INT "$(cat pid)" 2>/dev/null
    ended $pid && grep -q "stopped: direct light, and the rows of [1-9]" terminal
}
check "a terminal shows a bar; Ctrl-C ends the program, and is reported" await interrupted
check "... and the light so far is written" "$radiosity" export big.rad --csv big.csv
check "... all of it" table big.csv 'a += $8' 'lines > 1000 && a > 0'
finish
