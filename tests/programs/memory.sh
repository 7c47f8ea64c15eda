# Sourced by tests of the program $odraz: checks how much memory it takes for a picture of the hall.
# The picture does not fit into the pipe, so the film waits while writing. By then its memory has reached its peak
exec 8< <(exec "$odraz" --dump - --from 100 --to 100.04 --size 1280x720)
pid=$!
LC_ALL=C IFS= read -r -N 2 -u 8 magic
check "it makes a picture of the hall" test "$magic" = P6
most=$(awk '/VmHWM/ { print int($2 / 1024) }' /proc/$pid/status)
check "... within 512 MB: ${most:=none}" test "$most" -gt 100 -a "$most" -lt 512
check "... and writes the rest of it" test "$(wc -c <&8)" = $((1280 * 720 * 3 + 16 - 2))
exec 8<&-
