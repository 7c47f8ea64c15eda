# The film at its full length in a window: every scene is shown, it ends by itself, and its memory does not grow.
#   SOAK_FROM=150: from there on, to try it
. "$(dirname "$0")/../display.sh"
PATIENCE=1800
from=${SOAK_FROM:-0}
start_display 1280x720
check "opens its window" begin "$BUILD/odraz" --window --size 1280x720 --from "$from" --stats
check "plays" await eval "is_bright || gone $pid"
while rss=$(awk '/^VmRSS/ { print $2 }' "/proc/$pid/status" 2>/dev/null) && [ -n "$rss" ]; do
    echo "$rss"
    sleep 0.5
done >"$WORK/rss"
check "ends by itself" ended $pid
check "... without a word on standard error" test ! -s "$WORK/err"
cat "$WORK/out"
for scene in point table flake patches hall odraz credits; do
    [ "$from" = 0 ] || [ $scene = credits ] || continue
    check "... $scene was shown" grep -qE "^$scene +[1-9]" "$WORK/out"
done
# The most of the first third that it played against the most of all
read -r samples first most <<<"$(awk '
    { rss[NR] = $1; if ($1 > most) most = $1 }
    END { for (i = 1; i <= NR / 3; ++i) if (rss[i] > first) first = rss[i]; print NR, int(first / 1024), int(most / 1024) }' "$WORK/rss")"
check "its memory was looked at: $samples times" test "${samples:-0}" -ge 6
check "... and stays: $first MB in the first third, $most MB at most" test "${most:-999}" -le $((first + 8)) -a "${most:-999}" -lt 512
finish
