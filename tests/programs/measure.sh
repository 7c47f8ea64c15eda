# Tests tools/measure/all, which measures and writes RESULTS.md: it measures one section into another file. What --check
# prints is tested in a scratch repository with two sections that take no time.
. "$(dirname "$0")/common.sh"
skip_unless python3 git objcopy g++ ninja
needs_built odraz
export BUILD
all=$SOURCE/tools/measure/all
to=$WORK/results.md
# section NAME: prints a section of the results
section() { awk -v name="$1" '/^<!-- .* -->$/ { sub(/:$/, "", $2); inside = $2 == name; next } inside' "$to"; }

check "a section is measured" eval '"$all" --built --to "$to" --only size >/dev/null 2>"$WORK/err"'
check "... with a line of progress" grep -qx 'measuring size, 1 of 1: 0.1 minutes' "$WORK/err"
used=$(sed -n 's/^"file": \(.*\),/\1/p' "$BUILD/odraz-windows.json")
check "... the film's size, for Windows the bytes used" \
    grep -qF "| \`odraz\`: packed | $(stat -c %s "$BUILD/odraz") | $used |" "$to"
check "... with the command that makes it" prints 'By `cmake --build build --target film film_windows`:' section size
check "... and the commit" grep -q "^<!-- size: $(git -C "$SOURCE" rev-parse --short=12 HEAD)+\?; intro " "$to"
"$all" --list >"$WORK/list"
check "all sections are there, measured or not" test "$(grep -c '^## ' "$to")" = "$(wc -l <"$WORK/list")"
check "... twelve at most" less "$(wc -l <"$WORK/list")" 13
check "... which take no longer than 25 minutes together" \
    less "$(awk '{ sum += $2 } END { print sum }' "$WORK/list")" 25.01
check "a section that was not measured has its command" grep -q 'Not measured yet: `tools/measure/all --only packers`' "$to"
cp "$to" "$WORK/before"
check "a section that fails is reported" \
    eval '! BUILD=$WORK/none "$all" --built --to "$to" --only size 2>"$WORK/err" >/dev/null && grep -q "not changed: size" "$WORK/err"'
check "... and leaves the results alone" cmp -s "$to" "$WORK/before"
check "the sources of all sections are there, and README.md has the figures of RESULTS.md" \
    eval '"$all" --check >"$WORK/report"; lacks "^(unknown|the figures|figures)" "$WORK/report"'
check "... at most eight of them" less "$(sed -n '/^<!-- figures/,/^<!-- .figures/p' "$SOURCE/README.md" | grep -c '^- ')" 9
check "an unknown section" refuses 2 "unknown section 'colour': use one of size" "$all" --only colour
check "an unknown option" refuses 2 "unrecognized arguments: --colour: see tools/measure/all --help" "$all" --colour
check "a file that cannot be written" refuses 2 "cannot write /proc/none/x" "$all" --to /proc/none/x

# --- What --check prints ---
scratch=$WORK/scratch
mkdir -p "$scratch"/{intro,packer,tools/measure,tools/build,build}
cp "$SOURCE"/tools/measure/{all,machine.py,parts.py,results.py,sources.py,figures.py} "$scratch/tools/measure"
cd "$scratch" || exit 1
cat >tools/measure/sections.py <<'END'
from types import SimpleNamespace as Section
from parts import table

def section(name, source):
    rows = lambda machine: [{'what': 'ball', 'ms': 1234.56}]
    return Section(name=name, title=name, minutes=1, sources=[source], programs=['program'], packages=[], targets=[],
        parts=[table(rows, 'what =; ms'), 'Of a {ball}.' if name == 'none' else 'Text.'])
SECTIONS = [section('one', 'intro'), section('two', 'packer')]
END
cat >>tools/measure/figures.py <<'END'
def figures(results):
    return f"Balls: {rounded(results.cell('one', 'ms', 'ball'))} ms.\n"
END
sed -i 's/, make=figures)/, make=lambda results: figures(results))/' tools/measure/figures.py
printf 'A film.\n<!-- figures -->\nBalls: 7 ms.\n<!-- /figures -->\nMore.\n' >README.md
echo 'int main() { int one = 1; return one - 1; }' >intro/file.cpp
echo 1 >packer/file
echo 'build' >.gitignore
printf 'rule cc\n  command = g++ -O1 $in -o $out\nbuild program: cc ../intro/file.cpp\n' >build/build.ninja
compile() { sleep 0.02 && ninja -C build >/dev/null; }
compile
git init -q . && git add --all && git -c user.name=test -c user.email=test commit -q -m one
all=$scratch/tools/measure/all BUILD=$scratch/build
# reports STATUS PATTERN [OPTION]: succeeds if --check exits with STATUS and prints a line that matches
reports() {
    "$all" --check $3 >"$WORK/report" 2>&1
    [ $? = "$1" ] && grep -qE -- "$2" "$WORK/report" && return
    echo "printed: $(head -c 500 "$WORK/report")" >&2
    return 1
}
fresh='^2 sections, 0 of them stale$'
check "nothing was measured: reported, with the command" \
    reports 1 '^unmeasured: two: run tools/measure/all --only two, 1 minutes$'
check "all is measured" eval '"$all" --built >/dev/null 2>"$WORK/err"'
check "... and --check has nothing to report" reports 0 "$fresh" --strict
check "figures are written between their marks, and nothing else" \
    test "$(paste -sd '|' README.md)" = 'A film.|<!-- figures -->|Balls: 1,235 ms.|<!-- /figures -->|More.'
commit=$(git rev-parse --short=12 HEAD)
echo 'int main() { /* its status */ int one = 1; return one - 1; } // no more' >intro/file.cpp
check "a comment makes nothing stale" reports 0 "$fresh" --strict
echo 'int main() { int two = 1; return two - 1; }' >intro/file.cpp
check "a local variable's name does, until the program is built" reports 0 "^stale: one: changed since $commit: intro\$"
compile
check "... with the same code" reports 0 "$fresh" --strict
echo 'int main() { int two = 7; return two - 1; }' >intro/file.cpp
compile
check "other code makes its section stale, and no other" reports 0 '^2 sections, 1 of them stale$'
check "... which --strict refuses" reports 1 "^stale: one: changed since $commit: intro\$" --strict
echo text >packer/README.md
check "a README makes nothing stale" reports 0 '^2 sections, 1 of them stale$'
check "--stale measures the stale section" eval '"$all" --built --stale >/dev/null 2>"$WORK/err"'
check "... and no other" test "$(grep -c ^measuring "$WORK/err")" = 1
check "... after which nothing is stale" reports 0 "$fresh" --strict
echo '# why' >>packer/file
check "a script's comment makes nothing stale" reports 0 "$fresh" --strict
echo 2 >>packer/file
check "... its code does, whatever was built" reports 0 '^stale: two: changed since '
"$all" --built --stale >/dev/null 2>&1
sed -i 's/1,235/1,234/' README.md
check "wrong figures in README.md are reported" \
    reports 1 '^the figures of README.md differ from RESULTS.md: run tools/measure/all --readme$'
check "... are written again" "$all" --readme
check "... as they were" reports 0 "$fresh" --strict
sed -i "s/'packer')/'packer\/none')/" tools/measure/sections.py
check "a missing source" reports 1 '^unknown: two needs packer/none, which git does not have$'
finish
