# The commands in the pages' code blocks run, except those in NOT_RUN. What the pages name is there, and their lines
# fit the width: bash tests/programs/pages.sh BUILD
. "$(dirname "$0")/common.sh"
skip_unless perl git ninja
needs_built odraz-safe pack radiosity
PARTS=$SOURCE/tests/programs/pages
HOUSE=$WORK/house
# (RESULTS.md is figures alone; those of a new film are templates)
PAGES=$(cd "$SOURCE" && git ls-files '*.md' | grep -vE '^tools/(measure/RESULTS\.md$|new_film/)')

# These take minutes, install something, open a window, or need files of the reader's. Most have their own test
NOT_RUN='^(tools/(watch|test|render|release|golden|new-film|engine/contact_sheet)|build/(game|pack-link|radiosity (view|study)))\b
^build/odraz --dump|^build/radiosity transfer|\bvault\.prt\b|\bbash\b|--effort|--model hello\.model'

# --- The commands run in a copy of the sources, whose build/ has links to the programs of BUILD ---
mkdir -p "$HOUSE/build" "$WORK/bin"
copy_sources "$HOUSE"
ln -s "$BUILD"/* "$HOUSE/build"
ln -sf "$BUILD/odraz-safe" "$HOUSE/build/odraz" # the packed film decodes for seconds
printf '#!/bin/sh\n' >"$WORK/bin/cmake" # all is built already
chmod +x "$WORK/bin/cmake"
export PATH="$WORK/bin:$PATH"
cd "$HOUSE" || exit 1

runs() { # runs COMMAND: it succeeds, and there is something in the file after -o
    local made
    eval "$1" >"$WORK/ran" 2>&1 </dev/null || { echo "    exit $?: $(tail -n 5 "$WORK/ran")" >&2; return 1; }
    made=$(grep -oP -- '(?<= -o )\S+' <<<"$1") || return 0
    [ -s "$made" ] || { echo "    $made was not made" >&2; return 1; }
}
for page in $PAGES; do
    perl "$PARTS/blocks.pl" "$page" | cut -d ' ' -f 2- | grep -E '^(build|tools|packer)/' | grep -vE "$NOT_RUN" >"$WORK/commands"
    while IFS= read -r command; do check "$page: $command" runs "$command"; done <"$WORK/commands"
done
check "... $CHECKS commands" [ $CHECKS -ge 15 ]

# --- Every program has a help, and refuses what it does not know in one line ---
mkdir "$WORK/help"
PROGRAMS=$(find -L build -maxdepth 1 -type f -perm -u+x ! -name '*.elf' ! -name '*.exe' ! -name '*.so' | sort
    find tools -type f -perm -u+x ! -path 'tools/render_parts/*' ! -path 'tools/new_film/*' ! -name '*.py' | sort)
helps() { # helps PROGRAM: its help, and that of its commands
    local to=$WORK/help/${1//\//:} command
    timeout "$PATIENCE" "$1" --help >"$to" 2>"$WORK/err" </dev/null && [ -s "$to" ] && [ ! -s "$WORK/err" ] || return
    # (tools/test gives such options to ctest; tools/watch plays)
    case $1 in tools/test | tools/watch) ;; *) refuses 2 "" "$1" --no-such-option || return ;; esac
    for command in $(sed -n '/^Subcommands:/,/^$/s/^  *\([a-z0-9-]*\)  .*/\1/p' "$to"); do
        "$1" "$command" --help >>"$to" 2>"$WORK/err" || return
        refuses 2 "" "$1" "$command" --no-such-option || return
    done
}
all_help() {
    local program wrong=0
    for program in $PROGRAMS; do helps "$program" || { echo "$program --help: $(head -c 200 "$WORK/err")" >&2; wrong=1; }; done
    return $wrong
}
check "every program and script has a --help, and refuses an unknown option" all_help
check "... $(wc -w <<<"$PROGRAMS") of them" [ "$(wc -w <<<"$PROGRAMS")" -ge 25 ]

# --- What the pages name is there, and their lines fit the width ---
wide() { # comments do not count, and a table or an address cannot be wrapped
    perl -CSD -ne 'chomp; s/<!--.*?-->//g; if (length > 120 && !/^\||https?:/) { print STDERR "    $ARGV:$.: ", length, "\n"; $bad = 1 }
        close ARGV if eof; END { exit($bad ? 1 : 0) }' "$@"
}
check "lines of pages are at most 120 characters long, tables apart" wide $PAGES
(cd "$SOURCE" && git ls-files) >"$WORK/files"
ninja -C "$BUILD" -t targets all | sed 's/:.*//' | sort -u >"$WORK/targets"
grep -rhoIE --exclude='*.md' --exclude=pages.sh --exclude-dir=pages --exclude-dir=build '[A-Za-z_][A-Za-z0-9_]*' . | sort -u >"$WORK/words"
all_there() { perl "$PARTS/named.pl" "$1" "$WORK/files" "$WORK/targets" "$WORK/words" "$WORK/help"; }
for page in $PAGES; do check "what $page names is there" all_there "$page"; done

# Planted mistakes are found
for wrong in '`intro/nothing.h`' '`build/nothing`' '[a link](nothing.md)' '`tools/test --nothing`' '`--nothing`' '`kNoSuchTable`' \
    '`noSuchThing()`' '    cmake --build build --target nothing'; do
    echo "$wrong" >"$WORK/wrong.md"
    check "(it would be found that there is no $wrong)" eval '! all_there "$WORK/wrong.md" 2>/dev/null'
done
printf '%0121d\n' 0 >"$WORK/wrong.md"
check "(... and that a line is too long)" eval '! wide "$WORK/wrong.md" 2>/dev/null'
check "(... and that a command fails, or makes nothing)" eval '! runs false 2>/dev/null && ! runs "true -o nothing" 2>/dev/null'
finish
