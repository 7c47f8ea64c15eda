# What radiosity's speed and accuracy are measured with: its quick run.
. "$(dirname "$0")/common.sh"
tradeoff=$BUILD/tradeoff
[ -x "$tradeoff" ] || { echo "SKIPPED: tradeoff is not built"; exit 77; }
check "radiosity's trade is measured" bash -c "'$tradeoff' radiosity --quick --csv '$WORK/csv' --plot '$WORK/svg' >'$WORK/out'"
check "... as a table" grep -qx "scene,setting,shipped,cpu_s,rms_percent" "$WORK/csv"
# rms SCENE SETTING, seconds SCENE SETTING
rms() { awk -F, -v s="$1" -v q="$2" '$1 == s && $2 == q { print $5 }' "$WORK/csv"; }
for scene in cube columns corner hall; do
    check "... with one point of $scene that ships" test "$(awk -F, -v s=$scene '$1 == s && $3 == 1' "$WORK/csv" | wc -l)" = 1
done
for scene in cube columns corner; do
    check "... in which patches and elements count, in $scene" bash -c "$(declare -f less); less $(rms $scene default) $(rms $scene 'patches 1500') && less $(rms $scene default) $(rms $scene 'elements 7500')"
    check "... lamps are better seen by rays, in $scene" less "$(rms $scene default)" "$(rms $scene 'by hemicube 32')"
    check "... more pixels beat more hemicubes, in $scene" less "$(rms $scene 'by hemicube 64')" "$(rms $scene 'by 4 hemicubes 32')"
done
check "the room's light is within half a percent" less "$(rms cube default)" 0.5
check "the corner's within one" less "$(rms corner default)" 1
check "the columns' within two" less "$(rms columns default)" 2
check "a plot" bash -c "grep -q '^<svg' '$WORK/svg' && [ \$(grep -c '<circle' '$WORK/svg') -ge 40 ]"
check "bench_radiosity refuses options it does not know" refuses 2 "usage: bench_radiosity" "$BUILD/bench_radiosity" --slow
finish
