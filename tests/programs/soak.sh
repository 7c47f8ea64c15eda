# The film in a window for some minutes: whole, then from a random moment, and so on in turns; the last run is cut
# short. Every scene is shown. Each run ends by itself and prints nothing on standard error. After its first third it
# takes no more memory, descriptors or threads, and never more than the whole film. It plays to a PulseAudio server, if
# there is one.
#   soak.sh BUILD [MINUTES]
. "$(dirname "$0")/display.sh"
. "$(dirname "$0")/recorded.sh"
minutes=${2:-3} mute=--mute
LENGTH=164 # seconds of film
LEAST=6    # seconds of the shortest run
ROOM=8     # MB by which a run may grow after its first third, for scenes that it has not shown before
cp "$BUILD/odraz" "$WORK/film" # a copy, because the original may be rebuilt meanwhile
start_display 1280x720
if can_serve; then
    devices 'pcm.!default { type pulse }'
    check "a server starts" serve
    mute=
fi

# looks SECONDS: samples the process each second: prints milliseconds, MB, descriptors, threads; kills it when it hangs
looks() {
    local began=${EPOCHREALTIME/[.,]/} at descriptors
    until gone $pid; do
        at=$(((${EPOCHREALTIME/[.,]/} - began) / 1000))
        [ $at -lt $((($1 + PATIENCE) * 1000)) ] || kill -KILL $pid
        descriptors=$(ls "/proc/$pid/fd" 2>/dev/null | wc -l)
        # (a process that is ending has neither memory nor descriptors)
        [ "$descriptors" = 0 ] || awk -v at=$at -v descriptors="$descriptors" \
            '/^VmRSS/ { mb = $2 / 1024 } /^Threads/ { print at, mb, descriptors, $2 }' "/proc/$pid/status" 2>/dev/null
        sleep 1
    done
}
# taken: sums up the samples of a run after its start, which lasts a second and 1.5 times the time of the first picture.
# Prints their number; the most memory, descriptors and threads; by how many MB memory exceeds that of the first third;
# the fewest descriptors and threads in the last third, less the most in the first third
taken() {
    awk -v first="$(sed -n 's/^first picture after \(.*\) s$/\1/p' "$WORK/out")" '
        first != "" && $1 >= 1500 * first + 1000 { ++n; for (k = 2; k <= 4; ++k) value[k, n] = $k }
        function most(k, a, b,  i, m) { m = value[k, a]; for (i = a; i <= b; ++i) if (value[k, i] > m) m = value[k, i]; return m }
        function least(k, a, b,  i, m) { m = value[k, a]; for (i = a; i <= b; ++i) if (value[k, i] < m) m = value[k, i]; return m }
        END {
            third = int((n + 2) / 3)
            printf "%d %.1f %d %d %.1f %d %d\n", n, most(2, 1, n), most(3, 1, n), most(4, 1, n),
                most(2, 1, n) - most(2, 1, third), least(3, n - third + 1, n) - most(3, 1, third),
                least(4, n - third + 1, n) - most(4, 1, third)
        }' "$WORK/looks"
}
shown() { awk -v scene="$1" '$1 == scene && $4 > 0 { on = 1 } END { exit !on }' "$WORK/out"; }

RANDOM=1
whole=()
for ((run = 1, end = SECONDS + $(awk "BEGIN { printf \"%d\", $minutes * 60 }"); end - SECONDS >= LEAST; ++run)); do
    from=$((run % 2 ? 0 : RANDOM % (LENGTH - LEAST))) left=$((end - SECONDS))
    to=$((from + left < LENGTH ? from + left : LENGTH))
    in_background "$WORK/film" --window --size 1280x720 --from $from --to $to --stats $mute
    looks $((to - from)) >"$WORK/looks"
    check "run $run, $from to $to s, ends with status 0" ended $pid
    [ $FAILED = 0 ] || finish
    check "... prints nothing on standard error" test ! -s "$WORK/err"
    read -r n mb descriptors threads mb_more descriptors_more threads_more <<<"$(taken)"
    echo "    $n samples: $mb MB, $descriptors descriptors, $threads threads at most"
    [ "$n" -ge 3 ] || continue # the machine is too busy for three samples: growth cannot be judged
    check "... within 512 MB" less "$mb" 512
    check "... takes at most $ROOM MB more after its first third" less "$mb_more" $ROOM.01
    check "... no more descriptors" test "$descriptors_more" -le 0
    check "... no more threads" test "$threads_more" -le 0
    if [ ${#whole[@]} != 0 ]; then
        check "... no more memory than the whole film" less "$mb" "$(awk "BEGIN { print ${whole[0]} + $ROOM.01 }")"
        check "... nor descriptors" test "$descriptors" -le $((whole[1] + 4))
        check "... nor threads" test "$threads" -le $((whole[2] + 4))
    elif [ $from-$to = 0-$LENGTH ]; then
        whole=("$mb" "$descriptors" "$threads")
        for scene in point table flake patches hall odraz credits; do check "... $scene is shown" shown $scene; done
    fi
done
finish
