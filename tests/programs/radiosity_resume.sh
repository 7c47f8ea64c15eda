# radiosity solve --resume: what was stopped goes on, to the bytes of what nobody stopped.
. "$(dirname "$0")/common.sh"
radiosity=$BUILD/radiosity
needs_built radiosity
cd "$WORK" || exit 1

"$radiosity" generate terrain -o hills.obj >/dev/null
check "a solution that nobody stops" "$radiosity" solve hills.obj -o whole.rad
check "... leaves no state" test ! -e whole.rad.state
stopped() { # stopped SIGNAL STATES: after so many states were kept
    rm -f hills.rad*
    "$radiosity" solve hills.obj -o hills.rad --keep-every 0.01 >out 2>&1 &
    local pid=$! seen=0 last= now
    while [ $seen -lt "$2" ] && ! gone $pid; do
        now=$(stat -c %i hills.rad.state 2>/dev/null)
        [ "$now" = "$last" ] || { last=$now; seen=$((seen + 1)); }
    done
    kill -"$1" $pid
    wait $pid
    [ -e hills.rad.state ]
}
for how in "INT 1" "INT 40" "KILL 3" "KILL 60"; do
    # shellcheck disable=SC2086
    check "$how" stopped $how
    check "... goes on" prints 'sweeps, residual' "$radiosity" solve --resume hills.rad.state
    check "... to the same bytes" cmp whole.rad hills.rad
    check "... and leaves no state" test ! -e hills.rad.state
done
stopped INT 2
check "what Ctrl-C wrote can be shown" "$radiosity" export hills.rad --csv hills.csv
check "... and it tells how to go on" grep -q 'solve --resume hills.rad.state goes on' out
check "--resume with more" refuses 2 "stands alone" "$radiosity" solve hills.obj --resume hills.rad.state
check "no state" refuses 2 "was not left by" "$radiosity" solve --resume hills.rad
head -c 100000 hills.rad.state >cut.state
check "a state cut short" refuses 2 "is damaged" "$radiosity" solve --resume cut.state
echo 'v 9 9 9' >>hills.obj
sed -i '0,/^v /s/^v [^ ]*/v 0.5/' hills.obj
check "a model that changed" refuses 2 "another model" "$radiosity" solve --resume hills.rad.state
finish
