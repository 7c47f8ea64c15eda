# A dump that is killed at any moment leaves whole frames, and the frame that it was writing as FRAME.PID.part, since a
# killed process cannot clean up. A later dump ignores such a file.
#   killed.sh BUILD [KILLS] [SEED]
. "$(dirname "$0")/../common.sh"
kills=${2:-50} seed=${3:-$((EPOCHSECONDS % 30000))}
odraz=$BUILD/odraz-safe # the same program, which starts without unpacking
unset DISPLAY WAYLAND_DISPLAY
echo "    seed $seed"
RANDOM=$seed
cd "$WORK" || exit 1
# Ten frames, large enough to be killed while they are written
part=(--from 20 --to 20.4 --size 1280x720 --quality draft)
TIMEFORMAT='%U %S'
takes=$({ time "$odraz" --dump reference "${part[@]}"; } 2>&1 | awk '{ print int(100 * ($1 + $2)) + 1 }') # hundredths of a second of processor time
frames=$(ls reference | wc -l)
check "the reference has ten frames: $frames" test "$frames" = 10

parts=0 found=0 early=0 done=0
whole() { # every frame in dump/ is the reference's
    local frame
    for frame in dump/frame-*.ppm; do
        [ -e "$frame" ] || return 0
        cmp -s "$frame" "reference/${frame#dump/}" || { echo "$frame is not whole, or not that frame" >&2; return 1; }
        found=$((found + 1))
    done
}
only_known() { [ -z "$(ls dump | grep -vE '^frame-[0-9]{6}\.ppm(\.[0-9]+\.part)?$')" ]; }
killed() { # a dump that has ended before it is killed does not count
    local n pid left at
    for ((n = 1; done < kills || !found; ++n)); do
        rm -rf dump
        "$odraz" --dump dump "${part[@]}" 2>err &
        pid=$!
        # Kill it at a random moment; every second time, as soon as a random frame has a file
        at=$((RANDOM % 10))
        if [ $((n % 2)) = 0 ]; then
            until compgen -G "dump/frame-00050$at.ppm*" >/dev/null || gone $pid; do :; done
        else
            worked $pid $((RANDOM % takes))
        fi
        if kill -KILL $pid 2>/dev/null; then done=$((done + 1)); else early=$((early + 1)); fi
        wait $pid 2>/dev/null
        [ -d dump ] || continue
        whole && only_known || { echo "kill $n" >&2; return 1; }
        left=$(find dump -name '*.part' | wc -l)
        [ "$left" -le 1 ] || { echo "kill $n: $left files left behind" >&2; return 1; }
        parts=$((parts + left))
    done
}
check "$kills kills: every frame that was written is whole" killed
echo "    $found frames were written, $parts files *.part were left, $early dumps ended before the kill"

# A file like one that a killed dump leaves
mkdir -p dump
echo "half a frame" >dump/frame-000500.ppm.99999.part
check "a later dump into the same folder" "$odraz" --dump dump "${part[@]}"
check "... completes it" test "$(ls dump | grep -c 'ppm$')" = "$frames"
check "... with the same frames" whole
check "... and leaves unfinished files of other dumps alone" test "$(cat dump/frame-000500.ppm.99999.part)" = "half a frame"

# Two and four dumps of many small frames at once: they often write the same frame at the same time
part=(--from 20 --to 24 --size 16x9 --quality draft)
rm -rf reference
check "many small frames" "$odraz" --dump reference "${part[@]}"
together() { # together N: runs N dumps at once; succeeds if they write the reference and print nothing
    local n pids=() good=0
    rm -rf dump
    for ((n = 0; n < $1; ++n)); do
        "$odraz" --dump dump "${part[@]}" 2>err.$n &
        pids+=($!)
    done
    for n in "${pids[@]}"; do wait "$n" && good=$((good + 1)); done
    cat err.*
    [ $good = "$1" ] && [ -z "$(cat err.*)" ] && diff -r reference dump
}
for dumps in 2 2 4 4; do check "$dumps dumps at once into one folder: nothing is printed, and the frames are the same" together $dumps; done
finish
