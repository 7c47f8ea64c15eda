# The whole film, a picture a second, in draft, play and film, is the same with one thread and with many, of the film
# and of OpenGL.
. "$(dirname "$0")/../common.sh"
for threads in 1 7; do
    printf '#!/bin/sh\nLP_NUM_THREADS=%d exec "%s" "$@" --threads %d\n' $threads "$BUILD/odraz-safe" $threads >"$WORK/with$threads"
    chmod +x "$WORK/with$threads"
done
check "one thread and seven draw the same" prints '^486 pictures are equal to the bit, 0 differ; the music is equal$' "$SOURCE/tests/support/same_pictures" "$WORK/with1" "$WORK/with7"
finish
