# The command that measures and writes RESULTS.md: a section of the repository, measured into another file; and what
# --check prints, in a scratch repository with two sections that take no time.
. "$(dirname "$0")/common.sh"
needs_built odraz
export BUILD
all=$SOURCE/tools/measure/all
to=$WORK/results.md
# section NAME: as it stands in the results
section() { awk -v name="$1" '/^<!-- .* -->$/ { sub(/:$/, "", $2); inside = $2 == name; next } inside' "$to"; }

check "a section is measured" eval '"$all" --built --to "$to" --only size >/dev/null 2>"$WORK/err"'
check "... the film's size" \
    grep -qF "| \`odraz\`: packed | $(stat -c %s "$BUILD/odraz") | $(stat -c %s "$BUILD/odraz.exe") |" "$to"
check "... with the command that makes it" prints 'By `cmake --build build --target film film_windows`:' section size
"$all" --list >"$WORK/list"
check "all sections are there, measured or not" test "$(grep -c '^## ' "$to")" = "$(wc -l <"$WORK/list")"
check "... which take no longer than half an hour together" \
    less "$(awk '{ sum += $2 } END { print sum }' "$WORK/list")" 30.01
check "what was not measured has its command" grep -q 'Not measured yet: `tools/measure/all --only pack`' "$to"
cp "$to" "$WORK/before"
check "a section that fails is reported" \
    eval '! BUILD=$WORK/none "$all" --built --to "$to" --only size 2>"$WORK/err" >/dev/null && grep -q "left as they were: size" "$WORK/err"'
check "... and leaves the results alone" cmp -s "$to" "$WORK/before"
check "the sources of all sections are there, and README.md has the figures of RESULTS.md" \
    eval '"$all" --check >"$WORK/report"; lacks "^(unknown|README|figures)" "$WORK/report"'
check "an unknown section" refuses 2 "there is no section 'colour': there are size" "$all" --only colour

# --- CSV by the titles of its columns ---
. "$SOURCE/tools/measure/tables.sh"
export -f column csv
printf 'scene,ms,shipped\nA,3,1\nB,4,0\n' >"$WORK/a.csv"
printf 'count,scene\n7,A\n' >"$WORK/b.csv"
check "cells by title, of two files, whatever the order of their columns" \
    test "$(csv 'NR == FNR { n[$scene] = $count; next } { print $scene n[$scene] }' "$WORK/b.csv" "$WORK/a.csv" | paste -sd ' ')" = "A7 B"
check "a title that is missing" \
    refuses 1 "has no column 'db'" bash -c 'csv "{ print \$db }" "$@"' - "$WORK/a.csv" "$WORK/b.csv"
check "a table of some columns, under other headings" \
    test "$(columns "$WORK/a.csv" ms=time scene | paste -sd ' ')" = "| time | scene | |---|---| | 3 | A | | 4 | B |"

# --- What --check prints ---
scratch=$WORK/scratch
mkdir -p "$scratch"/{intro,packer,tools/measure/results,tools/build}
cp "$SOURCE"/tools/measure/{all,*.sh} "$scratch/tools/measure"
cp "$SOURCE/tools/build/packages.sh" "$scratch/tools/build"
cd "$scratch" || exit 1
sed -i '/^SECTIONS=/c\SECTIONS=(one two)' tools/measure/all
section_file() { # section_file TITLE SOURCE
    printf '%s\n' "title=$1" minutes=1 "sources=($2)" 'measure() { made_by nothing; printf "|  | ms |\n|---|---|\n| ball | 1234.56 |\n"; }'
}
section_file One intro >tools/measure/results/one
section_file Two packer >tools/measure/results/two
echo 'figures() { echo "Balls: $(cell one ms ball | rounded 0 | thousands) ms."; }' >>tools/measure/figures.sh
printf 'A film.\n<!-- figures -->\nBalls: 7 ms.\n<!-- /figures -->\nMore.\n' >README.md
echo 1 | tee intro/file packer/file >/dev/null
git init -q . && git add --all && git -c user.name=test -c user.email=test commit -q -m one
all=$scratch/tools/measure/all
# reports STATUS PATTERN: --check exits with the status and a line of it matches
reports() {
    "$all" --check >"$WORK/report" 2>&1
    [ $? = "$1" ] && grep -qE -- "$2" "$WORK/report" && return
    echo "printed: $(head -c 500 "$WORK/report")" >&2
    return 1
}
fresh='^2 sections, 0 of them stale$'
check "nothing was measured: reported, with the command" \
    reports 1 '^unmeasured: two: tools/measure/all --only two, 1 minutes$'
check "all is measured" eval '"$all" --built >/dev/null 2>"$WORK/err"'
check "... and --check has nothing to report" reports 0 "$fresh"
check "figures are written between their marks, and nothing else" \
    test "$(paste -sd '|' README.md)" = 'A film.|<!-- figures -->|Balls: 1,235 ms.|<!-- /figures -->|More.'
check "hashes are git's" grep -qF "intro $(git rev-parse HEAD:intro | head -c 12), " tools/measure/RESULTS.md
echo 2 >intro/file
check "a change makes its section stale, and no other" reports 0 '^2 sections, 1 of them stale$'
echo text >packer/README.md
check "... but a README does not" reports 0 '^stale: one: since then intro$'
check "what is stale is measured" eval '"$all" --built --stale >/dev/null 2>"$WORK/err"'
check "... and nothing is left" reports 0 "$fresh"
sed -i 's/1,235/1,234/' README.md
check "other figures than the sections'" \
    reports 1 '^README.md has other figures than RESULTS.md: tools/measure/all --readme$'
check "... are written again" "$all" --readme
check "... as they were" reports 0 "$fresh"
sed -i 's/^sources=(packer)/sources=(packer intro\/none)/' tools/measure/results/two
check "a source that is not there" reports 1 '^unknown: two measures intro/none, which git does not have$'
finish
