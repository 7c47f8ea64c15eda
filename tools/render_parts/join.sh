# Sourced by tools/render: joins the shards to a video.

write_manifest() {
    local name
    # Leave out the division into shards, which does not change the frames
    sed -n '/^shards of /,$ !s/^/# /p' "$parts/plan"
    while read -r _ _ name; do grep 'frame-' "$parts/$name.sums"; done <"$parts/shards"
}

frames_joined() { cat "$parts/joined.hashes" 2>/dev/null | grep -c '^0,' || true; }

# The number of threads is fixed, since x264's bytes depend on it. The film's sRGB is declared as Rec. 709, as players
# expect.
by_ffmpeg() {
    local coded=(-c:v ffv1 -level 3 -g 1 -slices 4 -slicecrc 1 -pix_fmt bgr0 -c:a flac)
    [ $kind = mkv ] || coded=(
        -vf "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int+bitexact,format=yuv420p"
        -c:v libx264 -preset medium -crf "$crf" -threads 8 -color_primaries bt709 -color_trc bt709 -colorspace bt709 -color_range tv
        -c:a aac -b:a 192k -movflags +faststart)
    cd "$parts"
    exec ffmpeg -nostdin -loglevel error -y -r "$fps" -f concat -i list -i music.wav \
        -map 0:v -map 1:a -map_metadata -1 "${coded[@]}" -flags:v +bitexact -flags:a +bitexact -fflags +bitexact "joined.part.$kind" \
        -map 0:v -c:v ppm -flush_packets 1 -f framehash -hash sha256 joined.hashes
}

# Joins the shards, and proves that every frame of the video is as the film drew it, by hashing it again
join_video() {
    local wrong name
    while read -r _ _ name; do echo "file '$name.nut'"; done <"$parts/shards" >"$parts/list"
    rm -f "$parts/joined.hashes"
    start by_ffmpeg 2>"$parts/engine.err"
    follow joining "$frames" frames_joined || fail "ffmpeg could not join the shards: $(grep -m 1 . "$parts/engine.err")"
    wrong=$(diff <(grep -v '^#' "$parts/manifest.part" | cut -d' ' -f1) <(awk -F ', *' '!/^#/ { print $6 }' "$parts/joined.hashes") |
        sed -n '1 s/[^0-9].*//p' || true)
    if [ -n "$wrong" ]; then
        wrong=$((first + wrong - 1))
        while read -r a b name; do [ $wrong -lt "$a" ] || [ $wrong -ge "$b" ] || rm -f "$parts/$name.sums"; done <"$parts/shards"
        fail "frame $wrong differs from the film; --resume makes its shard again"
    fi
    mv "$parts/joined.part.$kind" "$parts/joined.$kind"
}
