# `tradeoff`, which measures the speed and accuracy of the tracer, and the packer's speed and size: its quick runs, of
# one scene or of all.
#   tradeoff.sh BUILD [all]
. "$(dirname "$0")/common.sh"
needs_built tradeoff
skip_unless g++
tradeoff=$BUILD/tradeoff
# the sweep's options, its scenes, those in which qualities are compared, and the points of its plot
sweep=(--scene field) scenes=(field) apart=(field) points=5
if [ "${2-}" = all ]; then
    sweep=() scenes=(A B field point table flake patches hall odraz credits) apart=(A B field table flake hall) points=50
fi
check "the tracer's trade-off is measured" "$tradeoff" trace --quick "${sweep[@]}" --csv "$WORK/csv" --plot "$WORK/svg"
check "... as a table, its measures named" \
    grep -qx "scene,setting,shipped,samples_per_pixel,cpu_ms,mean_flip,linear_psnr_db,srgb_psnr_db,words" "$WORK/csv"
for scene in "${scenes[@]}"; do
    check "... with the points of $scene that ship" \
        table "$WORK/csv" "shipped += \$1 == \"$scene\" && \$3 == 1" 'shipped >= 3'
done
. "$SOURCE/tools/measure/tables.sh"
# measured COLUMN SCENE SETTING
measured() { csv "\$scene == \"$2\" && \$setting == \"$3\" { print \$$1 }" "$WORK/csv"; }
for scene in "${apart[@]}"; do
    for pair in "draft play" "play film"; do
        set -- $pair
        check "... in which $2 is nearer than $1 in $scene: by FLIP" \
            less "$(measured mean_flip $scene $2)" "$(measured mean_flip $scene $1)"
        check "... in linear light" less "$(measured linear_psnr_db $scene $1)" "$(measured linear_psnr_db $scene $2)"
        check "... and in sRGB" less "$(measured srgb_psnr_db $scene $1)" "$(measured srgb_psnr_db $scene $2)"
    done
done
check "... and as a plot of $points points" test "$(grep -c 'class="mark"' "$WORK/svg")" = $points
mkdir "$WORK/kept"
again() { "$tradeoff" trace --quick --scene credits --references "$WORK/kept" --setting play --setting play,grid=2,cutoff=1/64 | cut -d, -f1-4,6-; }
check "a setting of one's own, a reference to keep" \
    prints '^credits,play grid=2 cutoff=1/64,0,4.000,' again
check "... which is kept" test "$(stat -c %s "$WORK/kept/credits-256")" = $((256 * 144 * 3))
cp "$WORK/printed" "$WORK/first"
check "... and used again" cmp "$WORK/first" <(again)

# (a program of some hundred bytes, since the film takes 14 s)
bash "$SOURCE/packer/example/build.sh" "$BUILD/pack" "$WORK" >/dev/null
check "the packer's trade-off is measured" "$tradeoff" pack --quick --csv "$WORK/csv" --plot "$WORK/svg" "$WORK/hello.elf"
check "... as a table" grep -qx "file,setting,shipped,bytes,encode_s,decode_kb_s,memory_mb" "$WORK/csv"
check "... with one point that ships, smaller than the packed file by its headers" table "$WORK/csv" \
    'if ($3 == 1) { ++shipped; bytes = $4 }' "shipped == 1 && bytes > 50 && bytes < $(stat -c %s "$WORK/hello")"
check "... and as a plot of five points" test "$(grep -c 'class="mark"' "$WORK/svg")" = 5

check "a knob that is not there" \
    refuses 2 "there is no knob 'colour'; there are: grid" "$tradeoff" trace --setting play,colour=1
check "a program that is none" refuses 2 "not an ELF file" "$tradeoff" pack "$SOURCE/README.md"
finish
