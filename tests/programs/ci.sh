# The steps of tools/CI.md, word for word, in a project that is no film, with the tools as the archive has them.
. "$(dirname "$0")/common.sh"
skip_unless g++ tar
needs_built portable/pack portable/compare
page=$SOURCE/tools/CI.md
block() { awk -v wanted="$1" '/^    / { if (!on) ++n; on = 1; if (n == wanted) print substr($0, 5); next } /^$/ && on && n == wanted { next } { on = 0 }' "$page"; }

# A project: a program that draws a picture, and the picture that was kept
tools=odraz-tools-$FILM_VERSION-linux-x86_64
project=$WORK/project
mkdir -p "$project/build" "$project/golden" "$WORK/tools/$tools"
cp "$BUILD"/portable/{pack,compare} "$WORK/tools/$tools"
tar -C "$WORK/tools" -czf "$project/$tools.tar.gz" $tools
cat >"$WORK/game.cpp" <<'GAME'
#include <cstdio>
int main(int argc, char **argv) {
    std::FILE *to = argc > 2 ? std::fopen(argv[2], "wb") : nullptr;
    if (!to) return 1;
    std::fprintf(to, "P6\n64 64\n255\n");
    for (int i = 0; i < 64 * 64; ++i) std::fprintf(to, "%c%c%c", i % 64 * 4, i / 64 * 4, BLUE);
    return std::fclose(to);
}
GAME
built() { g++ -Os -DBLUE="$1" "$WORK/game.cpp" -o "$project/build/game"; }
block 1 >"$project/check.sh"
block 2 | sed -n '/script:/,/artifacts:/ s/^ *- //p' >"$WORK/script"
check "the page has a step of five lines" test "$(wc -l <"$project/check.sh")" = 5
check "... and two commands for it" test "$(wc -l <"$WORK/script")" = 2
check "the archive of these is that of this version" grep -qF "$tools.tar.gz" "$WORK/script"
step() { (cd "$project" && env -u BUILD bash -e "$WORK/script") >"$WORK/printed" 2>&1; }
printed() { grep -qE -- "$1" "$WORK/printed" || { cat "$WORK/printed" >&2; return 1; }; }

check "the program is built" built 99
check "its picture is kept, by the page's command" eval '"$project/build/game" --screenshot "$project/build/frame.ppm" && cd "$project" && PATH=$WORK/tools/$tools:$PATH && eval "$(sed -n "s/.*\`\(compare --png .*\)\`.*/\1/p" "$page")"'
check "... and what it costs" bash -c '"$0/pack" "$1/build/game" -o "$2" --report "$1/golden/game.json" >/dev/null' "$BUILD/portable" "$project" "$WORK/packed"
check "the step passes" step
check "... and prints what is left of the budget" printed ' bytes left of 30000'
check "... with a report" test -s "$project/build/game.json"
check "... and a comment" grep -q 'bytes\*\*, +0' "$project/build/game.md"
check "it passes a picture that hardly differs" eval 'built 100 && step'
check "another picture fails it" eval 'built 160 && ! step'
check "... and is reported" printed 'largest difference 61, '
check "... and shown" test -s "$project/build/difference.png"
sed -i 's/--budget 30000/--budget 3000/' "$project/check.sh"
check "a budget that is too small fails it" eval 'built 99 && ! step'
check "... and is reported" printed 'over budget by [0-9]+ bytes'
finish
