# The music that the packed film writes, as a whole and in parts; its loudness, and the times of its events.
. "$(dirname "$0")/common.sh"
skip_unless ffmpeg sha256sum
needs_built listen
unset DISPLAY
packed=$BUILD/odraz
odraz=$BUILD/odraz-safe # the same program, as is checked below; it starts without unpacking
wav=$WORK/film.wav

check "the whole music is written" "$packed" --wav "$wav"
check "... 164 seconds of it" test "$(stat -c %s "$wav")" = $((164 * 48000 * 4 + 44))
check "... and nothing else" test "$(ls "$WORK"/*.part 2>/dev/null | wc -l)" = 0
check "odraz-safe writes the same, whatever the number of threads" cmp "$wav" <("$odraz" --wav - --threads 5)
format() { ffprobe -v error -show_entries stream=codec_name,sample_rate,channels,duration -of csv=p=0 "$1"; }
check "it is a WAV of 48 kHz, 16 bits, stereo" test "$(format "$wav")" = pcm_s16le,48000,2,164.000000

# A part is a slice of the whole, from its first sample at or after --from
body() { tail -c +45 "$1"; }
slice() { tail -c +$((45 + 4 * $1)) "$wav" | head -c $((4 * ($2 - $1))); }
shard() { "$odraz" --wav "$WORK/shard.wav" --from "$1" --to "$2" && [ "$(format "$WORK/shard.wav")" = "pcm_s16le,48000,2,$5" ] && cmp <(body "$WORK/shard.wav") <(slice "$3" "$4"); }
check "a part is its slice" shard 60 61.5 2880000 2952000 1.500000
check "... to the sample" shard 71.123456 71.2 3413926 3417600 0.076542
check "... at the end" shard 163.5 164 7848000 7872000 0.500000
"$odraz" --wav "$WORK/none.wav" --from 3 --to 3
check "an empty part is just a header" test "$(stat -c %s "$WORK/none.wav")" = 44
check "a part to compare with" shard 8 8.5 384000 408000 0.500000
check "a pipe gets the same" cmp "$WORK/shard.wav" <("$odraz" --wav - --from 8 --to 8.5 | cat)
mkfifo "$WORK/fifo"
cat "$WORK/fifo" >"$WORK/piped" &
PIDS+=($!)
check "a named pipe stays one" "$odraz" --wav "$WORK/fifo" --from 8 --to 8.5
check "... and gets the same" eval 'await cmp -s "$WORK/shard.wav" "$WORK/piped" && [ -p "$WORK/fifo" ]'
check "pictures and sound come together" "$odraz" --dump "$WORK/frames" --wav "$WORK/both.wav" --from 8 --to 8.2 --size 64x36
check "... five of them" test "$(ls "$WORK/frames" | wc -l)" = 5
check "... and two tenths of a second" test "$(stat -c %s "$WORK/both.wav")" = $((9600 * 4 + 44))

check "--wav reports a full disk" refuses 1 "cannot write standard output: no space left" bash -c "exec '$odraz' --wav - --to 1 >/dev/full"

# Loudness, after EBU R 128 and ITU-R BS.1770
ffmpeg -hide_banner -nostats -i "$wav" -af ebur128=peak=true:framelog=verbose -f null - 2>"$WORK/ebu"
loudness() { sed -n "/Summary/,\$ s/^ *$1: *\(-*[0-9.]*\) .*/\1/p" "$WORK/ebu" | head -n 1; }
echo "loudness $(loudness I) LUFS, range $(loudness LRA) LU, true peak $(loudness Peak) dBTP"
check "its loudness is -16.5 LUFS" eval 'less -17.5 "$(loudness I)" && less "$(loudness I)" -15.5'
check "... with a range of 8 to 18 LU" eval 'less 8 "$(loudness LRA)" && less "$(loudness LRA)" 18'
check "... and a true peak below -1 dB" less "$(loudness Peak)" -1

"$BUILD/listen" "$wav" >"$WORK/heard"
grep -v '^onset' "$WORK/heard"
heard() { awk -F, -v seen=0 "\$1 == \"$1\" { ++seen; if (!($2)) { print > \"/dev/stderr\"; bad = 1 } } END { exit bad || !seen }" "$WORK/${3-heard}"; }
check "it has no DC offset" heard all '$2 < 3e-4'
check "it has no click: no step between samples stands out" heard step '$2 < 12'
check "left and right are alike, but not the same, in every scene" heard scene '$4 >= 0.2 && $4 <= 0.8'
most='most = 0; for (i = 6; i <= NF; ++i) if ($i > most) most = $i;'
octaves() { awk -F, "\$1 == \"scene\" { ++seen; $most if (most > 0.5) bad = 1 } END { exit bad || seen < 7 }" "$WORK/heard"; }
check "no octave has more than half of a scene's energy" octaves
onset='$4 >= -20 && $4 <= 20 && $5 >= 2.5'
check "every cut and every audible event is heard, within 20 ms" heard onset "$onset"
check "... more than 50 of them" test "$(grep -c '^onset' "$WORK/heard")" -gt 50
# Music that is a row late, with a click, must be found
(head -c 44 "$wav"; head -c 24000 /dev/zero; body "$wav" | head -c 4000000; printf '\377\077\377\077'; body "$wav" | tail -c +4000005 | head -c -24000) >"$WORK/late.wav"
"$BUILD/listen" "$WORK/late.wav" >"$WORK/late"
late() { [ "$(awk -F, "/^onset/ && !($onset)" "$WORK/late" | wc -l)" -ge 15 ]; }
check "(in music that is a row late, many would be missed)" late
check "(a click would be found)" eval '! heard step "\$2 < 12" late 2>/dev/null'

finish
