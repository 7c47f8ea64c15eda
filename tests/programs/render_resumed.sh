# tools/render: shards that were interrupted, lost or damaged are made again, to the same bytes.
. "$(dirname "$0")/rendering.sh"
check "a video in one shard" rendered "${small[@]}" --shard 30 "$to/one.mp4"
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
check "... and those are reported" test "$(grep -c 'again: what was kept is missing or damaged' "$WORK/err")" = 3
keep "$to/r.mp4"
cp "$parts/000980-000987.nut" "$parts/000987-000994.nut"
sed -i "\$ s/^[0-9a-f]*/$(sha256sum <"$parts/000980-000987.nut" | cut -d' ' -f1)/" "$parts/000987-000994.sums"
check "a shard that holds other frames, and seems right" eval '! rendered "${small[@]}" --shard 7 --resume "$to/r.mp4" 2>/dev/null'
check "... is reported" grep -qx 'tools/render: frame 987 is not what the film drew; --resume makes its shard again' "$WORK/err"
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

# A film that breaks off in the middle of a shard, with status 1 or 0
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
        check "... is reported, by its frames and its reason" grep -qx 'tools/render: frames 994 to 1000 failed: odraz: something is wrong' "$WORK/err"
        check "... and nothing is published" test ! -e "$to/odd$kind" -a ! -e "$to/odd$kind.manifest"
        rm -rf "$WORK/bad" "$to/odd$kind.parts"
    done
done

# No room: a file may have 100 kB more than the film
limit=$((($(stat -c %s "$film") + 100000) / 1024))
check "no room for a shard" eval '! (ulimit -f $limit; "$render" --film "$film" "${span[@]}" --size 320x180 --quality draft "$to/full.mp4" >"$WORK/out" 2>"$WORK/err")'
check "... is reported" grep -q '^tools/render: frames 980 to 1009 failed: ' "$WORK/err"
check "... and nothing is published" test ! -e "$to/full.mp4"
check "... and with room it goes on" rendered "${span[@]}" --size 320x180 --quality draft --resume "$to/full.mp4"

check "Ctrl-C ends it" interrupted "$to/int.mp4" --jobs 2
check "... and all that it began" await all_gone
check "... and what was done is still there" eval 'ls "$to/int.mp4.parts"/*.sums >/dev/null'
rm -r "$to/int.mp4.parts"
finish
