# The whole film, with a picture a second in draft, play and film, is the same with one thread and with seven, both
# in the film and in OpenGL.
. "$(dirname "$0")/../common.sh"
. "$(dirname "$0")/same_film.sh"
for threads in 1 7; do
    printf '#!/bin/sh\nLP_NUM_THREADS=%d exec "%s" "$@" --threads %d\n' $threads "$BUILD/odraz-safe" $threads >"$WORK/with$threads.sh"
    chmod +x "$WORK/with$threads.sh"
done
check "one thread and seven draw the same" same_film "$WORK/with1.sh" "$WORK/with7.sh"
finish
