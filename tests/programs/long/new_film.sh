# tools/new-film as a whole: a film with a long name is made, built, packed and tested, and nothing in it is called
# odraz.
. "$(dirname "$0")/../common.sh"
skip_unless git strings zip unzip ffprobe
name=wunderkmr film=$WORK/film # nine letters: with -safe the longest name that the packer's stub has room for
check "a new film is made, packed and tested" prints "^build/$name: [0-9]+ bytes, [0-9]+ left of 65536" "$SOURCE/tools/new-film" "$film" $name --test
check "... all of its tests pass" grep -q '^100% tests passed' "$WORK/printed"
check "... at least thirty of them" test "$(ctest --test-dir "$film/build" -N | sed -n 's/Total Tests: //p')" -ge 30
check "it is a repository, and all of it is committed" test -d "$film/.git" -a -z "$(git -C "$film" status --porcelain)"
check "it is far smaller than its budget" test "$(stat -c %s "$film/build/$name")" -lt 49152
check "its rooms keep to their shares" eval '"$film/tools/ledger" rooms >/dev/null 2>"$WORK/err" && [ ! -s "$WORK/err" ]'
check "--version names its commit" prints "^$name 0.1.0 $(git -C "$film" rev-parse --short=12 HEAD)\$" "$film/build/$name" --version

# Neither the packed files nor the programs in them name odraz
for file in $name $name.exe; do
    check "$file is unpacked" "$film/build/pack" -d "$film/build/$file" -o "$WORK/plain-$file"
done
for file in "$film/build/$name"{,.exe,-safe,-safe.exe} "$WORK/plain-$name"{,.exe}; do
    strings -n 4 "$file" | tr A-Z a-z >"$WORK/strings"
    check "${file##*/} does not name odraz" lacks odraz "$WORK/strings"
done
check "(the name in this film would be found)" eval 'strings -n 4 "$BUILD/odraz-safe" | grep -q odraz'
check "it names $name-safe where it may not run packed" grep -qa "use $name-safe" "$film/build/$name"

# Its archives have its texts, not those of odraz
check "archives are made of it" eval '"$film/tools/release" --built --no-capture --poster "$film/tests/golden/film-006.png" >/dev/null'
check "... of the film alone, with its page and an index if the page is built" test "$(ls "$film/build/release" | wc -l)" = $((2 + 2 * $(ls "$film/build/$name.html" 2>/dev/null | wc -l)))
tar -C "$WORK" -xzf "$film/build/release/$name-0.1.0.tar.gz"
for text in $name.nfo README.txt file_id.diz; do check "... whose $text does not name odraz" lacks odraz "$WORK/$name-0.1.0/$text"; done
check "... and a licence of this year" grep -qx "Copyright (c) $(date +%Y) the $name team" "$WORK/$name-0.1.0/LICENSE.txt"

# The pictures: the scene is lit, the word is written, the end is dark
frames=$WORK/frames small=(--size 160x90 --quality draft)
mean() { tail -c +15 "$frames/frame-0000$1.ppm" | od -An -v -tu1 | awk '{ for (i = 1; i <= NF; ++i) sum += $i; n += NF } END { print sum / n }'; }
"$film/build/$name-safe" --dump "$frames" --fps 1 "${small[@]}"
check "ten pictures" test "$(ls "$frames" | wc -l)" = 10
for second in 1 3 5 7; do check "second $second is lit" less 40 "$(mean 0$second)"; done
check "it begins in the dark" less "$(mean 00)" 10
check "the word changes the picture" eval 'less 0.5 "$("$BUILD/compare" "$frames/frame-000003.ppm" "$frames/frame-000006.ppm" | sed -n "s/.*difference \([0-9.]*\),.*/\1/p")"'

check "without a display, tools/watch makes a video" env -u DISPLAY "$film/tools/watch"
check "... of one second" prints '^1\.0' ffprobe -v error -show_entries format=duration -of csv=p=0 "$film/build/film.mp4"

# The tests find faults
check "a changed picture is found" eval 'sed -i "s/{2.6f, 0.9f, 0.27f}/{0.9f, 2.6f, 0.27f}/" "$film/intro/show/scenes/stage.cpp" && cmake --build "$film/build" --target film >/dev/null && ! "$film/tools/golden" check >/dev/null'
check "... and passes when it is the golden one" eval '"$film/tools/golden" renew >/dev/null && "$film/tools/golden" check >/dev/null'
check "a budget that is too small stops the build" eval 'sed -i "s/^FILM_BUDGET=.*/FILM_BUDGET=30000/" "$film/intro/film.conf" && ! cmake --build "$film/build" --target film >"$WORK/log"'
check "... and prints the excess" grep -q 'over budget by [0-9]* bytes' "$WORK/log"
finish
