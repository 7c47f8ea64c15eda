# The film plays its music to ALSA's file device, to a PulseAudio server that stops and is killed, and to no device. The
# tests with the server and without it run at the same time, each on its own display. (playback_test tests that a film
# that was stopped continues where it stopped.)
#   playing.sh BUILD [server]
. "$(dirname "$0")/display.sh"
. "$(dirname "$0")/recorded.sh"
[ -e /usr/share/alsa/alsa.conf ] || { echo "SKIPPED: libasound2 is not installed"; exit 77; }
odraz=$BUILD/odraz-safe # the packed film is the same program and starts seconds later
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
    # On a busy machine the film drops sound, as intended: then it is played again
    into_file() { rm -f "$WORK/played"; play "$@"; }
    check "plays with sound: the device gets what --wav writes, sample for sample" \
        await eval 'into_file --to 3 && is_music "$WORK/played" 1 0'
    check "... and prints nothing" prints_nothing
    check "... and no more than four seconds of it" test "$(frames "$WORK/played")" -lt $((4 * 48000))
    rm "$WORK/played"
    check "--mute plays" play --mute --to 1
    check "... in silence" test ! -e "$WORK/played"
    check "plays from the middle, with its sound" await eval 'into_file --from 50 --to 51.5 && is_loud "$WORK/played"'
    check "--mute without playing is refused" refuses 2 "--mute is for playing" "$odraz" --mute --wav "$WORK/none"
    devices 'pcm.!default { type hw card 31 }'
    check "plays without a device" play --to 1
    check "... and prints nothing" prints_nothing
    export ALSA_CONFIG_PATH=$WORK/none.conf
    check "plays where ALSA is broken" play --to 1
    check "... and prints nothing" prints_nothing
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
check "plays to a server what --wav writes, to the last bit" into_server 3 1 1
check "... and prints nothing" prints_nothing

# The film goes on while the server is stopped, is killed and is replaced; then ESC ends it
begins() { begin "$odraz" --window --size 160x90 && await focused; }
heard() { record "$WORK/heard" && comes 'is_loud "$WORK/heard"' && kill $recorder; }
check "plays on" begins
check "... and is heard" heard
kill -STOP $server
check "... while the server stops" worked $pid 30
kill -CONT $server
check "... and is heard again" heard
{ kill -KILL $server; wait $server; } 2>/dev/null
check "... when the server is killed" worked $pid 30
check "... and is heard by the next one" eval 'serve && heard'
check "ESC ends it, and nothing was printed" escapes
finish
