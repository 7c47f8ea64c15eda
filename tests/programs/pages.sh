# The pages' links lead to files that exist, and their lines have at most 120 characters.
. "$(dirname "$0")/common.sh"
skip_unless perl git
cd "$SOURCE" || exit 1
# (RESULTS.md is generated; the pages of a new film are templates)
PAGES=$(git ls-files '*.md' | grep -vE '^tools/(measure/RESULTS\.md$|film_template/)')
dead() { # prints links to files that do not exist, from the page's folder
    perl -ne '($folder) = $ARGV =~ m{^(.*/)?}; print "$ARGV: $1\n" for grep { !-e ($folder // "") . $_ } /\]\((?!https?:)([^)#]+)/g' "$@"
}
wide() { # prints lines that are too long. Comments do not count, and a table or an address cannot be wrapped
    perl -CSD -ne 'chomp; s/<!--.*?-->//g; print "$ARGV:$.\n" if length > 120 && !/^\||https?:/; close ARGV if eof' "$@"
}
none() { "$@" >"$WORK/found" && [ ! -s "$WORK/found" ] || { cat "$WORK/found" >&2; return 1; }; }
check "no link is dead" none dead $PAGES
check "lines are at most 120 characters long, except in tables" none wide $PAGES
printf '%s %0121d\n' '[a](nothing.md)' 0 >"$WORK/wrong.md"
check "(both faults would be found)" eval '! none dead "$WORK/wrong.md" 2>/dev/null && ! none wide "$WORK/wrong.md" 2>/dev/null'
finish
