# radiosity solve --progress: lines for scripts, a bar on a terminal, nothing without the option.
. "$(dirname "$0")/radiosity_program.sh"
skip_unless script

"$radiosity" generate columns -o m.obj >/dev/null
check "without --progress" bash -c "'$radiosity' solve m.obj -o m.rad --hemicube 32 >out 2>quiet"
check "... nothing is printed" test ! -s quiet
check "with --progress" bash -c "'$radiosity' solve m.obj -o again.rad --hemicube 32 --progress >out 2>lines"
check "... the same comes out" cmp m.rad again.rad
check "... every line has one form" bash -c "! grep -vE '^progress: (dividing|form factors|direct light|solving) [0-9]+ %(, residual [-+0-9.e]+)?(, [0-9]+ s left)?\$' lines"
for step in dividing "form factors" "direct light" solving; do
    check "... it reports when $step begins" grep -q "^progress: $step " lines
done
for step in dividing "form factors" solving; do
    check "... and when $step ends, once" test "$(grep -c "^progress: $step 100 %" lines)" = 1
done
check "... in their order, and never back" awk '{ n = $0; sub(/ %.*/, "", n); sub(/.* /, "", n); s = $0; sub(/ [0-9]+ %.*/, "", s)
    if (s == last && n + 0 < was) exit 1; if (s != last && seen[s]++) exit 1; last = s; was = n + 0 }' lines
check "... and not one for every patch" test "$(wc -l <lines)" -lt 200
# There are first rays, and when direct light is known, the further ones that are needed
check "with final gathering" bash -c "'$radiosity' solve m.obj -o again.rad --final 8 --progress >out 2>lines"
for step in dividing "form factors" "direct light" solving "final rays"; do
    check "... $step ends, once" test "$(grep -c "^progress: $step 100 %" lines)" = 1
done
check "... and no line goes back" awk '{ n = $0; sub(/ %.*/, "", n); sub(/.* /, "", n); s = $0; sub(/ [0-9]+ %.*/, "", s)
    if (n + 0 < was[s]) exit 1; was[s] = n + 0 }' lines
# Longer work reports the time left
behind "$radiosity" solve m.obj -o long.rad --hemicube 256 --progress
check "time left is reported, until it is stopped" stopped_at '^progress: form factors [1-9][0-9]? %, [0-9]+ s left$' err
script -qefc "'$radiosity' solve m.obj -o m.rad --progress --hemicube 64" terminal >/dev/null </dev/null
check "a terminal has its bar" grep -qaE 'form factors +\[[#.]{30}\]' terminal
check "... with time left" grep -qaE 's left' terminal
check "... and no lines" bash -c "! grep -qa progress: terminal"
finish
