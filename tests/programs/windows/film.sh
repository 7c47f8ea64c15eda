# The film for Windows, run by Wine, against the film for Linux. Frames of every scene, the hall, in-betweens and sound
# are equal to the byte; refused options and failed outputs give the same line. Most runs use the film that is not
# packed, which starts sooner.
. "$(dirname "$0")/wine.sh"
linux=$BUILD/odraz-safe windows=$BUILD/odraz-safe.exe
# OpenGL under Wine needs X11
start_display 640x480
display=$DISPLAY
unset DISPLAY

both() { # both OPTION...: runs both films, into out.linux and out.windows; fails if a status is not 0
    "$linux" "$@" >"$WORK/out.linux" 2>"$WORK/err.linux" </dev/null || { cat "$WORK/err.linux" >&2; return 1; }
    timeout "$PATIENCE" env DISPLAY="$display" "$wine" "$windows" "$@" >"$WORK/out.windows" 2>"$WORK/err.windows" </dev/null || { echo "status $?: $(head -c 300 "$WORK/err.windows")" >&2; return 1; }
}
alike() { # alike OPTION...: succeeds if both films print the same, and something
    both "$@" && [ -s "$WORK/out.linux" ] && cmp "$WORK/out.linux" "$WORK/out.windows"
}
check "--version" alike --version
check "--help" alike --help
for from in 5 14 24 38 58 78 91 105 121 139 159; do
    check "a frame at $from s" alike --dump - --from $from --to $from.04 --size 160x90
done
check "the hall, large, in quality film" alike --dump - --from 100 --to 100.04 --size 640x360 --quality film
check "... and by three threads" alike --dump - --from 100 --to 100.04 --size 320x180 --threads 3
check "as it is played, with in-betweens" alike --dump - --from 30 --to 30.1 --fps 60 --size 160x90 --quality live
check "the music" alike --wav - --to 20

# Files
mkdir "$WORK/linux" "$WORK/windows"
same_files() {
    "$linux" --dump "$WORK/linux" --from 20 --to 20.2 --size 64x36 --wav "$WORK/linux/a.wav" &&
        "$wine" "$windows" --dump "$WORK/windows" --from 20 --to 20.2 --size 64x36 --wav "$WORK/windows/a.wav" &&
        [ "$(ls "$WORK/windows" | wc -l)" = 6 ] && diff -r "$WORK/linux" "$WORK/windows"
}
check "frames and music in files, and nothing else" same_files
check "... over existing files" same_files
check "a new folder with a name that is not ASCII" "$wine" "$windows" --dump "$WORK/Příliš žluťoučký kůň" --from 20 --to 20.04 --size 64x36
check "... has that name" cmp "$WORK/Příliš žluťoučký kůň/frame-000500.ppm" "$WORK/linux/frame-000500.ppm"
check "a name with blanks" "$wine" "$windows" --wav "$WORK/a  b .wav" --to 0.1
"$linux" --wav "$WORK/short.wav" --to 0.1
check "... has them" cmp "$WORK/a  b .wav" "$WORK/short.wav"

# Errors give the same status and line as on Linux
alike_refused() { # alike_refused STATUS TEXT OPTION...: succeeds if both films refuse alike
    local status=$1 text=$2
    shift 2
    refuses "$status" "$text" "$linux" "$@" && cp "$WORK/err" "$WORK/err.linux" &&
        refuses "$status" "$text" "$wine" "$windows" "$@" && cmp "$WORK/err" "$WORK/err.linux"
}
small=(--size 64x36 --from 20 --to 20.2 --quality draft)
check "an unknown option" alike_refused 2 "unknown option '--nope'" --nope
check "a value of unprintable characters" alike_refused 2 "not 'a?b?[31m'" --fps $'a\nb\e[31m'
check "a quotation mark" alike_refused 2 "not '\"'" --fps '"'
check "backslashes before quotation marks" alike_refused 2 "not 'a\\\\\"b c\\'" --fps 'a\\"b c\'
check "a name that Windows does not allow" refuses 1 "cannot write $WORK/a\"b: the system refused" "$wine" "$windows" --wav "$WORK/a\"b" --to 0.1
check "a folder in a file's place" alike_refused 1 "it is a directory" --wav "$WORK" --to 0.1
check "a full disk" refuses 1 "cannot write standard output: no space left on the device" bash -c "exec '$wine' '$windows' --dump - ${small[*]} >/dev/full"
check "a closed pipe" refuses 1 "cannot write standard output: the pipe was closed" bash -c "set -o pipefail; '$wine' '$windows' --dump - --from 20 --to 30 --size 320x180 --quality draft | head -c 99 >/dev/null"
check "no OpenGL for the hall" refuses 1 "no OpenGL 3.3: install" "$wine" "$windows" --dump - --from 100 --to 100.04 --size 64x36
check "... no opengl32.dll" refuses 1 "no OpenGL 3.3: install" env DISPLAY="$display" WINEDLLOVERRIDES="opengl32=;$WINEDLLOVERRIDES" "$wine" "$windows" --dump - --from 100 --to 100.04 --size 64x36
check "... an old OpenGL" refuses 1 "no OpenGL 3.3: install" env DISPLAY="$display" MESA_GL_VERSION_OVERRIDE=2.1 "$wine" "$windows" --dump - --from 100 --to 100.04 --size 64x36

# Packed
linux=$BUILD/odraz windows=$BUILD/odraz.exe
check "packed: --version" alike --version
check "packed: an unknown option" alike_refused 2 "unknown option '--nope'" --nope
check "packed: a frame" alike --dump - --from 24 --to 24.04 --size 160x90
check "packed: the hall" alike --dump - --from 121 --to 121.04 --size 160x90
check "packed: the music" alike --wav - --to 2

ls -A "$WORK" >"$WORK/list"
check "refusals leave nothing behind" lacks part "$WORK/list"
finish
