# tools/watch from a clone, without a display and with one.
#   watch.sh BUILD [full]     with `full` it builds, and makes the whole video. Otherwise it uses built programs, and
#                             the film has 24 s and small frames
. "$(dirname "$0")/display.sh"
skip_unless ffmpeg ffprobe g++
needs_built contact_sheet
(
    . "$SOURCE/tools/build/packages.sh"
    install() { false; }
    sudo() { false; }
    need_for_building && eval "$(grep '^need "the contact sheet' "$SOURCE/tools/watch")"
) 2>/dev/null || { echo "SKIPPED: it would install packages"; exit 77; }
house="$WORK/a house"
[ "${2-}" != full ] || house=$WORK/house
to=$house/build
copy_sources "$house"
mkdir -p "$WORK/bin" "$to"
# A stand-in for CMake, whose build ends when tools/watch has printed its step count
cat >"$WORK/bin/cmake" <<END
#!/bin/bash
[ \$1 = --build ] || exit 0
[ ! -e "$WORK/broken" ] || { echo "no compiler"; exit 1; }
echo "[1/2] half of it"
for ((i = 0; i < 10 * $PATIENCE; ++i)); do
    ! grep -q '^building: \[1/2\], [0-9]* s\$' "$WORK/err" || break
    sleep 0.1
done
cp "$BUILD/$FILM" "$BUILD/contact_sheet" "$to"
END
cat >"$WORK/bin/film" <<END
#!/bin/bash
[ \$1 != --wav ] || set -- "\$@" --to 24
exec "$BUILD/$FILM-safe" "\${@/640x360/64x36}"
END
length=2
ln -s "$WORK/bin/film" "$to/$FILM-safe"
chmod +x "$WORK"/bin/*
if [ "${2-}" = full ]; then
    rm -r "$to"
    length=16
else
    export PATH="$WORK/bin:$PATH"
fi

in_background env -u DISPLAY "$house/tools/watch"
check "without a display it ends with status 0" ended $pid
check "... first prints what it does and how long it takes" eval \
    'sed -n 1p "$WORK/err" | grep -q "^building the film: about two minutes .* log in .*/build/build.log$"'
check "... prints that there is no display, before it builds" eval 'sed -n "/^no display/,\$p" "$WORK/err" | grep -q "^building: "'
check "... makes a contact sheet of 33 frames" prints ' 1956x1560 ' identify "$to/film.png"
probe() { ffprobe -v error -show_entries stream=codec_name,duration -of csv=p=0 "$to/film.mp4" | tr '\n' ' '; }
check "... and a video of $length seconds, one second of every ten, with sound" test "$(probe)" = "h264,$length.000000 aac,$length.000000 "

touch "$WORK/broken"
export PATH="$WORK/bin:$PATH"
in_background env DISPLAY=:99999999 "$house/tools/watch"
ended $pid
check "a build that fails ends it with status 1" test $? = 1
check "... and prints why" grep -qx 'no compiler' "$WORK/err"
check "a display that cannot be opened counts as none" grep -q '^no display (DISPLAY is :99999999, ' "$WORK/err"

rm "$WORK/broken"
start_display 640x400
begin "$house/tools/watch" --mute
check "with a display the film plays" seen
check "... as large as the screen" measures 640 400
check "ESC ends it with status 0" eval 'xdotool key Escape; ended $pid'
finish
