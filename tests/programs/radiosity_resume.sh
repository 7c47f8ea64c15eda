# radiosity solve --resume: a solution that was stopped goes on, and ends with the bytes of one that was not.
# With "all" as the second argument it is stopped in more steps and by more signals.
. "$(dirname "$0")/radiosity_program.sh"
all=${2-}

for kind in terrain columns; do "$radiosity" generate $kind -o $kind.obj >/dev/null; done
sed -i 's/^Kd .*/Kd 0.95 0.95 0.95/' columns.mtl # solving it takes some 170 sweeps
# stopped SIGNAL STATES MODEL WORDS...: sends the signal after STATES states were kept or, where STATES is the name of
# a step, when that has begun and a state was kept. Tries again when the program ended before it was stopped
every=0.05
stopped() {
    local tries
    for tries in 1 2 3 4 5; do
        stopped_once "$@"
        [ ! -e part.rad.state ] || return 0
    done
    return 1
}
stopped_once() {
    local signal=$1 until=$2 pid seen=0 last='' now
    shift 2
    rm -f part.rad* err
    "$radiosity" solve "$@" -o part.rad --keep-every $every --progress >out 2>err &
    pid=$!
    if [[ $until = [a-z]* ]]; then
        until { [ -e part.rad.state ] && grep -q "^progress: $until" err; } 2>/dev/null || gone $pid; do sleep 0.01; done
    else
        while [ $seen -lt "$until" ] && ! gone $pid; do
            now=$(stat -c %i part.rad.state 2>/dev/null)
            if [ "$now" = "$last" ]; then sleep 0.01; else last=$now seen=$((seen + 1)); fi
        done
    fi
    kill -"$signal" $pid 2>/dev/null
    wait $pid
}
goes_on() { # SIGNAL STATES WORDS...
    check "$*" stopped "$@"
    [ "$1" = KILL ] || check "... it prints how to go on" grep -q '^to continue: radiosity solve --resume part.rad.state' out
    check "... goes on" prints 'sweeps, residual' "$radiosity" solve --resume part.rad.state
    check "... to the same bytes" cmp whole.rad part.rad
    check "... and leaves no state" test ! -e part.rad.state
}
check "a solution that is not stopped" "$radiosity" solve terrain.obj -o whole.rad
check "... leaves no state" test ! -e whole.rad.state
for how in "INT 4" ${all:+"KILL 9"}; do
    goes_on $how terrain.obj
done
every=0.01
rays=(columns.obj --element 0.5 --residual 1e-7)
check "of few elements" "$radiosity" solve -o whole.rad "${rays[@]}"
for how in "INT 1" "KILL solving" ${all:+"KILL 2" "INT solving"}; do
    goes_on $how "${rays[@]}"
done
gather=(columns.obj --element 1 --final 256)
check "with a final gather" "$radiosity" solve -o whole.rad "${gather[@]}"
for how in "KILL final" ${all:+"INT final"}; do
    goes_on $how "${gather[@]}"
done

# Between patches
every=0.05
patches=(columns.obj --hemicube 64 --patch 1 --residual 1e-7)
check "between patches" "$radiosity" solve -o whole.rad "${patches[@]}"
check "... no state is left" test ! -e whole.rad.state
for how in "KILL 5" "INT solving" ${all:+"INT 1" "KILL solving"}; do
    goes_on $how "${patches[@]}"
done
twice() { # stopped, and once more, at once
    stopped INT 2 "${patches[@]}" || return
    rm err
    "$radiosity" solve --resume part.rad.state >out 2>err &
    until grep -qs '^progress: form factors' err || gone $!; do sleep 0.01; done
    kill -INT $!
    wait $!
    [ -e part.rad.state ]
}
check "stopped twice" twice
check "... goes on" prints 'sweeps, residual' "$radiosity" solve --resume part.rad.state
check "... to the same bytes" cmp whole.rad part.rad

stopped INT 2 terrain.obj
check "what Ctrl-C wrote can be shown" "$radiosity" export part.rad --csv part.csv
check "--resume with more" refuses 2 "takes no other option" "$radiosity" solve terrain.obj --resume part.rad.state
check "no state" refuses 2 "is not a state of" "$radiosity" solve --resume part.rad
head -c 100000 part.rad.state >cut.state
check "a state cut short" refuses 2 "is damaged" "$radiosity" solve --resume cut.state
echo 'v 9 9 9' >>terrain.obj
sed -i '0,/^v /s/^v [^ ]*/v 0.5/' terrain.obj
check "a model that changed" refuses 2 "another model" "$radiosity" solve --resume part.rad.state
# A material's picture is part of the model, too
paint() { printf '\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\30\0\100\100%b' "$1" >paint.tga; } # one texel; its red
echo 'map_Kd paint.tga' >>columns.mtl
paint '\0200'
check "a model with a picture, stopped" stopped INT 1 "${rays[@]}"
paint '\0300'
check "... whose picture changed" refuses 2 "another model" "$radiosity" solve --resume part.rad.state
paint '\0200'
check "... and was changed back" prints 'sweeps, residual' "$radiosity" solve --resume part.rad.state
finish
