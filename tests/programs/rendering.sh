# Sourced by the tests of tools/render, which make the same 30 frames in many ways.
. "$(dirname "$0")/common.sh"
skip_unless ffmpeg ffprobe
film=$BUILD/odraz-safe
render=$SOURCE/tools/render
span=(--from 39.2 --to 40.4 --fps 25) # across a cut, 30 frames, none of the hall
small=("${span[@]}" --size 160x90 --quality draft)
to=$WORK/to
mkdir "$to"
rendered() { "$render" --film "$film" "$@" >"$WORK/out" 2>"$WORK/err" || { cat "$WORK/err" >&2; return 1; }; }
parts_gone() { [ -z "$(find "$WORK" -name '*.parts')" ]; }
same_video() { cmp "$to/one.mp4" "$1" && cmp "$to/one.mp4.manifest" "$1.manifest"; }
same_frames() { diff -r "$to/one" "$1" && cmp "$to/one.manifest" "$1.manifest"; }

# Ctrl-C, as a terminal sends it: to all of them
interrupted() { # interrupted OUT OPTION...
    local began
    set -m
    "$render" --film "$film" --from 30 --to 50 --size 320x180 --quality draft --shard 10 "${@:2}" "$1" >"$WORK/out" 2>"$WORK/err" &
    began=$!
    set +m
    PIDS+=($began)
    await eval "ls '$1.parts'/*.sums >/dev/null 2>&1 || gone $began"
    kill -INT -- "-$began"
    ended $began
    [ $? = 130 ] && grep -qx 'tools/render: stopped; --resume goes on from here' "$WORK/err"
}
all_gone() { ! grep -lqF "$to" /proc/[0-9]*/cmdline 2>/dev/null && ! ls -l /proc/[0-9]*/cwd 2>/dev/null | grep -qF "$to"; }
