# The command that measures and writes RESULTS.md: quick runs of two sections into another file.
. "$(dirname "$0")/common.sh"
needs_built bench_transfer
export BUILD
all=$SOURCE/tools/measure/all
to=$WORK/results.md
# section NAME: as it stands in the results
section() { awk -v mark="<!-- $1 -->" '/^<!-- .* -->$/ { inside = $0 == mark; next } inside' "$to"; }
renew() { "$all" --built --quick --to "$to" "$@" >/dev/null 2>"$WORK/err"; }

check "sections are measured" renew --only size --only transfer
check "the commit stands at the head" grep -qE '^\| commit \| ([0-9a-f]{12}\+?|unknown\+?) \|$' "$to"
check "... and so do processor, compiler and Mesa" test "$(grep -cE '^\| (processor|compiler|Mesa) \| .+ \|$' "$to")" = 3
"$all" --list >"$WORK/list"
check "sections are listed" test "$(wc -l <"$WORK/list")" -gt 3
check "... and every one is there" test "$(grep -c '^## ' "$to")" = "$(wc -l <"$WORK/list")"
check "what was not measured says how" grep -q 'Not measured yet: `tools/measure/all --only pack`' "$to"
check "the film's size is told" grep -qF "| \`odraz\`: packed | $(stat -c %s "$BUILD/odraz") | $(stat -c %s "$BUILD/odraz.exe") |" "$to"
check "... with the command that makes it" prints 'By `cmake --build build --target film film_windows`:' section size
section transfer >"$WORK/transfer"
check "transfer is told" test "$(grep -cE '^\| [a-z].*\| [0-9.]+ \|' "$WORK/transfer")" -ge 10
check "one section is renewed" renew --only size
check "... and the other stays as it was" cmp "$WORK/transfer" <(section transfer)
cp "$to" "$WORK/before"
BUILD=$WORK/none "$all" --built --quick --to "$to" --only size 2>"$WORK/err" >/dev/null
check "a section that fails" test $? != 0
check "... is told" grep -q 'left as they were: size' "$WORK/err"
check "... and leaves the results alone" cmp -s "$to" "$WORK/before"
check "nothing else is left beside them" test "$(find "$WORK" -name '.results*' | wc -l)" = 0

check "an unknown section" refuses 2 "there is no section 'colour'; there are: size" "$all" --only colour
check "an unknown option" refuses 2 "cannot use '--fast'" "$all" --fast
check "a folder that is not there" refuses 2 "cannot write" "$all" --to "$WORK/none/results.md"
check "quick figures stay out of the repository" refuses 2 "--quick goes with --to" "$all" --quick
finish
