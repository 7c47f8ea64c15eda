# `tradeoff transfer`, which measures speed and accuracy: its quick run.
. "$(dirname "$0")/common.sh"
tradeoff=$BUILD/tradeoff
needs_built tradeoff
check "transfer's trade-off is measured" \
    prints '^method,' "$tradeoff" transfer --quick --csv "$WORK/csv" --plot "$WORK/svg"
check "... as a table" grep -qx "method,bands,clusters,dimensions,shipped,bytes,relight_ms,error_percent" "$WORK/csv"
check "... that is printed too" cmp "$WORK/csv" "$WORK/printed"
# error METHOD BANDS CLUSTERS DIMENSIONS
error() { awk -F, -v m="$1" -v b="$2" -v c="$3" -v d="$4" '$1 == m && $2 == b && $3 == c && $4 == d { print $8 }' "$WORK/csv"; }
check "one subspace does poorly" less 15 "$(error pca 5 1 16)"
check "... blocks do better" less "$(error blocks 5 64 16)" "$(error pca 5 1 16)"
check "... and clusters best" less "$(error cpca 5 64 16)" "$(error blocks 5 64 16)"
check "the day's light is within a per cent" less "$(error bands 5 0 0)" 1
for method in uncompressed bands; do
    check "... with one point of '$method' that ships" \
        table "$WORK/csv" "shipped += \$1 == \"$method\" && \$5 == 1" 'shipped == 1'
done
check "a plot" grep -q '^<svg' "$WORK/svg"
check "... of at least six" test "$(grep -c 'class="mark"' "$WORK/svg")" -ge 6
check "a folder that is not there is refused at once" \
    refuses 2 "cannot write" "$tradeoff" transfer --csv "$WORK/none/csv"
finish
