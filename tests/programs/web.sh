# The film's page in Chromium and Firefox: golden pictures, music, and playing. Its player is also tested alone, on a
# simulated clock, with a stated time for each picture.
. "$(dirname "$0")/display.sh"
skip_unless node chromium firefox-esr
[ -s "$BUILD/$FILM.html" ] || { echo "there is no $BUILD/$FILM.html: build film_web first"; exit 77; }
start_display 1280x800
export TMPDIR=$WORK # for the browsers' profiles
program=$BUILD/intro/host/web/$FILM.wasm scripts=$SOURCE/intro/host/web
check "simulated player" node "$SOURCE/tests/programs/web/player.mjs" "$program" \
    "$scripts/"{plain,pictures,music,page}.js
check "a page over budget" refuses 1 "over budget by " "$BUILD/page" "$program" "${program%/*}/decode.wasm" "$scripts/page."{model,html} "$scripts/"{worker,page}.js "$WORK/over.html" 9
mkdir "$WORK/plain" "$WORK/chromium" "$WORK/firefox"
check "plain SIMD" node "$SOURCE/tests/programs/web/plain.mjs" "$program" "$scripts/plain.js" "$WORK/plain" $FILM_TRACED
for t in $FILM_TRACED; do
    golden=$(printf '%s/tests/golden/film-%03d.png' "$SOURCE" "$t")
    check "plain SIMD: the picture at $t s" "$BUILD/compare" "$golden" "$WORK/plain/$t.ppm" --psnr 65
done
for browser in ${BROWSERS:-chromium firefox}; do
    out=$WORK/$browser
    # Every other golden picture; the other browser draws the rest
    moments=$(printf '%s\n' $FILM_TRACED $FILM_LIT | awk -v odd=$([ $browser = firefox ]; echo $?) 'NR % 2 == odd')
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
    if [ -e "$out/plain" ]; then
        echo "not checked: $browser has no relaxed SIMD, so its music is rounded in another way"
    else
        check "$browser: the music" cmp "$out/music.sha256" "$SOURCE/tests/golden/music.sha256"
    fi
done
finish
