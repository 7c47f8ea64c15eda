# The programs that measure: their quick runs, and what they refuse.
. "$(dirname "$0")/common.sh"
tradeoff=$BUILD/tradeoff
[ -x "$tradeoff" ] || { echo "SKIPPED: tradeoff is not built"; exit 77; }
check "the packer's trade is measured" bash -c "'$tradeoff' pack --quick --model '$SOURCE/intro/odraz.model' --csv '$WORK/csv' --plot '$WORK/svg' '$BUILD/odraz-safe' >'$WORK/out'"
check "... as a table" grep -qx "file,setting,shipped,bytes,encode_s,decode_kb_s,memory_mb" "$WORK/csv"
check "... with one point that ships" test "$(awk -F, '$3 == 1' "$WORK/csv" | wc -l)" = 1
check "... whose size is the film's" bash -c "[ \$(awk -F, '\$3 == 1 { print \$4 }' '$WORK/csv') -le \$((\$(stat -c %s '$BUILD/odraz') - 2560)) ]"
check "... and as a plot" bash -c "grep -q '^<svg' '$WORK/svg' && [ \$(grep -c '<circle' '$WORK/svg') -ge 5 ]"
check "the tracer's trade is measured" bash -c "'$tradeoff' trace --quick --csv '$WORK/trace.csv' --plot '$WORK/trace.svg' >'$WORK/out'"
check "... as a table" grep -qx "scene,setting,shipped,samples_per_pixel,cpu_ms,psnr_db" "$WORK/trace.csv"
for scene in A B field point table flake patches hall odraz credits; do
    check "... with four points of $scene that ship" test "$(awk -F, -v s=$scene '$1 == s && $3 == 1' "$WORK/trace.csv" | wc -l)" = 4
done
# decibels SCENE SETTING
decibels() { awk -F, -v s="$1" -v q="$2" '$1 == s && $2 == q { print $6 }' "$WORK/trace.csv"; }
for scene in A B field table flake hall; do
    check "... in which film is nearer than play, and play than draft, in $scene" \
        awk "BEGIN { exit !($(decibels $scene film) > $(decibels $scene play) && $(decibels $scene play) > $(decibels $scene draft)) }"
done
check "... and as a plot" bash -c "grep -q '^<svg' '$WORK/trace.svg' && [ \$(grep -c '<circle' '$WORK/trace.svg') -ge 50 ]"
check "a scene alone" bash -c "'$tradeoff' trace --quick --scene field | grep -q '^field,play,1,'"
check "an unknown scene" refuses 2 "there is no scene 'C'" "$tradeoff" trace --scene C
check "a plot that cannot be written" refuses 2 "cannot write" "$tradeoff" trace --quick --scene field --plot "$WORK/none/plot.svg"
check "no name" refuses 2 "name what to measure: trace, radiosity, transfer or pack" "$tradeoff"
check "an unknown option" refuses 2 "cannot use '--slow'" "$tradeoff" pack --slow
check "a missing film" refuses 2 "cannot read" "$tradeoff" pack "$WORK/none"
check "a film that is none" refuses 2 "not an ELF file" "$tradeoff" pack "$SOURCE/README.md"
check "a missing model" refuses 2 "cannot read" "$tradeoff" pack --model "$WORK/none" "$BUILD/odraz-safe"
check "bench_pack refuses options it does not know" refuses 2 "usage: bench_pack" "$BUILD/bench_pack" --slow
check "peer_povray refuses scenes it does not know" refuses 2 "usage: tools/measure/peer_povray" "$SOURCE/tools/measure/peer_povray" C
if [ -x "$BUILD/bench_trace" ]; then
    check "bench_trace counts rays" bash -c "'$BUILD/bench_trace' --benchmark_filter='^ray/.*/A$' --benchmark_min_time=0.01 2>/dev/null | grep -c items_per_second | grep -qx 4"
    check "bench_trace refuses options it does not know" refuses 2 "" "$BUILD/bench_trace" --slow
else
    echo "skipped: bench_trace is not built"
fi
finish
