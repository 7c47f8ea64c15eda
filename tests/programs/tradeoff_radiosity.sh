# `tradeoff radiosity`, which measures speed and accuracy: its quick run.
. "$(dirname "$0")/common.sh"
tradeoff=$BUILD/tradeoff
needs_built tradeoff
check "radiosity's trade-off is measured" "$tradeoff" radiosity --quick --csv "$WORK/csv" --plot "$WORK/svg"
check "... as a table" grep -qx "scene,setting,shipped,cpu_s,rms_percent,median_percent" "$WORK/csv"
# rms SCENE SETTING
rms() { awk -F, -v s="$1" -v q="$2" '$1 == s && $2 == q { print $5 }' "$WORK/csv"; }
for scene in cube columns corner vault terrain hall; do
    check "... with one point of $scene that ships" table "$WORK/csv" "shipped += \$1 == \"$scene\" && \$3 == 1" 'shipped == 1'
done
for scene in cube columns corner; do
    check "... in which the number of patches matters, in $scene" less "$(rms $scene patches)" "$(rms $scene 'patches 1500')"
    check "... and that of elements" less "$(rms $scene default)" "$(rms $scene 'elements 7500')"
    check "... lamps are better seen by rays, in $scene" less "$(rms $scene patches)" "$(rms $scene 'by hemicube 32')"
    check "... more pixels beat more hemicubes, in $scene" less "$(rms $scene 'by hemicube 64')" "$(rms $scene 'by 4 hemicubes 32')"
done
check "the room's light is within .7 percent" less "$(rms cube default)" 0.7
check "the corner's within one and a half" less "$(rms corner default)" 1.5
check "the columns' within two and a half" less "$(rms columns default)" 2.5
median() { awk -F, -v s="$1" -v q="$2" '$1 == s && $2 == q { print $6 }' "$WORK/csv"; }
check "the vault's, of many small planes, within four percent in the median, noise of the path-traced reference included" less "$(median vault default)" 4
check "... its rms within ten" less "$(rms vault default)" 10
check "... the terrain's within two" less "$(median terrain default)" 2
check "... few rays are worse" less "$(median vault default)" "$(median vault 'rays 16')"
check "a plot" grep -q '^<svg' "$WORK/svg"
check "... of at least forty" test "$(grep -c 'class="mark"' "$WORK/svg")" -ge 40
finish
