# Sourced by tests that compare two programs of the film, after common.sh. Golden pictures are few, and those of the hall
# have a tolerance: here it is a picture for each second of the whole film, in draft, play and film, and the music.

# same_film A B: pictures and music are equal to the bit
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
