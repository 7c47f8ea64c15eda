# The film's page in Chromium, Firefox and WebKit: golden pictures, music, and playing. Its player is also tested alone,
# on a simulated clock, with a stated time for each picture.
. "$(dirname "$0")/display.sh"
skip_unless node chromium firefox-esr WebKitWebDriver pulseaudio pactl
[ -s "$BUILD/$FILM.html" ] || { echo "there is no $BUILD/$FILM.html: build film_web first"; exit 77; }
start_display 1280x800
export TMPDIR=$WORK # for the browsers' profiles
# A sound server whose device is in memory: in WebKit the clock of a sound stands still without one
export HOME=$WORK XDG_RUNTIME_DIR=$WORK/run
mkdir -m 700 "$XDG_RUNTIME_DIR"
pulseaudio -n --daemonize=no --exit-idle-time=-1 -L module-native-protocol-unix -L module-null-sink >/dev/null 2>&1 &
PIDS+=($!)
await pactl info >/dev/null 2>&1
program=$BUILD/intro/host/web/$FILM.wasm scripts=$SOURCE/intro/host/web
check "simulated player" node "$SOURCE/tests/programs/web/player.mjs" "$program" \
    "$scripts/"{plain,pictures,music,page}.js
check "a page over budget" refuses 1 "over budget by " "$BUILD/page" "$program" "${program%/*}/decode.wasm" "$scripts/page."{model,html} "$scripts/"{worker,page}.js "$WORK/over.html" 9
check "the page's comment has no byte that HTML would change, and does not end early" \
    perl -0777 -ne 'my ($text) = /<!--(.*?)--><script>/s; exit !(length $text > 50000 && "-$text" !~ /[\0\r]|[-!]>/)' "$BUILD/$FILM.html"
mkdir "$WORK/plain" "$WORK/chromium" "$WORK/firefox" "$WORK/webkit"
check "plain SIMD" node "$SOURCE/tests/programs/web/plain.mjs" "$program" "$scripts/plain.js" "$WORK/plain" $FILM_TRACED
for t in $FILM_TRACED; do
    golden=$(printf '%s/tests/golden/film-%03d.png' "$SOURCE" "$t")
    check "plain SIMD: the picture at $t s" "$BUILD/compare" "$golden" "$WORK/plain/$t.ppm" --psnr 65
done
browsers=(${BROWSERS:-chromium firefox webkit})
for i in "${!browsers[@]}"; do
    browser=${browsers[i]} out=$WORK/${browsers[i]}
    # WebKit draws all golden pictures, the others every second one, and all of them the first in the hall
    moments=$(printf '%s\n' $FILM_LIT $FILM_TRACED | awk -v i=$i 'i == 2 || NR % 2 == i || NR == 1')
    check "$browser" timeout "$PATIENCE" node "$SOURCE/tests/programs/web/page.mjs" $browser "$BUILD/$FILM.html" \
        "$out" $moments
    for t in $moments; do
        within=()
        golden=$(printf '%s/tests/golden/film-%03d.png' "$SOURCE" "$t")
        if [[ " $FILM_LIT " = *" $t "* ]]; then
            within=(--psnr 50) # rays find the hall's light, not OpenGL
        elif [ -e "$out/plain" ]; then
            golden=$WORK/plain/$t.ppm
        fi
        check "$browser: the picture at $t s" "$BUILD/compare" "$golden" "$out/$t.ppm" "${within[@]}"
    done
    [ $browser != chromium ] || check "the music" cmp "$WORK/chromium/music.sha256" "$SOURCE/tests/golden/music.sha256"
done
lit=${FILM_LIT%% *}.ppm
check "Chromium and Firefox draw the same hall" cmp "$WORK/chromium/$lit" "$WORK/firefox/$lit"
finish
