# What the tracer's speed and accuracy are measured with: its quick run.
. "$(dirname "$0")/common.sh"
needs_built tradeoff
tradeoff=$BUILD/tradeoff
check "the tracer's trade is measured" "$tradeoff" trace --quick --csv "$WORK/csv" --plot "$WORK/svg"
check "... as a table" grep -qx "scene,setting,shipped,samples_per_pixel,cpu_ms,psnr_db" "$WORK/csv"
for scene in A B field point table flake patches hall odraz credits; do
    check "... with four points of $scene that ship" table "$WORK/csv" "shipped += \$1 == \"$scene\" && \$3 == 1" 'shipped == 4'
done
# decibels SCENE SETTING
decibels() { awk -F, -v s="$1" -v q="$2" '$1 == s && $2 == q { print $6 }' "$WORK/csv"; }
for scene in A B field table flake hall; do
    check "... in which film is nearer than play in $scene" less "$(decibels $scene play)" "$(decibels $scene film)"
    check "... and play than draft" less "$(decibels $scene draft)" "$(decibels $scene play)"
done
check "... and as a plot" grep -q '^<svg' "$WORK/svg"
check "... of at least fifty" test "$(grep -c '<circle' "$WORK/svg")" -ge 50
check "a scene alone" prints '^field,play,1,' "$tradeoff" trace --quick --scene field
check "an unknown scene" refuses 2 "there is no scene 'C'" "$tradeoff" trace --scene C
check "a plot that cannot be written" refuses 2 "cannot write" "$tradeoff" trace --quick --scene field --plot "$WORK/none/plot.svg"
check "peer_povray refuses scenes it does not know" refuses 2 "usage: tools/measure/peer_povray" "$SOURCE/tools/measure/peer_povray" C
if [ -x "$BUILD/bench_trace" ]; then
    check "bench_trace counts rays" prints items_per_second bash -c "exec '$BUILD/bench_trace' --benchmark_filter='^ray/.*/A$' --benchmark_min_time=0.01 2>/dev/null"
    check "... of four kinds" test "$(grep -c items_per_second "$WORK/printed")" = 4
    check "bench_trace refuses options it does not know" refuses 2 "" "$BUILD/bench_trace" --slow
else
    echo "skipped: bench_trace is not built"
fi
finish
