# Does what the pages tell their readers to do: runs every command of a code block, and every example of a --help, word
# for word. pages/commands.txt shortens what would take long; a command that it does not know fails the test. Then it
# checks that whatever the pages name is there, and that their lines fit the width.
#   bash tests/programs/pages.sh BUILD [long]
# The commands run in a copy of the sources. Its build/ has links to the programs of BUILD; build/odraz there is
# odraz-safe, since the packed film decodes for seconds at each start; with `long` it is the packed one.
. "$(dirname "$0")/display.sh"
skip_unless perl ffmpeg git ninja
for program in odraz odraz-safe odraz-debug pack pack-link radiosity spectrogram contact_sheet tradeoff; do needs_built $program; done
long=${2-}
PARTS=$SOURCE/tests/programs/pages
HOUSE=$WORK/house
# (RESULTS.md is figures alone; those of a new film are templates)
PAGES=$(cd "$SOURCE" && git ls-files '*.md' | grep -vE '^tools/(measure/RESULTS\.md$|new_film/)')

# --- A house to run them in ---
mkdir -p "$HOUSE/build" "$WORK/bin"
(cd "$SOURCE" && git ls-files -z | xargs -0 cp --parents -t "$HOUSE") 2>"$WORK/copied" || true # a file may be removed, uncommitted
ln -s "$BUILD"/* "$HOUSE/build"
rm -f "$HOUSE"/build/{release,contact_sheet.png,film.mp4,film.mp4.parts,build.log,tests.xml,Testing}
[ -n "$long" ] || ln -sf "$BUILD/odraz-safe" "$HOUSE/build/odraz"
(cd "$HOUSE" && git init -q . && git add -A . && git -c user.name=odraz -c user.email=odraz@localhost commit -qm "A copy")
# All is built already: a cmake that only looks whether there are such targets and folders
ninja -C "$BUILD" -t targets all | sed 's/:.*//' | sort -u >"$WORK/targets"
cat >"$WORK/bin/cmake" <<CMAKE
#!/usr/bin/env bash
targets=
while [ \$# -gt 0 ]; do
    case \$1 in
    -S | -B | --build) [ -d "\$2" ] || { echo "cmake: there is no folder \$2" >&2; exit 1; }; shift ;;
    -G | -j) shift ;;
    --target) targets=1 ;;
    -*) ;;
    *) [ -n "\$targets" ] && grep -qxF -- "\$1" "$WORK/targets" || { echo "cmake: there is no target \$1" >&2; exit 1; } ;;
    esac
    shift
done
CMAKE
# ... and nothing is installed
printf '#!/bin/sh\necho "a test installs nothing: $0 $*" >&2\nexit 1\n' | tee "$WORK/bin/apt-get" >"$WORK/bin/sudo"
chmod +x "$WORK"/bin/*
export PATH="$WORK/bin:$HOUSE/build:$PATH" BUILD="$HOUSE/build"
cd "$HOUSE"

# --- Every program tells how it is used ---
mkdir "$WORK/help"
PROGRAMS=$(cd "$HOUSE" && find -L build -maxdepth 1 -type f -perm -u+x ! -name '*.elf' ! -name '*.exe' ! -name '*.so' | sort
    find tools -type f -perm -u+x ! -path 'tools/render_parts/*' ! -path 'tools/new_film/*' ! -name '*.py' | sort)
helps() { # helps PROGRAM
    local to=$WORK/help/${1//\//:} command
    timeout "$PATIENCE" "$1" --help >"$to" 2>"$WORK/err" </dev/null && [ -s "$to" ] && [ ! -s "$WORK/err" ] || return
    for command in $(sed -n '/^Subcommands:/,/^$/s/^  *\([a-z0-9-]*\)  .*/\1/p' "$to"); do
        "$1" "$command" --help >>"$to" 2>"$WORK/err" || return
    done
}
all_help() {
    local program wrong=0
    for program in $PROGRAMS; do helps "$program" || { echo "$program --help: $(head -c 200 "$WORK/err")" >&2; wrong=1; }; done
    return $wrong
}
check "every program and script has a --help" all_help
check "... $(wc -w <<<"$PROGRAMS") of them" [ "$(wc -w <<<"$PROGRAMS")" -ge 25 ]

# An example in a help stands on a line of its own: a program's name and what follows, without placeholders
examples() {
    cat "$WORK"/help/* | sed -E 's/^usage: +//; s/^ +//; s/ {2,}.*//' |
        grep -E "^($(sed 's|build/|(build/)?|' <<<"$PROGRAMS" | paste -sd '|')) " |
        grep -vE '[][]|\.\.\.|\b[A-Z]{2,}|\b[A-Z]\b|[a-z]\|[a-z]|\| --|\.$' | sort -u
}
elsewhere() { ! grep -nE 'for instance|for example|e\.g\.' "$WORK"/help/* >&2; }
check "helps give examples on lines of their own" elsewhere

# --- What is to be done with each ---
# pages/commands.txt as KNOWN[PAGE: COMMAND] and SAID[PAGE: COMMAND: KEY]; MET: those that a page has
declare -A SAID KNOWN MET
page= command=
while IFS= read -r line; do
    case $line in
    "" | "#"*) ;;
    "== "*) page=${line#== } ;;
    "    "*)
        line=${line#    }
        SAID["$page: $command: ${line%%: *}"]=${line#*: } ;;
    *) command=$line KNOWN["$page: $command"]=1 ;;
    esac
done <"$PARTS/commands.txt"

ran() { # ran COMMAND: it succeeds within the house; what it says is kept
    (cd "$HOUSE" && eval "$1") >"$WORK/ran" 2>&1 </dev/null && return 0
    echo "    exit $?: $(tail -n 5 "$WORK/ran")" >&2
    return 1
}
made() { # made FILE...: and there is something in them
    local file
    for file in "$@"; do [ -s "$HOUSE/$file" ] || { echo "    $file was not made" >&2; return 1; }; done
}
same_lines() { # same_lines PAGE BLOCK: the block stands in what was said last, but for times
    local line
    perl "$PARTS/blocks.pl" "$HOUSE/$1" | sed -n "s/^$2 //p" | grep -v 'seconds' >"$WORK/wanted"
    while IFS= read -r line; do grep -qxF -- "$line" "$WORK/ran" || { echo "    it does not say: $line" >&2; return 1; }; done <"$WORK/wanted"
}

follow() { # follow PAGE: lines of BLOCK COMMAND
    local page=$1 block= skipped= key shorter
    while read -r block command; do
        [ "$block" != "$skipped" ] || continue
        key="$page: $command"
        MET["$key"]=1
        if [ -z "${KNOWN[$key]-}" ]; then
            check "$page: pages/commands.txt knows: $command" false
            continue
        fi
        if [ -n "${SAID[$key: no command]-}" ]; then
            skipped=$block
            continue
        elif [ -n "${SAID[$key: printed by]-}" ]; then
            skipped=$block
            check "$page: what is printed by ${SAID[$key: printed by]}" ran "${SAID[$key: printed by]}"
            check "... is what the page says" same_lines "$page" "$block"
            continue
        elif [ -n "${SAID[$key: declared in]-}" ]; then
            skipped=$block
            check "$page: ${command%%;*} stands in ${SAID[$key: declared in]}" grep -qF -- "${SAID[$key: as]}" "$HOUSE/${SAID[$key: declared in]}"
            continue
        fi
        shorter=${SAID[$key: instead]-}
        if [ -n "$shorter" ]; then
            [ -n "${SAID[$key: because]-}" ] || check "$command: there is a reason for doing something else" false
            [ -z "$long" ] || [ -z "${SAID[$key: long]-}" ] || shorter=
        fi
        if [ -n "${SAID[$key: opens]-}" ]; then
            check "$page: $command${shorter:+   (as: $shorter)}: opens a window" opens "${shorter:-$command}"
        else
            check "$page: $command${shorter:+   (as: $shorter)}" ran "${shorter:-$command}"
        fi
        # shellcheck disable=SC2086
        [ -z "${SAID[$key: makes]-}" ] || check "... makes ${SAID[$key: makes]}" made ${SAID[$key: makes]}
        [ -z "${SAID[$key: says]-}" ] || check "... and says '${SAID[$key: says]}'" grep -qE -- "${SAID[$key: says]}" "$WORK/ran"
    done
}

start_display 1280x720
for page in $PAGES; do
    perl "$PARTS/blocks.pl" "$HOUSE/$page" >"$WORK/commands"
    follow "$page" <"$WORK/commands"
done
examples | sed 's/^/0 /' >"$WORK/commands"
check "the helps have examples" [ -s "$WORK/commands" ]
follow help <"$WORK/commands"
no_others() {
    local key wrong=0
    for key in "${!KNOWN[@]}"; do [ -n "${MET[$key]-}" ] || { echo "    $key" >&2; wrong=1; }; done
    return $wrong
}
check "pages/commands.txt has no command that stands nowhere" no_others

# --- What the pages name is there, and their lines fit the width ---
wide() { # what is not seen does not count, and a table or an address cannot be wrapped
    perl -CSD -ne 'chomp; s/<!--.*?-->//g; if (length > 120 && !/^\||https?:/) { print STDERR "    $ARGV:$.: ", length, "\n"; $bad = 1 }
        close ARGV if eof; END { exit($bad ? 1 : 0) }' "$@"
}
# shellcheck disable=SC2086
check "lines of pages are at most 120 characters long, tables apart" wide $PAGES
(cd "$SOURCE" && git ls-files) >"$WORK/files"
(cd "$HOUSE" && grep -rhoIE --exclude='*.md' --exclude=pages.sh --exclude-dir=pages --exclude-dir=.git --exclude-dir=build '[A-Za-z_][A-Za-z0-9_]*' .) | sort -u >"$WORK/words"
for page in $PAGES; do
    check "what $page names is there" perl "$PARTS/named.pl" "$page" "$WORK/files" "$WORK/targets" "$WORK/words" "$WORK/help"
done

# What is wrong would be found
for wrong in '`intro/nothing.h`' '`build/nothing`' '[a link](nothing.md)' '`tools/test --nothing`' '`--nothing`' '`kNoSuchTable`' '`noSuchThing()`'; do
    echo "$wrong" >"$WORK/wrong.md"
    finds() { ! perl "$PARTS/named.pl" "$WORK/wrong.md" "$WORK/files" "$WORK/targets" "$WORK/words" "$WORK/help" 2>/dev/null; }
    check "(it would be found that there is no $wrong)" finds
done
printf '%0121d\n' 0 >"$WORK/wrong.md"
check "(... and that a line is too long)" eval '! wide "$WORK/wrong.md" 2>/dev/null'
finish
