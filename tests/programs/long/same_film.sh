# Sourced after common.sh by tests that compare two programs of the film. Golden pictures are few, and the hall's have a
# tolerance. Here one picture for each second of the film, in draft, play and film, and the music must be equal.

# same_film A B: succeeds if pictures and music are equal to the bit
same_film() {
    local quality film
    mkdir "$WORK/of"
    for film in "$1" "$2"; do
        mkdir "$WORK/of/${film##*/}"
        for quality in draft play film; do
            "$film" --dump "$WORK/of/${film##*/}/$quality" --fps 1 --size 320x180 --quality $quality || return
        done
        "$film" --wav "$WORK/of/${film##*/}/music" || return
    done
    [ "$(find "$WORK/of/${1##*/}" -type f | wc -l)" = 487 ] && diff -qr "$WORK/of/${1##*/}" "$WORK/of/${2##*/}"
}
