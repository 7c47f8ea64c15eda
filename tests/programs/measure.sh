# The command that measures and writes RESULTS.md: quick runs of two sections into another file; and what --check
# prints, in a scratch repository with two sections that take no time.
. "$(dirname "$0")/common.sh"
needs_built bench_transfer
export BUILD
all=$SOURCE/tools/measure/all
to=$WORK/results.md
# section NAME: as it stands in the results
section() { awk -v name="$1" '/^<!-- .* -->$/ { sub(/:$/, "", $2); inside = $2 == name; next } inside' "$to"; }
renew() { "$all" --built --quick --to "$to" "$@" >/dev/null 2>"$WORK/err"; }

check "sections are measured" renew --only size --only transfer
check "its mark has the hashes of its sources" \
    grep -qE '^<!-- size: intro [0-9a-f]{12}, .*tools/measure/results/size [0-9a-f]{12} -->$' "$to"
check "processor, compiler and Mesa stand at the head of all" \
    test "$(grep -cE '^\| (processor|compiler|Mesa) \| .+ \|$' "$to")" = 3
"$all" --list >"$WORK/list"
check "sections are listed" test "$(wc -l <"$WORK/list")" -gt 3
check "... which take no longer than 40 minutes together" \
    less "$(awk '{ sum += $2 } END { print sum }' "$WORK/list")" 40.01
check "... and they are 21 at most" test "$(wc -l <"$WORK/list")" -le 21
check "... and every one is there" test "$(grep -c '^## ' "$to")" = "$(wc -l <"$WORK/list")"
check "what was not measured has its command" grep -q 'Not measured yet: `tools/measure/all --only pack`' "$to"
check "the film's size is printed" \
    grep -qF "| \`odraz\`: packed | $(stat -c %s "$BUILD/odraz") | $(stat -c %s "$BUILD/odraz.exe") |" "$to"
check "... with the command that makes it" prints 'By `cmake --build build --target film film_windows`:' section size
section transfer >"$WORK/transfer"
check "transfer is printed" test "$(grep -cE '^\| [a-z].*\| [0-9.]+ \|' "$WORK/transfer")" -ge 10
check "one section is renewed" renew --only size
check "... and the other stays as it was" cmp "$WORK/transfer" <(section transfer)
cp "$to" "$WORK/before"
BUILD=$WORK/none "$all" --built --quick --to "$to" --only size 2>"$WORK/err" >/dev/null
check "a section that fails" test $? != 0
check "... is reported" grep -q 'left as they were: size' "$WORK/err"
check "... and leaves the results alone" cmp -s "$to" "$WORK/before"
check "nothing else is left beside them" test "$(find "$WORK" -name '.results*' | wc -l)" = 0

check "an unknown section" refuses 2 "there is no section 'colour': there are size" "$all" --only colour
check "a folder that is not there" refuses 2 "cannot write" "$all" --to "$WORK/none/results.md"
check "quick figures stay out of the repository" refuses 2 "--quick goes with --to" "$all" --quick

# --- CSV by the titles of its columns ---
. "$SOURCE/tools/measure/tables.sh"
export -f column columns csv
printf 'scene,ms,shipped\nA,3,1\nB,4,0\n' >"$WORK/a.csv"
printf 'count,scene\n7,A\n' >"$WORK/b.csv"
check "a column's number" test "$(column ms "$WORK/a.csv")" = 2
check "a title that is missing" refuses 1 "has no column 'db'" bash -c 'column db "$1"' - "$WORK/a.csv"
check "cells by title" test "$(csv '$shipped { print $scene, $ms }' "$WORK/a.csv")" = "A 3"
check "... of two files, whatever the order of their columns" \
    test "$(csv 'NR == FNR { n[$scene] = $count; next } { print $scene n[$scene] }' "$WORK/b.csv" "$WORK/a.csv" | paste -sd ' ')" = "A7 B"
check "... a title that is missing" \
    refuses 1 "has no column 'db'" bash -c 'csv "{ print \$db }" "$@"' - "$WORK/a.csv" "$WORK/b.csv"

check "a table of some columns, under other headings" \
    test "$(columns "$WORK/a.csv" ms=time scene | paste -sd ' ')" = "| time | scene | |---|---| | 3 | A | | 4 | B |"
check "... a title that is missing" refuses 1 "has no column 'db'" bash -c 'columns "$1" ms db' - "$WORK/a.csv"

# --- What --check prints ---
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
measure() { made_by nothing; sleep "${SLEEP-0}"; printf '|  | ms |\n|---|---|\n| ball | 1234.56 |\n'; }
END
cat >tools/measure/results/two <<'END'
title=Two
minutes=1
sources=(packer)
measure() { made_by nothing; echo "$RANDOM"; }
END
echo 'figures() { echo "Balls: $(cell one ms ball | rounded 0 | thousands) ms."; }' >>tools/measure/figures.sh
printf 'A film.\n<!-- figures -->\nBalls: 7 ms.\n<!-- /figures -->\nMore.\n' >README.md
commit() { git add --all && git -c user.name=test -c user.email=test commit -q "$@"; }
git init -q . && commit -m one
all=$scratch/tools/measure/all to=$scratch/tools/measure/RESULTS.md
measures() { "$all" --built "$@" >/dev/null 2>"$WORK/err"; }
# reports STATUS PATTERN: --check exits with the status and a line of it matches; "" for no line but the last
reports() {
    "$all" --check >"$WORK/report" 2>&1
    local got=$?
    if [ "$got" = "$1" ] && { [ -n "$2" ] && grep -qE -- "$2" "$WORK/report" || [ -z "$2$(sed '$d' "$WORK/report")" ]; }; then return; fi
    echo "exit $got, wanted $1; printed: $(head -c 500 "$WORK/report")" >&2
    return 1
}
check "nothing was measured: reported, with the command" \
    reports 1 '^unmeasured: two: tools/measure/all --only two, 1 minutes$'
check "all is measured" measures
check "... and --check has nothing to report" reports 0 ''
check "... except the totals" grep -qx '2 sections, 0 of them stale' "$WORK/report"
check "figures are written between their marks, and nothing else" \
    test "$(paste -sd '|' README.md)" = 'A film.|<!-- figures -->|Balls: 1,235 ms.|<!-- /figures -->|More.'
check "hashes are git's" grep -qF "intro/trace $(git rev-parse HEAD:intro/trace | head -c 12), " "$to"

quality=$(find intro/trace -name quality.h)
commit -m results
echo >>"$quality"
check "a change that is not committed makes its section stale, and no other" \
    reports 0 '^stale: one: since then intro/trace$'
check "... which is no failure" test "$(grep -c '^stale' "$WORK/report")" = 1
commit -m change
check "... as does a commit" reports 0 '^stale: one: since then intro/trace$'
git revert -q --no-edit HEAD 2>/dev/null || git -c user.name=test -c user.email=test revert --no-edit HEAD >/dev/null
check "... until it is taken back" reports 0 ''
commit --amend --allow-empty -m "another name"
check "the commit's message does not matter" reports 0 ''
git clone -q . "$WORK/clone"
check "... nor which clone it is" test "$("$WORK/clone/tools/measure/all" --check)" = '2 sections, 0 of them stale'
echo new >intro/base/new.h
check "a new file counts" reports 0 '^stale: one: since then intro/base$'
rm intro/base/new.h
echo text >intro/base/README.md
check "... but a README does not" reports 0 ''
rm intro/base/README.md
echo "# more" >>tools/measure/tables.sh
check "... nor code that sections share" reports 0 ''
echo "# more" >>tools/measure/results/two
check "a section's own file does" reports 0 '^stale: two: since then tools/measure/results/two$'
git checkout -q tools/measure

cp "$to" "$WORK/before"
section two >"$WORK/two"
echo >>"$quality"
check "what is stale is measured" measures --stale
check "... and nothing is left" reports 0 ''
check "... and nothing else was measured" cmp "$WORK/two" <(section two)
check "then nothing is stale" prints 'nothing is stale' "$all" --built --stale
git checkout -q "$quality"
cp "$WORK/before" "$to"

sed -i 's/1,235/1,234/' README.md
check "other figures than the sections'" \
    reports 1 '^README.md has other figures than RESULTS.md: tools/measure/all --readme$'
check "... are written again" "$all" --readme
check "... as they were" reports 0 ''
sed -i '/<!-- .figures -->/d' README.md
check "a mark that is missing" reports 1 '^README.md: the marks <!-- figures --> and <!-- /figures --> are needed$'
git checkout -q README.md
sed -i 's/^| ball/| cube/' "$to"
check "a figure that no section has" reports 1 "^figures: section one has no 'ball' below 'ms'\$"
cp "$WORK/before" "$to"

sed -i 's/^sources=(packer)/sources=(packer intro\/none)/' tools/measure/results/two
check "a source that is not there" reports 1 '^unknown: two measures intro/none, which git does not have$'
git checkout -q tools/measure/results/two

(while :; do :; done) & PIDS+=($!)
(while :; do :; done) & PIDS+=($!)
check "on a busy machine, a section is measured" eval 'SLEEP=2 measures --only one'
kill "${PIDS[@]}"
check "... whose head shows how busy it was" prints ', others [1-9]\.[0-9]*, took ' section one
rm -rf .git
check "without git" refuses 2 "is no checkout" "$all" --check

finish
