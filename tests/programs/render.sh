# tools/render: the bytes are the same however the film is divided. And what it refuses.
. "$(dirname "$0")/rendering.sh"
needs_built compare

# --- Frames ---
check "frames in one shard" rendered "${small[@]}" --shard 30 "$to/one"
"$film" --dump "$WORK/dump" "${small[@]}"
check "... are the film's own" diff -r "$WORK/dump" "$to/one"
check "... thirty of them" test "$(ls "$to/one" | wc -l)" = 30
check "the manifest has their sums" bash -c "cd '$to/one' && sha256sum --check --strict --status '$to/one.manifest'"
check "... all of them" test "$(grep -c '^[0-9a-f]' "$to/one.manifest")" = 30
check "... and the film's commit" grep -qFx "# $("$film" --version)" "$to/one.manifest"
check "frames in five shards, three at once, into a name with blanks" rendered "${small[@]}" --shard 7 --jobs 3 "$to/a name"
check "... are the same" same_frames "$to/a name"
check "frames off the grid, at 30000/1001 a second" rendered --from 39.61 --to 40.012345 --fps 30000/1001 --size 65x37 --quality play --shard 1 "$to/off"
"$film" --dump "$WORK/off" --from 39.61 --to 40.012345 --fps 30000/1001 --size 65x37 --quality play
check "... are the film's own" diff -r "$WORK/off" "$to/off"
check "frames as they are played" rendered --from 39.8 --to 40.2 --fps 60 --quality live --size 65x37 --shard 5 --jobs 2 "$to/live"
"$film" --dump "$WORK/live" --from 39.8 --to 40.2 --fps 60 --quality live --size 65x37
check "... are the film's own" diff -r "$WORK/live" "$to/live"
check "the film's end" rendered --from 161.93 --size 65x37 --quality draft --shard 1 "$to/end"
check "... is its last frame" test "$(ls "$to/end")" = frame-004049.ppm
check "the hall, in two shards at once" rendered --from 120 --to 120.08 --size 160x90 --shard 1 --jobs 2 "$to/hall"
"$film" --dump "$WORK/hall" --from 120 --to 120.08 --size 160x90 --quality play
check "... is the film's own" diff -r "$WORK/hall" "$to/hall"

# --- Video ---
check "a video in one shard" rendered "${small[@]}" --shard 30 "$to/one.mp4"
check "... has the frames' sums" cmp "$to/one.manifest" "$to/one.mp4.manifest"
check "a video in five shards, three at once" rendered "${small[@]}" --shard 7 --jobs 3 "$to/a film.mp4"
check "... is the same to the byte" same_video "$to/a film.mp4"
shown() { ffprobe -loglevel error -count_frames -show_entries stream="$1" -of default=nokey=1:noprint_wrappers=1 "$to/one.mp4"; }
check "it holds H.264 and AAC" test "$(shown codec_name | xargs)" = "h264 aac"
check "... thirty frames" test "$(shown nb_read_frames | head -n 1)" = 30
check "... and is 1.2 s long" test "$(shown duration | xargs)" = "1.200000 1.200000"
check "... marked as Rec. 709" test "$(shown pix_fmt,color_range,color_space,color_transfer,color_primaries | head -n 5 | xargs)" = "yuv420p tv bt709 bt709 bt709"
like() { # like MATRIX: how near the first frame is, with its colours by that matrix
    ffmpeg -loglevel error -y -i "$to/one.mp4" -frames:v 1 -vf scale=in_color_matrix=$1,format=rgb24 "$WORK/first.ppm" &&
        "$BUILD/compare" "$WORK/first.ppm" "$to/one/frame-000980.ppm" | sed 's/psnr \([0-9.]*\).*/\1/'
}
check "... which it is" less "$(awk "BEGIN { print $(like bt601) + 1 }")" "$(like bt709)"
check "it can be played before it is whole" eval '[ "$(grep -abo -m 1 moov "$to/one.mp4" | head -n 1 | cut -d: -f1)" -lt "$(grep -abo -m 1 mdat "$to/one.mp4" | head -n 1 | cut -d: -f1)" ]'
check "a video without loss" rendered "${small[@]}" --shard 7 "$to/one.mkv"
check "... has every bit of the frames" cmp <(ffmpeg -loglevel error -i "$to/one.mkv" -c:v ppm -f image2pipe -) <(cat "$to"/one/*.ppm)
check "... and of the music" cmp <(ffmpeg -loglevel error -i "$to/one.mkv" -f s16le -) <("$film" --wav - --from 39.2 --to 40.4 | tail -c +45)
check "nothing else is left" parts_gone

# --- What it cannot do ---
refused() { refuses 2 "$@"; }
plain=("$render" --film "$film")
check "no OUT" refused "name OUT" "${plain[@]}"
check "two" refused "one OUT, not 'a' and 'b' too" "${plain[@]}" a b
check "an option without its value" refused "--size needs a value" "${plain[@]}" "$to/x.mp4" --size
check "a quality that the film has not" refused "--quality needs draft" "${plain[@]}" --quality best "$to/x.mp4"
check "an end beyond the film's" refused "beyond the film's end" "${plain[@]}" --to 200 "$to/x.mp4"
check "a span without a frame" refused "no frame lies from 39.21" "${plain[@]}" --from 39.21 --to 39.22 "$to/x.mp4"
check "an odd size" refused "even width and height" "${plain[@]}" "${small[@]}" --size 65x36 "$to/x.mp4"
check "no jobs" refused "--jobs needs a number from 1" "${plain[@]}" --jobs 0 "$to/x.mp4"
check "a folder that is not there" refused "cannot write to the folder of" "${plain[@]}" "$to/none/x.mp4"
check "a folder that holds something" refused "not an empty folder" "${plain[@]}" "$to/one"
check "a film that is not there" refused "cannot run" "$render" --film "$to/none" "$to/x.mp4"
command -v sbatch >/dev/null || check "no Slurm" refused "there is no sbatch" "${plain[@]}" --slurm "$to/x.mp4"
# Without ffmpeg it would install it: here it cannot
mkdir "$WORK/bin"
for program in bash dirname cat sed grep id basename; do ln -s "$(command -v $program)" "$WORK/bin"; done
printf '#!/bin/sh\nexit 1\n' | tee "$WORK/bin/dpkg-query" "$WORK/bin/sudo" >"$WORK/bin/env"
chmod +x "$WORK/bin/"*
check "no ffmpeg, and none to be had" eval '! PATH=$WORK/bin "$render" --film "$film" "$to/x.mp4" >/dev/null 2>"$WORK/err"'
check "... is reported" grep -qx 'render: apt-get could not install ffmpeg' "$WORK/err"
check "what it refuses leaves nothing" parts_gone
finish
