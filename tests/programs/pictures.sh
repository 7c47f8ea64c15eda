# Dumped pictures: a frame depends only on its number, rate, size and quality.
. "$(dirname "$0")/common.sh"
odraz=$BUILD/odraz-safe # starts without unpacking; below, the packed film must draw the same
sums() { (cd "$1" && cksum ./*.ppm); }
dump() { # dump NAME OPTION...
    local to=$WORK/$1
    shift
    "$odraz" --dump "$to" --size 203x117 "$@"
}
interval=(--fps 30000/1001 --from 39.7 --to 40.3 --quality play) # across a cut

check "dump with one thread" dump one "${interval[@]}" --threads 1
check "... 18 pictures" test "$(ls "$WORK/one" | wc -l)" = 18
check "... that are not all the same" test "$(sums "$WORK/one" | cut -d' ' -f1 | sort -u | wc -l)" -gt 15
for threads in 2 64; do
    check "dump with $threads threads" dump many "${interval[@]}" --threads $threads
    check "$threads threads make the same pictures" cmp <(sums "$WORK/one") <(sums "$WORK/many")
    rm -r "$WORK/many"
done

"$odraz" --dump - --size 203x117 "${interval[@]}" >"$WORK/stream"
check "dump a stream" test $? = 0 -a -s "$WORK/stream"
check "the stream is the files, one after the other" cmp "$WORK/stream" <(cat "$WORK"/one/*.ppm)
"$BUILD/odraz" --dump - --size 203x117 "${interval[@]}" >"$WORK/packed"
check "the packed film draws the same" cmp "$WORK/stream" "$WORK/packed"

# In quality `live`, as the film is played, every other frame is made from its neighbours. The same rule holds, across a
# cut (40 s) and at the end
live=(--fps 60 --quality live --size 203x117)
"$odraz" --dump "$WORK/live" "${live[@]}" --from 39.8 --to 40.2 --threads 1
check "dump as it is played" test "$(ls "$WORK/live" | wc -l)" = 24
check "... with other threads, one frame alone" "$odraz" --dump "$WORK/within" "${live[@]}" --from 39.85 --to 39.86 --threads 5
check "... the picture between two others" test "$(ls "$WORK/within")" = frame-002391.ppm
check "... is the same" cmp "$WORK/within/frame-002391.ppm" "$WORK/live/frame-002391.ppm"
"$odraz" --dump "$WORK/traced" --fps 60 --quality play --size 203x117 --from 39.8 --to 40.2
check "as played, even frames are those of quality play" cmp <(cd "$WORK/live" && cksum ./*[02468].ppm) <(cd "$WORK/traced" && cksum ./*[02468].ppm)
check "... odd ones are not" eval '! cmp -s "$WORK/live/frame-002391.ppm" "$WORK/traced/frame-002391.ppm"'
check "the film's last frame is made in the same way" "$odraz" --dump "$WORK/last" "${live[@]}" --from 163.98
check "... alone" test "$(ls "$WORK/last")" = frame-009839.ppm
for size in 1x1 1x9 9x1 8x2; do
    check "as played, $size" test "$("$odraz" --dump - "${live[@]}" --size $size --from 60 --to 60.05 | wc -c)" = $((3 * (${size%x*} * ${size#*x} * 3 + ${#size} + 8)))
done

for size in 1x1 8x1 1x9 65x67; do
    "$odraz" --dump - --from 60 --to 60.04 --size $size >"$WORK/odd"
    check "dump $size" test $? = 0 -a "$(stat -c %s "$WORK/odd")" = $((${size%x*} * ${size#*x} * 3 + ${#size} + 8))
done
if command -v ffmpeg >/dev/null; then
    check "ffmpeg takes the stream" bash -c "set -o pipefail; '$odraz' --dump - --from 20 --to 20.4 --size 64x36 | ffmpeg -loglevel error -f image2pipe -c:v ppm -i - -f null -"
else
    echo "skipped: ffmpeg is not installed"
fi

# compare must find differences
printf 'P6\n2 1\n255\nabcdef' >"$WORK/a.ppm"
printf 'P6\n2 1\n255\nabcdez' >"$WORK/b.ppm"
check "compare finds equal pictures equal" prints 'largest difference 0,' "$BUILD/compare" "$WORK/a.ppm" "$WORK/a.ppm"
"$BUILD/compare" "$WORK/a.ppm" "$WORK/b.ppm" >"$WORK/printed"
check "compare finds a difference" grep -q 'largest difference 20,' "$WORK/printed"
check "compare exits 1 over the threshold" bash -c "'$BUILD/compare' '$WORK/a.ppm' '$WORK/b.ppm' --max 19 >/dev/null; [ \$? = 1 ]"
check "compare exits 0 within it" prints 'largest difference 20,' "$BUILD/compare" "$WORK/a.ppm" "$WORK/b.ppm" --max 20
check "compare refuses a file that is not a picture" refuses 2 "its format is unknown" "$BUILD/compare" "$WORK/a.ppm" "$BUILD/CMakeCache.txt"

for words in "base.ppm b.ppm --diff ./base.ppm" "b.ppm base.ppm --diff base.ppm" "--png base.ppm base.ppm"; do
    check "compare $words is refused" refuses 2 "base.ppm would be overwritten" bash -c "cd '$WORK' && cp a.ppm base.ppm && exec '$BUILD/compare' $words"
    check "... and changes nothing" cmp "$WORK/a.ppm" "$WORK/base.ppm"
done
check "a picture into a pipe" eval '"$BUILD/compare" --png "$WORK/a.ppm" /dev/stdout | cat >"$WORK/a.png" && "$BUILD/compare" "$WORK/a.png" "$WORK/a.ppm" >/dev/null'
check "a name like an option" refuses 2 "unknown option '-dash.png'; if it is a file, write ./-dash.png" "$BUILD/compare" -dash.png "$WORK/a.ppm"
check "contact_sheet does not write over its film" refuses 2 "would be overwritten" "$BUILD/contact_sheet" "$WORK/a.ppm" "$WORK/a.ppm"

# All channels, all bits and all pictures of a file count
differ() { # differ PATTERN COMMAND...: succeeds if the command exits with 1 and prints a line that matches
    "${@:2}" >"$WORK/printed"
    [ $? = 1 ] && grep -qE -- "$1" "$WORK/printed"
}
tga() { # tga BITS BYTES: prints a TGA of 1 x 1; 8 of 32 bits are alpha
    printf '\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0'"\\$(printf '%o\\%o' "$1" $((32 + ($1 == 32 ? 8 : 0))))$2"
}
tga 32 'abc\377' >"$WORK/opaque.tga"
tga 32 'abc\0' >"$WORK/clear.tga"
tga 24 'abc' >"$WORK/solid.tga"
check "pictures differ in alpha alone" differ 'largest difference 255, 1 of 1 pixels differ, 1 in alpha$' "$BUILD/compare" "$WORK/opaque.tga" "$WORK/clear.tga" --diff "$WORK/diff.png"
check "... and the differences show it" prints 'largest difference 0,' bash -c "printf 'P5 1 1 1\n\1' >'$WORK/white.pgm' && '$BUILD/compare' '$WORK/diff.png' '$WORK/white.pgm'"
check "no alpha is opaque" prints '^A has 8 bits and alpha, B has 8 bits$' "$BUILD/compare" "$WORK/opaque.tga" "$WORK/solid.tga"
printf 'P6\n1 1\n65535\n\0\200\0\0\0\0' >"$WORK/deep_a.ppm"
printf 'P6\n1 1\n65535\n\0\201\0\0\0\0' >"$WORK/deep_c.ppm"
printf 'P6\n1 1\n255\n\1\0\0' >"$WORK/deep_d.ppm"
check "the last of 16 bits counts" differ 'largest difference 0\.003891, 1 of 1' "$BUILD/compare" "$WORK/deep_a.ppm" "$WORK/deep_c.ppm"
check "... against 8 bits, too" differ 'A has 16 bits, B has 8 bits' "$BUILD/compare" "$WORK/deep_a.ppm" "$WORK/deep_d.ppm"
cat "$WORK/a.ppm" "$WORK/a.ppm" >"$WORK/aa.ppm"
cat "$WORK/a.ppm" "$WORK/b.ppm" >"$WORK/ab.ppm"
check "a second picture is compared" differ '^picture 2: psnr .*, largest difference 20,' "$BUILD/compare" "$WORK/aa.ppm" "$WORK/ab.ppm"
check "... and a missing one is refused" refuses 2 "the numbers of pictures differ: 2 and 1" "$BUILD/compare" "$WORK/aa.ppm" "$WORK/a.ppm"
{ printf 'P5\n1500 1500\n65535\n'; head -c 4500000 /dev/zero; } >"$WORK/large.pgm"
check "a picture that does not fit into memory is refused" refuses 2 "not enough memory" bash -c "ulimit -v 20000; '$BUILD/compare' '$WORK/large.pgm' '$WORK/large.pgm'"
exr=$SOURCE/tests/support/pictures
# Statements of files about their colours and orientation, which compare does not apply
with() { head -c "$2" "$exr/small.$1" && printf "$3" && tail -c +$(($2 + 1)) "$exr/small.$1"; } # with TYPE OFFSET BYTES: prints small.TYPE with these bytes inserted
with png 33 '\0\0\0\4gAMA\0\1\206\240\61\350\226\137' >"$WORK/gamma.png"
with jpg 2 '\377\341\0\42Exif\0\0II*\0\10\0\0\0\1\0\22\1\3\0\1\0\0\0\6\0\0\0\0\0\0\0' >"$WORK/turned.jpg"
check "gamma in only one of the pictures" differ '^not compared, and different: gAMA$' "$BUILD/compare" "$exr/small.png" "$WORK/gamma.png" --max 255
check "... in both" prints 'largest difference 0,' "$BUILD/compare" "$WORK/gamma.png" "$WORK/gamma.png"
check "a turned picture" differ '^not compared, and different: orientation$' "$BUILD/compare" "$WORK/turned.jpg" "$exr/small.jpg"
check "... is noted when it is copied" eval '"$BUILD/compare" --png "$WORK/turned.jpg" "$WORK/is.png" 2>&1 | grep -q "turned.jpg: orientation is not used"'
check "floats" prints '^psnr inf dB, largest difference 0, 0 of 399 pixels differ$' "$BUILD/compare" "$exr/zips_half.exr" "$exr/tiled_piz_half.exr"
check "... of 16 and 32 bits" prints '^A has floats of 16 bits, B has floats of 32 bits and alpha$' "$BUILD/compare" "$exr/zips_half.exr" "$exr/zip_rgba.exr" --psnr 1
check "... against whole numbers" refuses 2 "one picture has floats" "$BUILD/compare" "$WORK/a.ppm" "$exr/zip_grey.exr"
cat >"$WORK/grey" <<'END'
#!/usr/bin/env bash
size=${!#}
printf 'P6\n%d %d\n255\n' "${size%x*}" "${size#*x}"
head -c $((${size%x*} * ${size#*x} * 3)) /dev/zero | tr '\0' '\200'
END
chmod +x "$WORK/grey"
check "a poster has a large picture and six small ones" bash -c "'$BUILD/contact_sheet' '$WORK/grey' '$WORK/poster.png' --poster --width 320 |
    grep -q 'a poster of 326 x 334'"
check "contact_sheet refuses a program that fails" bash -c "'$BUILD/contact_sheet' /bin/false '$WORK/sheet.png' 2>/dev/null; [ \$? = 1 ] && [ ! -e '$WORK/sheet.png' ]"
printf 'P5 2 2 255\n\0\377\377\0' >"$WORK/linear.pgm"
check "linear light becomes sRGB, averaged over squares" "$BUILD/compare" --linear "$WORK/linear.pgm" "$WORK/is.png" --by 2
printf 'P5 1 1 255\n\274' >"$WORK/half.pgm"
check "... half of white is 188" prints 'largest difference 0,' "$BUILD/compare" "$WORK/is.png" "$WORK/half.pgm"
check "--seen prints the visible difference" prints '^mean flip 0\.[0-9]{4}, psnr in linear light [0-9.]+ dB, in sRGB [0-9.]+ dB$' \
    "$BUILD/compare" "$WORK/a.ppm" "$WORK/b.ppm" --seen --max 255
finish
