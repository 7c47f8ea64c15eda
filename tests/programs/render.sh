# tools/render: the bytes are the same however the film is divided and wherever its shards are made; what was
# interrupted, lost or damaged is made again.
. "$(dirname "$0")/common.sh"
skip_unless ffmpeg ffprobe
needs_built compare
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
check "... told to be of Rec. 709" test "$(shown pix_fmt,color_range,color_space,color_transfer,color_primaries | head -n 5 | xargs)" = "yuv420p tv bt709 bt709 bt709"
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

# --- On hosts, by GNU parallel ---
if command -v parallel >/dev/null; then
    printf '# this machine, twice\n2/:\n\n:   # and once more\n' >"$WORK/hosts"
    check "GNU parallel makes the frames" rendered "${small[@]}" --shard 4 --hosts "$WORK/hosts" "$to/hosts"
    check "... the same" same_frames "$to/hosts"
    check "GNU parallel makes the video" rendered "${small[@]}" --shard 4 --hosts "$WORK/hosts" "$to/hosts film.mp4"
    check "... the same" same_video "$to/hosts film.mp4"
    # What answers like ssh, and fails for one host when it is to draw; another one draws nothing before that
    cat >"$WORK/ssh" <<END
#!/usr/bin/env bash
echo "\$1" >>"$WORK/reached"
case "\$*" in
"broken exec"*film\ --dump*) : >"$WORK/broke"; echo "broken: the cable is out" >&2; exit 255 ;;
"patient exec"*film\ --dump*) for ((i = 0; i < 600; i++)); do [ ! -e "$WORK/broke" ] || break; sleep 0.1; done ;;
deaf*) exit 255 ;;
esac
exec sh -c "\$2"
END
    chmod +x "$WORK/ssh"
    printf 'broken\npatient\n' >"$WORK/hosts"
    check "a host fails, and another takes its shards" rendered "${small[@]}" --shard 4 --ssh "$WORK/ssh" --hosts "$WORK/hosts" "$to/retried.mp4"
    check "... the same" same_video "$to/retried.mp4"
    check "... and it was told" grep -q '^tools/render: frames [0-9]* to [0-9]* failed on broken: broken: the cable is out$' "$WORK/err"
    check "no film is left there" test -z "$(find /tmp -maxdepth 1 -name 'render-??????' -newer "$WORK/hosts")"
    for shell in "" SHELL=/bin/false; do # as a service has them
        rm -rf "$to/bare"*
        check "without ${shell:-SHELL} and HOME" env -u SHELL -u HOME $shell "$render" --film "$film" "${small[@]}" --shard 10 --ssh "$WORK/ssh" --hosts <(echo sound) "$to/bare.mp4"
        check "... the same" same_video "$to/bare.mp4"
    done
    echo broken >"$WORK/hosts"
    check "no host is left" eval '! rendered "${small[@]}" --ssh "$WORK/ssh" --hosts "$WORK/hosts" "$to/none.mp4" 2>/dev/null'
    check "... is told" grep -q 'shards are not done; --resume goes on' "$WORK/err"
    rm -r "$to/none.mp4.parts"
    echo deaf >"$WORK/hosts"
    check "a host that cannot be reached" refuses 1 "deaf does not take the film" "$render" --film "$film" --ssh "$WORK/ssh" --hosts "$WORK/hosts" "${small[@]}" "$to/none.mp4"
    rm -r "$to/none.mp4.parts"
    echo 'ssh -p 22 host' >"$WORK/hosts"
    check "a line that is no host" refuses 1 "write [N/][USER@]HOST" "$render" --film "$film" "${small[@]}" --hosts "$WORK/hosts" "$to/none.mp4"
    rm -r "$to/none.mp4.parts"
    # By ssh itself, to a server of our own
    if sshd=$(command -v sshd || command -v /usr/sbin/sshd) && command -v ssh-keygen >/dev/null; then
        mkdir -m 700 "$WORK/keys"
        ssh-keygen -q -t ed25519 -N '' -f "$WORK/keys/host"
        ssh-keygen -q -t ed25519 -N '' -f "$WORK/keys/user"
        [ "$(id -u)" != 0 ] || mkdir -p /run/sshd
        # A port that is free: the server says so
        for port in $(shuf -i 20000-50000 -n 20); do
            printf '%s\n' "ListenAddress 127.0.0.1" "Port $port" "HostKey $WORK/keys/host" "AuthorizedKeysFile $WORK/keys/user.pub" \
                "StrictModes no" "UsePAM no" "PasswordAuthentication no" "PidFile none" >"$WORK/keys/sshd"
            "$sshd" -D -e -f "$WORK/keys/sshd" 2>"$WORK/keys/log" &
            server=$!
            PIDS+=($server)
            await eval "grep -q 'Server listening' '$WORK/keys/log' || gone $server"
            gone $server || break
        done
        printf '%s\n' "Host *" "HostName 127.0.0.1" "Port $port" "IdentityFile $WORK/keys/user" "UserKnownHostsFile $WORK/keys/known" \
            "StrictHostKeyChecking accept-new" "BatchMode yes" "LogLevel ERROR" >"$WORK/keys/ssh"
        printf '2/alpha\n%s@beta\n' "$(id -un)" >"$WORK/hosts"
        check "over ssh" rendered "${small[@]}" --shard 4 --ssh "ssh -F $WORK/keys/ssh" --hosts "$WORK/hosts" "$to/ssh.mp4"
        check "... the same" same_video "$to/ssh.mp4"
        check "... each shard by a connection" test "$(grep -c '^Accepted publickey' "$WORK/keys/log")" -ge 12
    else
        echo "not checked: over ssh, for there is no sshd"
    fi
else
    echo "not checked: on hosts, for GNU parallel is not installed"
fi

# --- Resumed ---
keep() { # keep OUT: with what it was made from
    rm -rf "$1"* && rendered "${small[@]}" --shard 7 --keep "$1"
}
resumes() { # resumes LEFT OUT
    rendered "${small[@]}" --shard 7 --resume "$2" && grep -qx "tools/render: $((5 - $1)) of 5 shards are there, $1 to do" "$WORK/err"
}
parts=$to/r.mp4.parts
check "a video is kept in its shards" keep "$to/r.mp4"
rm "$to/r.mp4" "$parts/000987-000994.nut" "$parts/001008-001010.sums"
truncate -s -5 "$parts/000994-001001.nut"
flip "$parts/001001-001008.nut" 5000
check "one lost, one unfinished, one cut short, one damaged: four are made again" resumes 4 "$to/r.mp4"
check "... to the same video" same_video "$to/r.mp4"
check "... and those are told" test "$(grep -c 'again: what was kept is missing or damaged' "$WORK/err")" = 3
keep "$to/r.mp4"
cp "$parts/000980-000987.nut" "$parts/000987-000994.nut"
sed -i "\$ s/^[0-9a-f]*/$(sha256sum <"$parts/000980-000987.nut" | cut -d' ' -f1)/" "$parts/000987-000994.sums"
check "a shard that holds other frames, and seems right" eval '! rendered "${small[@]}" --shard 7 --resume "$to/r.mp4" 2>/dev/null'
check "... is told" grep -qx 'tools/render: frame 987 is not what the film drew; --resume makes its shard again' "$WORK/err"
check "... and it does" resumes 1 "$to/r.mp4"
check "... to the same video" same_video "$to/r.mp4"
keep "$to/r.mp4"
check "a run that was made is not overwritten" refuses 1 "r.mp4.parts is there from an earlier run: --resume goes on with it, or remove it" \
    "$render" --film "$film" "${small[@]}" --shard 7 "$to/r.mp4"
check "... nor mixed with one of another quality" refuses 1 "was made otherwise, 'quality draft', now 'quality play'" \
    "$render" --film "$film" "${small[@]}" --quality play --shard 7 --resume "$to/r.mp4"
sed -i '1 s/ [^ ]*$/ 0123456789ab/' "$parts/plan"
check "... nor of another commit" refuses 1 "was made otherwise, 'odraz 0.1.0 0123456789ab', now" \
    "$render" --film "$film" "${small[@]}" --shard 7 --resume "$to/r.mp4"
rm -r "$parts"

# A film that fails in the middle of a shard, or stays away
cat >"$WORK/film" <<END
#!/usr/bin/env bash
case "\$*" in
--version) echo "odraz 0.1.0 planted" ;;
*--dump*--from\ 39.7?????\ *) "$film" "\$@" 2>/dev/null | head -c 100000; echo "odraz: something is wrong" >&2; [ ! -e "$WORK/bad" ] ;;
*) exec "$film" "\$@" ;;
esac
END
chmod +x "$WORK/film"
for kind in .mp4 ""; do
    for bad in "$WORK/bad" ""; do
        [ -z "$bad" ] || touch "$bad"
        check "a film that breaks off, ${bad:+with status 1, }into 'odd$kind'" eval '! rendered --film "$WORK/film" "${small[@]}" --shard 7 "$to/odd$kind" 2>/dev/null'
        check "... is told, by its frames and its reason" grep -qx 'tools/render: frames 994 to 1000 failed: odraz: something is wrong' "$WORK/err"
        check "... and nothing is published" test ! -e "$to/odd$kind" -a ! -e "$to/odd$kind.manifest"
        rm -rf "$WORK/bad" "$to/odd$kind.parts"
    done
done

# No room: a file may have 100 kB more than the film
limit=$((($(stat -c %s "$film") + 100000) / 1024))
check "no room for a shard" eval '! (ulimit -f $limit; "$render" --film "$film" "${span[@]}" --size 320x180 --quality draft "$to/full.mp4" >"$WORK/out" 2>"$WORK/err")'
check "... is told" grep -q '^tools/render: frames 980 to 1009 failed: ' "$WORK/err"
check "... and nothing is published" test ! -e "$to/full.mp4"
check "... and with room it goes on" rendered "${span[@]}" --size 320x180 --quality draft --resume "$to/full.mp4"

# Ctrl-C, as a terminal sends it: to all of them
interrupted() { # interrupted OUT OPTION...
    local began
    set -m
    "$render" --film "$film" --from 30 --to 50 --size 640x360 --quality play --shard 10 "${@:2}" "$1" >"$WORK/out" 2>"$WORK/err" &
    began=$!
    set +m
    PIDS+=($began)
    await eval "ls '$1.parts'/*.sums >/dev/null 2>&1 || gone $began"
    kill -INT -- "-$began"
    ended $began
    [ $? = 130 ] && grep -qx 'tools/render: stopped; --resume goes on from here' "$WORK/err"
}
all_gone() { ! grep -lqF "$to" /proc/[0-9]*/cmdline 2>/dev/null && ! ls -l /proc/[0-9]*/cwd 2>/dev/null | grep -qF "$to"; }
check "Ctrl-C ends it" interrupted "$to/int.mp4" --jobs 2
check "... and all that it began" await all_gone
check "... and what was done is still there" eval 'ls "$to/int.mp4.parts"/*.sums >/dev/null'
rm -r "$to/int.mp4.parts"
if command -v parallel >/dev/null; then
    printf '1/:\nfar\n' >"$WORK/hosts"
    check "Ctrl-C ends GNU parallel" interrupted "$to/int.mp4" --ssh "$WORK/ssh" --hosts "$WORK/hosts"
    check "... and all that it began" await all_gone
    rm -r "$to/int.mp4.parts"
fi

# --- What it cannot do ---
refused() { refuses 2 "$@"; }
plain=("$render" --film "$film")
check "no OUT" refused "name OUT" "${plain[@]}"
check "two" refused "one OUT, not 'a' and 'b' too" "${plain[@]}" a b
check "an unknown option" refused "cannot use '--fast'" "${plain[@]}" --fast "$to/x.mp4"
check "an option without its value" refused "--size needs a value" "${plain[@]}" "$to/x.mp4" --size
check "a quality that the film has not" refused "--quality needs draft" "${plain[@]}" --quality best "$to/x.mp4"
check "an end beyond the film's" refused "beyond the film's end" "${plain[@]}" --to 200 "$to/x.mp4"
check "a span without a frame" refused "no frame lies from 39.21" "${plain[@]}" --from 39.21 --to 39.22 "$to/x.mp4"
check "an odd size" refused "even width and height" "${plain[@]}" "${small[@]}" --size 65x36 "$to/x.mp4"
check "no jobs" refused "--jobs needs a number from 1" "${plain[@]}" --jobs 0 "$to/x.mp4"
check "a folder that is not there" refused "cannot write to the folder of" "${plain[@]}" "$to/none/x.mp4"
check "a folder that holds something" refused "not an empty folder" "${plain[@]}" "$to/one"
check "a film that is not there" refused "cannot run" "$render" --film "$to/none" "$to/x.mp4"
command -v sbatch >/dev/null || check "no Slurm" refused "sbatch is not here" "${plain[@]}" --slurm "$to/x.mp4"
# Without ffmpeg it would install it: here it cannot
mkdir "$WORK/bin"
for program in bash dirname cat sed grep id basename; do ln -s "$(command -v $program)" "$WORK/bin"; done
printf '#!/bin/sh\nexit 1\n' | tee "$WORK/bin/dpkg-query" "$WORK/bin/sudo" >"$WORK/bin/env"
chmod +x "$WORK/bin/"*
check "no ffmpeg, and none to be had" eval '! PATH=$WORK/bin "$render" --film "$film" "$to/x.mp4" >/dev/null 2>"$WORK/err"'
check "... is told" grep -qx 'render: apt-get could not install ffmpeg' "$WORK/err"
check "what it refuses leaves nothing" parts_gone
finish
