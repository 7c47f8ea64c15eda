# The command that measures and writes RESULTS.md: quick runs of two sections into another file; and what --check tells,
# in a scratch repository with two sections that take no time.
. "$(dirname "$0")/common.sh"
needs_built bench_transfer
export BUILD
all=$SOURCE/tools/measure/all
to=$WORK/results.md
# section NAME: as it stands in the results
section() { awk -v mark="<!-- $1 -->" '/^<!-- .* -->$/ { inside = $0 == mark; next } inside' "$to"; }
renew() { "$all" --built --quick --to "$to" "$@" >/dev/null 2>"$WORK/err"; }

check "sections are measured" renew --only size --only transfer
check "what it was measured of stands in its head" grep -qE '\. Sources: `intro` [0-9a-f]{12}, .*`tools/measure/results/size` [0-9a-f]{12}\. By ' "$to"
check "processor, compiler and Mesa stand at the head of all" test "$(grep -cE '^\| (processor|compiler|Mesa) \| .+ \|$' "$to")" = 3
"$all" --list >"$WORK/list"
check "sections are listed" test "$(wc -l <"$WORK/list")" -gt 3
check "... which take no longer than 55 minutes together" less "$(awk '{ sum += $2 } END { print sum }' "$WORK/list")" 55.01
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
check "a commit that is none" refuses 2 "--same-code needs a commit, and 'nothing' is none" "$all" --same-code nothing
check "a commit that is not named" refuses 2 "--same-code needs a commit;" "$all" --same-code
check "a folder that is not there" refuses 2 "cannot write" "$all" --to "$WORK/none/results.md"
check "quick figures stay out of the repository" refuses 2 "--quick goes with --to" "$all" --quick

machine=$SOURCE/tools/measure/bench/machine
check "a machine is measured in no other way" refuses 2 "cannot use '--fast'" "$machine" --fast
check "... nor by programs that are missing" refuses 2 "odraz-safe is missing: cmake" env BUILD="$WORK/none" "$machine"

# --- What --check tells ---
scratch=$WORK/scratch
mkdir -p "$scratch"
cp -r "$SOURCE"/{CMakeLists.txt,intro,packer,tools} "$scratch"
cd "$scratch" || exit 1
find . -name '*.md' -delete
rm tools/measure/results/*
# Two sections: `one` measures a tracer's room, `two` the packer
sed -i '/^SECTIONS=/,/)$/c\SECTIONS=(one two)' tools/measure/all
cat >tools/measure/results/one <<'END'
title=One
minutes=1
sources=(intro/trace intro/base)
timed=1
measure() { made_by nothing; sleep "${SLEEP-0}"; printf '|  | ms |\n|---|---|\n| ball | 1234.56 |\n'; }
figures() { figure ball "$(cell ball ms | rounded 0 | thousands)"; }
END
cat >tools/measure/results/two <<'END'
title=Two
minutes=1
sources=(packer)
lacks() { [ -z "${LACKS-}" ] || echo "$LACKS"; }
measure() { made_by nothing; echo "$RANDOM"; }
END
printf 'A <!--one.ball-->1<!--/--> ms.\n\n## Figures\n\nBalls: <!--one.ball-->1<!--/--> ms.\n' >README.md
commit() { git add --all && git -c user.name=test -c user.email=test commit -q "$@"; }
git init -q . && commit -m one
all=$scratch/tools/measure/all to=$scratch/tools/measure/RESULTS.md
measures() { "$all" --built "$@" >/dev/null 2>"$WORK/err"; }
# tells STATUS PATTERN: --check exits with the status and a line of it matches; "" for no line but the last
tells() {
    "$all" --check >"$WORK/told" 2>&1
    local got=$?
    if [ "$got" = "$1" ] && { [ -n "$2" ] && grep -qE -- "$2" "$WORK/told" || [ -z "$2$(sed '$d' "$WORK/told")" ]; }; then return; fi
    echo "exit $got, wanted $1; told: $(head -c 500 "$WORK/told")" >&2
    return 1
}
check "nothing was measured: told, with how" tells 1 '^unmeasured: two: tools/measure/all --only two, 1 minutes$'
check "all is measured" measures
check "... and --check has nothing to tell" tells 0 ''
check "... except the totals" grep -qx '2 sections, 0 of them stale; 1 figures' "$WORK/told"
check "figures are written where their marks are, as they are told" test "$(grep -c 'one.ball-->1,235<!--/--> ms' README.md)" = 2
check "hashes are git's" grep -qF "\`intro/trace\` $(git rev-parse HEAD:intro/trace | head -c 12), " "$to"

quality=$(find intro/trace -name quality.h)
commit -m results
echo >>"$quality"
check "a change that is not committed makes its section stale, and no other" tells 0 '^stale: one: since then intro/trace$'
check "... which is no failure" test "$(grep -c '^stale' "$WORK/told")" = 1
commit -m change
check "... as does a commit" tells 0 '^stale: one: since then intro/trace$'
git revert -q --no-edit HEAD 2>/dev/null || git -c user.name=test -c user.email=test revert --no-edit HEAD >/dev/null
check "... until it is taken back" tells 0 ''
commit --amend --allow-empty -m "another name"
check "what commits are called does not matter" tells 0 ''
git clone -q . "$WORK/clone"
check "... nor which clone it is" test "$("$WORK/clone/tools/measure/all" --check)" = '2 sections, 0 of them stale; 1 figures'
echo new >intro/base/new.h
check "a new file counts" tells 0 '^stale: one: since then intro/base$'
rm intro/base/new.h
echo text >intro/base/README.md
check "... but a README does not" tells 0 ''
rm intro/base/README.md

cp "$to" "$WORK/before"
section two >"$WORK/two"
echo >>"$quality"
check "what is stale is renewed" measures --stale
check "... and nothing is left" tells 0 ''
check "... and nothing else was" cmp "$WORK/two" <(section two)
check "then nothing is stale" prints 'nothing is stale' "$all" --built --stale
git checkout -q "$quality"
cp "$WORK/before" "$to"

sed -i 's/one.ball-->1,235/one.ball-->1,234/' README.md
check "a figure that is another than its section's" tells 1 '^README.md: one.ball is 1,235 by its section, not 1,234'
check "... is written anew" "$all" --readme
check "... as it was" tells 0 ''
echo 'A <!--one.cube-->2<!--/--> ms.' >>README.md
check "a figure that stands in no section" tells 1 '^README.md: one.cube stands in no section$'
sed -i '$d' README.md
echo 'Cubes: 17 ms each.' >>README.md
check "a figure without marks" tells 1 '^README.md:[0-9]*: 17 ms has no mark'
sed -i '$d' README.md
echo 'A <!--one.ball-->1,235' >>README.md
check "a mark that does not end" tells 1 '^README.md:[0-9]*: a figure needs both marks on one line'
sed -i '$d' README.md

sed -i 's/`packer` [0-9a-f]*/`packer` unknown/' "$to"
check "what is no hash is unknown to git" tells 1 '^unknown: two names no hash of its sources$'
cp "$WORK/before" "$to"
sed -i 's/^sources=(packer)/sources=(packer intro\/none)/' tools/measure/results/two
check "... as is a source that is not there" tells 1 '^unknown: two measures intro/none, which git does not have$'
git checkout -q tools/measure/results/two

LACKS="a moon" measures --only two
check "a section that cannot be measured here keeps its figures" cmp "$WORK/two" <(section two)
check "... and is told" grep -q 'two needs a moon' "$WORK/err"
sed -i '/^<!-- two -->/,$d' "$to"
LACKS="a moon" measures --only two
check "... and where there were none, the section says why" grep -q '\. It was not measured: it needs a moon\.$' "$to"
check "... and is not stale" tells 0 ''

(while :; do :; done) & PIDS+=($!)
(while :; do :; done) & PIDS+=($!)
check "on a busy machine, a section is measured" eval 'SLEEP=2 measures --only one'
kill "${PIDS[@]}"
check "... whose rows tell how busy it was" grep -qE '^\| ball \| 1234.56 \| [1-9]\.[0-9] \|$' "$to"
rm -rf .git
check "without git" refuses 2 "staleness is told by git" "$all" --check

finish
