# Small runs of `tradeoff` and `bench_pack`, which measure the tracer's and the packer's speed and accuracy, with one
# scene or with all.
#   tradeoff.sh BUILD [all]
. "$(dirname "$0")/common.sh"
needs_built tradeoff
skip_unless g++
tradeoff=$BUILD/tradeoff
# All scenes, and the scenes in which qualities are compared. In field, draft and play take the same samples
scenes=(A) compared=(A)
if [ "${2-}" = all ]; then
    scenes=(A B field point table flake patches hall odraz credits) compared=(A B table flake hall)
fi
quick=("$tradeoff" --width 256)
check "the tracer's trade-off is measured" \
    eval '"${quick[@]}" $([ ${#scenes[@]} -gt 1 ] || echo --scene A) >"$WORK/csv"'
check "... as a table with these columns" \
    grep -qx "scene,setting,samples_per_pixel,cpu_ms,mean_flip,linear_psnr_db,srgb_psnr_db" "$WORK/csv"
for scene in "${scenes[@]}"; do
    check "... with the qualities of $scene" test "$(grep -c "^$scene," "$WORK/csv")" = 3
done
# measured COLUMN SCENE SETTING: prints a cell
measured() { awk -F, -v column="$1" -v scene="$2" -v setting="$3" '$1 == scene && $2 == setting { print $column }' "$WORK/csv"; }
for scene in "${compared[@]}"; do
    for pair in "draft play" "play film"; do
        set -- $pair
        check "$2 is nearer to the reference than $1 in $scene: by FLIP" less "$(measured 5 $scene $2)" "$(measured 5 $scene $1)"
        check "... in linear light" less "$(measured 6 $scene $1)" "$(measured 6 $scene $2)"
        check "... and in sRGB" less "$(measured 7 $scene $1)" "$(measured 7 $scene $2)"
    done
done
mkdir "$WORK/kept"
again() {
    "${quick[@]}" --rounds 1 --scene credits --references "$WORK/kept" --setting play --setting play,grid=2,cutoff=1/64 \
        --setting level=1.5 | cut -d, -f1-3,5-
}
check "changed knobs, and a folder for references" prints '^credits,play grid=2 cutoff=1/64,4.000,' again
check "... which has the reference" test "$(stat -c %s "$WORK/kept/credits-256")" = $((256 * 144 * 3))
cp "$WORK/printed" "$WORK/first"
check "... and used again" cmp "$WORK/first" <(again)
check "level 1.5 takes fewer samples than play" \
    less "$(sed -n 's/^credits,level=1.5,\([^,]*\),.*/\1/p' "$WORK/first")" "$(sed -n 's/^credits,play,\([^,]*\),.*/\1/p' "$WORK/first")"

# (a program of a few hundred bytes, since the film takes a second)
bash "$SOURCE/packer/example/build.sh" "$BUILD/pack" "$WORK" >/dev/null
packed() { "$BUILD/bench_pack" "$@" >"$WORK/csv"; }
bytes() { sed -n '2s/^[^,]*,\([^,]*\),.*/\1/p' "$WORK/csv"; }
check "a program is packed, decoded, and measured" packed "$WORK/hello.elf"
check "... as a table" grep -qx "bytes,payload,encode_s,decode_kb_s,memory_mb" "$WORK/csv"
check "... smaller than the packed file by its headers" less "$(bytes)" "$(stat -c %s "$WORK/hello")"
ships=$(bytes)
check "... with fewer contexts" packed --contexts 4 --slots 16 "$WORK/hello.elf"
check "... with a search from arbitrary ones" packed --arbitrary --search 0.2 "$WORK/hello.elf"
check "... which are no better than those that ship" less "$ships" "$(($(bytes) + 40))"
objcopy -O binary -j .text "$BUILD/pack" "$WORK/code"
head -c 4096 "$WORK/code" >"$WORK/sample"
check "instructions alone" packed "$WORK/sample"
check "... all of them" grep -q '^4096,' "$WORK/csv"

check "an unknown knob" \
    refuses 2 "unknown knob 'colour': use one of grid" "$tradeoff" --setting play,colour=1
check "an unknown quality" refuses 2 "unknown quality 'fine'" "$tradeoff" --setting fine
check "an invalid level" refuses 2 "level" "$tradeoff" --setting level=3
check "an invalid number of contexts" refuses 2 "a multiple of 4" "$BUILD/bench_pack" --contexts 5 "$WORK/sample"
finish
