# `tradeoff trace`, which measures the tracer's speed and accuracy: its quick run, of two scenes or of all.
#   tradeoff_trace.sh BUILD [all]
. "$(dirname "$0")/common.sh"
needs_built tradeoff
tradeoff=$BUILD/tradeoff
# the sweep's options, its scenes, those in which qualities are compared, and the points of its plot
sweep=(--scene A --scene table) scenes=(A table) apart=(A table) points=10
if [ "${2-}" = all ]; then
    sweep=() scenes=(A B field point table flake patches hall odraz credits) apart=(A B field table flake hall) points=50
fi
check "the tracer's trade-off is measured" "$tradeoff" trace --quick "${sweep[@]}" --csv "$WORK/csv" --plot "$WORK/svg"
check "... as a table, its measures named" \
    grep -qx "scene,camera,setting,shipped,samples_per_pixel,cpu_ms,mean_flip,linear_psnr_db,srgb_psnr_db,words" "$WORK/csv"
check "... its settings in words, to be counted" grep -qE ',play grid=1$' "$WORK/csv"
for scene in "${scenes[@]}"; do
    check "... with the points of $scene that ship" \
        table "$WORK/csv" "shipped += \$1 == \"$scene\" && \$4 == 1" 'shipped >= 3'
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
check "... and as a plot" grep -q '^<svg' "$WORK/svg"
check "... of at least $points" test "$(grep -c 'class="mark"' "$WORK/svg")" -ge $points
check "... each with its name" test "$(grep -c 'class="name"' "$WORK/svg")" = "$(grep -c 'class="mark"' "$WORK/svg")"
check "a scene alone" prints '^field,0,play,1,' "$tradeoff" trace --quick --scene field
mkdir "$WORK/kept"
again() { "$tradeoff" trace --quick --scene credits/1 --references "$WORK/kept" --setting play --setting play,grid=2,cutoff=1/64 | cut -d, -f1-5,7-; }
check "another camera, a setting of one's own, a reference to keep" \
    prints '^credits,1,play grid=2 cutoff=1/64,0,4.000,' again
check "... named after both" test -s "$WORK/kept/credits-1-256"
check "... which is kept" test "$(stat -c %s "$WORK/kept"/*)" = $((256 * 144 * 3))
cp "$WORK/printed" "$WORK/first"
check "... and used again" cmp "$WORK/first" <(again)
check "a camera that is not there" refuses 2 "cameras are 0 to 2" "$tradeoff" trace --scene A/3
check "a knob that is not there" \
    refuses 2 "there is no knob 'colour'; there are: grid" "$tradeoff" trace --setting play,colour=1
check "a value that is none" refuses 2 "'1/x' is no value of cutoff" "$tradeoff" trace --setting play,cutoff=1/x
check "a quality that is not there" refuses 2 "there is no quality 'fast'" "$tradeoff" trace --setting fast
check "an unknown scene" refuses 2 "there is no scene 'C'" "$tradeoff" trace --scene C
check "a plot that cannot be written" \
    refuses 2 "cannot write" "$tradeoff" trace --quick --scene field --plot "$WORK/none/plot.svg"
check "peer_povray refuses scenes it does not know" \
    refuses 2 "usage: tools/measure/bench/peer_povray" "$SOURCE/tools/measure/bench/peer_povray" C
finish
