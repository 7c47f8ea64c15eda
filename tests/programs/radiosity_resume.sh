# radiosity solve --resume continues a stopped solution, and writes the same bytes as without the stop.
# With "all" as the second argument it is stopped in more steps and by more signals.
. "$(dirname "$0")/radiosity_program.sh"
all=${2-}

"$radiosity" generate columns -o columns.obj >/dev/null
sed -i 's/^Kd .*/Kd 0.95 0.95 0.95/' columns.mtl # solving it takes some 170 sweeps
# stopped SIGNAL STEP WORDS...: solves, and sends the signal when the step has begun and a state was kept. Tries again
# if the program ended first
stopped() {
    local end=$((SECONDS + PATIENCE))
    while [ $SECONDS -lt $end ]; do
        stopped_once "$@"
        [ ! -e part.rad.state ] || return 0
    done
    return 1
}
stopped_once() {
    local signal=$1 step=$2 pid
    shift 2
    rm -f part.rad* err
    "$radiosity" solve "$@" -o part.rad --keep-every 0.01 --progress >out 2>err &
    pid=$!
    until { [ -e part.rad.state ] && grep -q "^progress: $step" err; } 2>/dev/null || gone $pid; do sleep 0.01; done
    kill -"$signal" $pid 2>/dev/null
    wait $pid
}
goes_on() { # goes_on SIGNAL STEP WORDS...: checks that a solution that was stopped in this way can be resumed
    check "$*" stopped "$@"
    [ "$1" = KILL ] || check "... it prints how to continue" grep -q '^to continue: radiosity solve --resume part.rad.state' out
    check "... is resumed" prints 'sweeps, residual' "$radiosity" solve --resume part.rad.state
    check "... to the same bytes" cmp whole.rad part.rad
    check "... and leaves no state" test ! -e part.rad.state
}
rays=(columns.obj --element 1 --residual 1e-7)
check "a solution that is not stopped" "$radiosity" solve -o whole.rad "${rays[@]}"
check "... leaves no state" test ! -e whole.rad.state
for how in "INT form" "KILL solving" ${all:+"KILL form" "INT solving"}; do
    goes_on $how "${rays[@]}"
done
gather=(columns.obj --element 4 --final 128)
check "with a final gather" "$radiosity" solve -o whole.rad "${gather[@]}"
for how in "KILL final" ${all:+"INT final"}; do
    goes_on $how "${gather[@]}"
done

# A state belongs to one model, of which the materials' pictures are a part
paint() { printf '\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\30\0\100\100%b' "$1" >paint.tga; } # paint RED: writes a picture of one texel
echo 'map_Kd paint.tga' >>columns.mtl
paint '\0200'
check "a model with a picture, stopped" stopped INT form "${rays[@]}"
check "... has written its elements" eval '"$radiosity" export part.rad --csv part.csv && table part.csv "a += \$8" "lines > 1000"'
head -c 100000 part.rad.state >cut.state
check "a state cut short" refuses 2 "is damaged" "$radiosity" solve --resume cut.state
paint '\0300'
check "a state whose model has another picture now" refuses 2 "another model" "$radiosity" solve --resume part.rad.state
paint '\0200'
check "... and the first one again" prints 'sweeps, residual' "$radiosity" solve --resume part.rad.state
finish
