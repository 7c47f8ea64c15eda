# The film's music as it is played: to ALSA's file device, to a PulseAudio server that stops and dies, and to no device.
# Films play with the server and without it at the same time, each on a display of its own.
#   playing.sh BUILD [server]
. "$(dirname "$0")/display.sh"
. "$(dirname "$0")/recorded.sh"
[ -e /usr/share/alsa/alsa.conf ] || { echo "SKIPPED: libasound2 is not installed"; exit 77; }
odraz=$BUILD/odraz-safe # the packed film is the same program and takes seconds more to start
start_display 640x400
play() { "$odraz" --window --size 160x90 "$@" >"$WORK/out" 2>"$WORK/err"; }
prints_nothing() { [ ! -s "$WORK/err" ]; }
frames() { echo $(($(stat -c %s "$1") / 4)); }
"$odraz" --wav - --to 12 | tail -c +45 >"$WORK/film"

if [ "${2-}" != server ]; then
    bash "$0" "$BUILD" server >"$WORK/server" 2>&1 &
    with_server=$!
    PIDS+=($with_server)
    devices 'pcm.!default { type file slave.pcm "nothing" file "'"$WORK/played"'" format "raw" }' 'pcm.nothing { type null }'
    # A busy machine may be late, and then the film drops sound, as it should: then try again
    into_file() { for _ in {1..10}; do rm -f "$WORK/played"; play --to 4 && is_music "$WORK/played" 2 0 && return 0; done; return 1; }
    check "plays with sound: the device gets what --wav writes, sample for sample" into_file
    check "... and prints nothing" prints_nothing
    check "... no faster than it is played" test "$(frames "$WORK/played")" -lt $((5 * 48000))
    rm "$WORK/played"
    check "--mute plays" play --mute --to 1
    check "... in silence" test ! -e "$WORK/played"
    check "plays from the middle" play --from 50 --to 51.5
    check "... with its sound" is_loud "$WORK/played"
    check "--mute without playing is refused" refuses 2 "--mute is for playing" "$odraz" --mute --wav "$WORK/none"
    devices 'pcm.!default { type hw card 31 }'
    check "plays without a device" play --to 1
    check "... and prints nothing" prints_nothing
    export ALSA_CONFIG_PATH=$WORK/none.conf
    check "plays where ALSA is broken" play --to 1
    check "... and prints nothing" prints_nothing

    # A film that was stopped for three seconds goes on where it stopped
    devices 'pcm.!default { type null }'
    freezes() { # prints the whole seconds that it took
        local began=$SECONDS
        play --to 5 &
        local film=$!
        await seen || return 1
        sleep 2
        kill -STOP "$(pgrep -P $film -x odraz-safe || echo $film)"
        sleep 3
        kill -CONT "$(pgrep -P $film -x odraz-safe || echo $film)"
        wait $film && echo $((SECONDS - began))
    }
    check "a film stopped for 3 of its 5 seconds takes 8" test "$(freezes)" -ge 7
    check "... with a server, too" ended $with_server
    cat "$WORK/server"
    finish
fi

if ! can_serve; then
    echo "    PulseAudio is not installed: not tried"
    FINISHED=1
    exit 0
fi
devices 'pcm.!default { type pulse }'
check "a server starts" serve
check "plays to a server what --wav writes, to the last bit" into_server 4 2 1
check "... and prints nothing" prints_nothing

stops() {
    play --from 40 --to 52 &
    local film=$!
    await seen
    sleep 3
    kill -STOP $server
    sleep 2
    kill -CONT $server
    record "$WORK/after"
    wait $film || return 1
    kill $recorder
}
check "plays while the server stops for two seconds" stops
check "... and is heard again" is_loud "$WORK/after"
check "... and prints nothing" prints_nothing
dies() {
    play --from 40 --to 54 &
    local film=$!
    await seen
    sleep 2
    { kill -KILL $server; wait $server; } 2>/dev/null
    sleep 1
    serve
    record "$WORK/again"
    wait $film || return 1
    kill $recorder
}
check "plays on when the server is killed" dies
check "... and is heard by the next one" is_loud "$WORK/again"
check "... and prints nothing" prints_nothing
finish
