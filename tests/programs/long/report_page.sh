# The page of tools/ledger pack --html in a browser: it opens, adds up, answers mouse and keys, shows the same
# instructions as objdump, and prints nothing on its console.
. "$(dirname "$0")/../common.sh"
skip_unless chromium objdump convert perl
page=$WORK/film.html
check "the film's page" env BUILD="$BUILD" "$SOURCE/tools/ledger" pack --html "$page" --than "$SOURCE/intro/size_ledger.json" >/dev/null
check "... adds up" prints '^[0-9]+ bytes of [0-9]+, [0-9]+ stretches, [1-9][0-9]{4} instructions$' perl "$SOURCE/tests/programs/report/page.pl" "$page" sums
check "... has at most 640 KB" test "$(stat -c %s "$page")" -le 655360
perl -pe 'BEGIN { local $/; open F, "<", shift; $poke = <F> } s{</body>}{<script>$poke</script></body>}' "$SOURCE/tests/programs/report/poke.js" "$page" >"$WORK/poked.html"
browse() { # browse OPTION... ADDRESS, without a network
    timeout "$PATIENCE" chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr --user-data-dir="$WORK/profile" \
        --host-resolver-rules='MAP * ~NOTFOUND' --window-size=1400,1440 --virtual-time-budget=60000 "$@" 2>"$WORK/console"
}
silent() { ! grep -i ':CONSOLE' "$WORK/console" >&2; }
check "it opens" eval 'browse --dump-dom "file://$page" >"$WORK/dom"'
check "... complete" grep -q 'data-ready="yes"' "$WORK/dom"
check "... and prints nothing on the console" silent
check "a script uses the page" eval 'browse --dump-dom "file://$WORK/poked.html" >"$WORK/dom"'
grep -o 'data-failed="[^"]*"' "$WORK/dom"
check "... and all its checks pass" grep -q 'data-failed=""' "$WORK/dom"
check "... at least thirty of them" grep -qE 'data-checked="[3-9][0-9]"' "$WORK/dom"
check "... without a line on the console" silent
# Compare instructions, without objdump's symbols
objdump -d -w -z -M intel --no-show-raw-insn "$BUILD/odraz.elf" |
    sed -nE 's/^ *([0-9a-f]+):\t/\1 /; t found; d; :found; s/ *<.*//; s/  +/ /g; s/ $//; p' | sort >"$WORK/by_objdump"
perl -0ne 'if (/<pre class="instructions">(.*?)<\/pre>/s) { print "$1\n" }' "$WORK/dom" | sort >"$WORK/by_page"
check "objdump prints something" test "$(wc -l <"$WORK/by_objdump")" -gt 20000
check "... and the page shows the same" eval 'diff "$WORK/by_objdump" "$WORK/by_page" | head -5 >&2; cmp "$WORK/by_objdump" "$WORK/by_page"'
check "a screenshot of the page" browse --hide-scrollbars --screenshot="$WORK/page.png" "file://$page"
check "... has many colours" test "$(convert "$WORK/page.png" -format %k info:)" -gt 500
check "a narrow window" browse --hide-scrollbars --window-size=500,900 --screenshot="$WORK/narrow.png" "file://$page"
check "... silently" silent
# A damaged page shows an error
perl -pe 's{(id="tables">.{5000}).}{$1!}' "$page" >"$WORK/damaged.html"
check "a damaged page" eval 'browse --dump-dom "file://$WORK/damaged.html" >"$WORK/dom"'
check "... shows an error" grep -q 'This page cannot be shown' "$WORK/dom"

# The comment on a change, comparing the film with itself
check "a comment on the film" prints '^\*\*`odraz`: [0-9,]+ bytes\*\*, \+0 .* left of 65,536$' env BUILD="$BUILD" "$SOURCE/tools/ledger" pack --text - --than "$BUILD/odraz.json"
check "... which lists no changed symbol" grep -q '^No symbol changed by four bytes or more\.$' "$WORK/printed"
finish
