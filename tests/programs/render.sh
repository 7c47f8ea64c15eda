# tools/render makes the same bytes however the film is divided and on whatever hosts, also when shards were
# interrupted, lost or damaged.
. "$(dirname "$0")/common.sh"
skip_unless ffmpeg ffprobe
needs_built compare
film=$BUILD/odraz-safe
render=$SOURCE/tools/render
span=(--from 15.8 --to 16.28 --fps 25) # across a cut, 12 frames, none of the hall
small=("${span[@]}" --size 160x90 --quality draft)
parted=("${small[@]}" --shard 5) # in three shards
to=$WORK/to
mkdir "$to"
rendered() { "$render" --film "$film" "$@" >"$WORK/out" 2>"$WORK/err" || { cat "$WORK/err" >&2; return 1; }; }
fails() { ! rendered "$@" 2>/dev/null; } # WORK/err gets the reason
reported() { grep -qx "tools/render: $1" "$WORK/err"; }
parts_gone() { [ -z "$(find "$WORK" -name '*.parts')" ]; }
same_video() { cmp "$to/one.mp4" "$1" && cmp "$to/one.mp4.manifest" "$1.manifest"; }

# --- Frames ---
check "frames in one shard" rendered "${small[@]}" "$to/one"
"$film" --dump "$WORK/dump" "${small[@]}"
check "... are the film's own" diff -r "$WORK/dump" "$to/one"
check "... twelve of them" test "$(ls "$to/one" | wc -l)" = 12
check "the manifest has their sums" eval '(cd "$to/one" && sha256sum --check --strict --status ../one.manifest)'
check "... and the film's commit" grep -qFx "# $("$film" --version)" "$to/one.manifest"
check "frames in three shards, two at once, into a name with blanks" rendered "${parted[@]}" --jobs 2 "$to/a name"
check "... are the same" eval 'diff -r "$to/one" "$to/a name" && cmp "$to/one.manifest" "$to/a name.manifest"'
for odd in "--fps 30000/1001 --from 15.93 --to 16.032345 --quality draft" "--fps 60 --from 15.96 --to 16.012 --quality live"; do
    check "frames off the grid, each in a shard: $odd" rendered $odd --size 65x37 --shard 1 "$to/odd"
    "$film" --dump "$WORK/odd" $odd --size 65x37
    check "... are the film's own" diff -r "$WORK/odd" "$to/odd"
    rm -r "$WORK/odd" "$to/odd"
done
check "the film's end" rendered --from 163.93 --size 65x37 --quality draft --shard 1 "$to/end"
check "... is its last frame" test "$(ls "$to/end")" = frame-004099.ppm

# --- Video ---
check "a video in one shard" rendered "${small[@]}" "$to/one.mp4"
check "... has the frames' sums" cmp "$to/one.manifest" "$to/one.mp4.manifest"
check "a video in three shards, two at once, which are kept" rendered "${parted[@]}" --jobs 2 --keep "$to/kept.mp4"
check "... has the same bytes" same_video "$to/kept.mp4"
shown() { ffprobe -loglevel error -count_frames -show_entries stream="$1" -of default=nokey=1:noprint_wrappers=1 "$to/one.mp4" | xargs; }
check "it holds H.264 and AAC" test "$(shown codec_name)" = "h264 aac"
check "... twelve frames" test "$(shown nb_read_frames | cut -d' ' -f1)" = 12
check "... and is .48 s long" test "$(shown duration)" = "0.480000 0.480000"
check "... marked as Rec. 709" test "$(shown pix_fmt,color_range,color_space,color_transfer,color_primaries | cut -d' ' -f-5)" = "yuv420p tv bt709 bt709 bt709"
like() { # like MATRIX: prints the PSNR of the last frame, whose colours are converted by that matrix
    ffmpeg -loglevel error -y -i "$to/one.mp4" -vf "select=eq(n\,11),scale=in_color_matrix=$1,format=rgb24" -frames:v 1 "$WORK/last.ppm" &&
        "$BUILD/compare" "$WORK/last.ppm" "$to/one/frame-000406.ppm" | sed 's/psnr \([0-9.]*\).*/\1/'
}
check "... and the colours are converted by it" less "$(awk "BEGIN { print $(like bt601) + 1 }")" "$(like bt709)"
check "it can be played before it is loaded completely" eval '[ "$(grep -abo -m 1 moov "$to/one.mp4" | head -n 1 | cut -d: -f1)" -lt "$(grep -abo -m 1 mdat "$to/one.mp4" | head -n 1 | cut -d: -f1)" ]'
check "a video without loss" rendered "${parted[@]}" "$to/one.mkv"
check "... has every bit of the frames" cmp <(ffmpeg -loglevel error -i "$to/one.mkv" -c:v ppm -f image2pipe -) <(cat "$to"/one/*.ppm)
check "... and of the music" cmp <(ffmpeg -loglevel error -i "$to/one.mkv" -f s16le -) <("$film" --wav - "${span[@]:0:4}" | tail -c +45)

# --- Shards that were lost or damaged ---
parts=$to/r.mp4.parts
kept() { # restores the folder of finished shards
    rm -rf "$parts" && cp -r "$to/kept.mp4.parts" "$parts"
}
resumes() { # resumes LEFT: succeeds if --resume makes LEFT shards, and the same video
    rendered "${parted[@]}" --resume --keep "$to/r.mp4" && reported "$((3 - $1)) of 3 shards are done, $1 are left" && same_video "$to/r.mp4"
}
kept
rm "$parts/000405-000407.sums"
truncate -s -5 "$parts/000395-000400.nut"
flip "$parts/000400-000405.nut" 5000
check "one unfinished, one cut short, one damaged: all are made again, to the same video" resumes 3
check "... and the two damaged files are reported" test "$(grep -c 'again: its file is missing or damaged' "$WORK/err")" = 2
kept
cp "$parts/000395-000400.nut" "$parts/000400-000405.nut"
sed -i "\$ s/^[0-9a-f]*/$(sha256sum <"$parts/000395-000400.nut" | cut -d' ' -f1)/" "$parts/000400-000405.sums"
check "a shard that holds other frames, and seems right" fails "${parted[@]}" --resume "$to/r.mp4"
check "... is reported" reported 'frame 400 differs from the film; --resume makes its shard again'
check "... and --resume makes it again" resumes 1
check "an earlier run is not overwritten" refuses 1 "r.mp4.parts is left from an earlier run: continue it with --resume, or remove it" \
    "$render" --film "$film" "${parted[@]}" "$to/r.mp4"
check "... nor mixed with one of another quality" refuses 1 "was made with 'quality draft', now 'quality play'" \
    "$render" --film "$film" "${parted[@]}" --quality play --resume "$to/r.mp4"
rm -r "$to"/*.parts

# A film that breaks off in the middle of a shard, with status 1 or 0
cat >"$WORK/film" <<END
#!/usr/bin/env bash
case "\$*" in
--version) echo "odraz 0.1.0 planted" ;;
*--dump*--from\ 15.9?????\ *) "$film" "\$@" 2>/dev/null | head -c 100000; echo "odraz: something is wrong" >&2; [ ! -e "$WORK/bad" ] ;;
*) exec "$film" "\$@" ;;
esac
END
chmod +x "$WORK/film"
for out in broken.mp4 broken; do
    check "a film that breaks off, into '$out'" fails --film "$WORK/film" "${parted[@]}" "$to/$out"
    check "... is reported, by its frames and its reason" reported 'frames 400 to 404 failed: odraz: something is wrong'
    check "... and nothing is published" test ! -e "$to/$out" -a ! -e "$to/$out.manifest"
    rm -r "$to/$out.parts"
    touch "$WORK/bad"
done

# Without room for a shard: a limit allows files that are 100 kB larger than the film
limit=$((($(stat -c %s "$film") + 100000) / 1024))
check "no room for a shard" eval '(ulimit -f $limit; fails "${span[@]}" --size 320x180 --quality draft "$to/full.mp4")'
check "... is reported" grep -q '^tools/render: frames 395 to 406 failed: ' "$WORK/err"
check "... and with room it goes on" rendered "${span[@]}" --size 320x180 --quality draft --resume "$to/full.mp4"

# Ctrl-C, which a terminal sends to all processes of the group
interrupted() { # interrupted OUT OPTION...: sends Ctrl-C when a shard is done
    local began
    set -m
    "$render" --film "$film" --from 14 --to 34 --size 160x90 --quality draft --shard 10 "${@:2}" "$1" >"$WORK/out" 2>"$WORK/err" &
    began=$!
    set +m
    PIDS+=($began)
    await eval "ls '$1.parts'/*.sums >/dev/null 2>&1 || gone $began"
    kill -INT -- "-$began"
    ended $began
    [ $? = 130 ] && reported 'stopped; --resume continues from here'
}
all_gone() { ! grep -lqF "$to" /proc/[0-9]*/cmdline 2>/dev/null && ! ls -l /proc/[0-9]*/cwd 2>/dev/null | grep -qF "$to"; }
check "Ctrl-C ends it" interrupted "$to/int.mp4" --jobs 2
check "... and all that it started" await all_gone
check "... and what was done is still there" eval 'ls "$to/int.mp4.parts"/*.sums >/dev/null'
rm -r "$to/int.mp4.parts"

# --- On hosts, by GNU parallel ---
if command -v parallel >/dev/null; then
    # A stand-in for ssh: the host `broken` fails when it should draw, `patient` draws only after that, and `deaf` does
    # not answer
    cat >"$WORK/ssh" <<END
#!/usr/bin/env bash
case "\$*" in
"broken exec"*film\ --dump*) : >"$WORK/broke"; echo "broken: the cable is out" >&2; exit 255 ;;
"patient exec"*film\ --dump*) until [ -e "$WORK/broke" ]; do sleep 0.1; done ;;
deaf*) exit 255 ;;
esac
exec sh -c "\$2"
END
    chmod +x "$WORK/ssh"
    hosts() { printf '%s\n' "$@" >"$WORK/hosts"; }
    on_hosts=("${parted[@]}" --ssh "$WORK/ssh" --hosts "$WORK/hosts")
    hosts '# this machine, twice' '2/:' '' ':   # and once more'
    # Without SHELL and HOME, as a service has them
    check "GNU parallel makes the video" eval '(unset HOME; export SHELL=/bin/false; rendered "${on_hosts[@]}" "$to/hosts film.mp4")'
    check "... the same" same_video "$to/hosts film.mp4"
    hosts broken patient
    mkdir "$WORK/there"
    check "a host fails, and another takes its shards" eval 'TMPDIR=$WORK/there rendered "${on_hosts[@]}" "$to/retried.mp4"'
    check "... to the same video" same_video "$to/retried.mp4"
    check "... and stderr reports it" reported 'frames [0-9]* to [0-9]* failed on broken: broken: the cable is out'
    check "no film is left there" test -z "$(ls "$WORK/there")"
    hosts broken
    check "no host is left" fails "${on_hosts[@]}" "$to/none.mp4"
    check "... is reported" grep -q 'shards are not done; --resume continues' "$WORK/err"
    rm -r "$to/none.mp4.parts"
    hosts deaf
    check "a host that cannot be reached" refuses 1 "cannot copy the film to deaf" "$render" --film "$film" "${on_hosts[@]}" "$to/none.mp4"
    rm -r "$to/none.mp4.parts"
    hosts 1/: far
    check "Ctrl-C ends GNU parallel" interrupted "$to/int.mp4" --ssh "$WORK/ssh" --hosts "$WORK/hosts"
    check "... and all that it started" await all_gone
    rm -r "$to/int.mp4.parts"
else
    echo "not checked: hosts, since GNU parallel is not installed"
fi

# --- What it cannot do ---
check "an option that the film refuses" refuses 2 "--quality needs draft" "$render" --film "$film" --quality best "$to/x.mp4"
check "an odd size" refuses 2 "even width and height" "$render" --film "$film" "${small[@]}" --size 65x36 "$to/x.mp4"
check "a folder that is not empty" refuses 2 "not an empty folder" "$render" --film "$film" "$to/one"
# tools/render would install a missing ffmpeg, but here it cannot
mkdir "$WORK/bin"
for program in bash dirname cat sed grep id basename; do ln -s "$(command -v $program)" "$WORK/bin"; done
printf '#!/bin/sh\nexit 1\n' | tee "$WORK/bin/dpkg-query" "$WORK/bin/sudo" >"$WORK/bin/env"
chmod +x "$WORK/bin/"*
check "no ffmpeg, which cannot be installed" eval 'PATH=$WORK/bin fails "$to/x.mp4"'
check "... is reported" grep -qx 'render: apt-get could not install ffmpeg' "$WORK/err"
check "refusals leave nothing" parts_gone
finish
