# The film reads no uninitialised memory and nothing out of bounds: valgrind's memcheck checks a picture of each scene,
# in draft and in film.
#   memcheck.sh BUILD [hall]     with `hall`: the scenes in the hall; memcheck takes half an hour to solve it
. "$(dirname "$0")/common.sh"
skip_unless valgrind
odraz=$BUILD/odraz.elf # as it ships, but with symbols
# One thread in the film and one in the driver. The driver's vectors have 128 bits, which valgrind runs faster
export LP_NUM_THREADS=0 LP_NATIVE_VECTOR_WIDTH=128
# pictures COUNT OPTION...: dumps pictures under memcheck; succeeds if it reports no error and they are COUNT
pictures() {
    local count=$1
    shift
    valgrind --error-exitcode=9 --smc-check=none --log-file="$WORK/log" --suppressions="$SOURCE/tests/support/valgrind.supp" \
        "$odraz" --dump "$WORK/pictures" --size 64x36 --threads 1 "$@" && [ "$(ls "$WORK/pictures" | wc -l)" = "$count" ] &&
        grep -q 'ERROR SUMMARY: 0 errors' "$WORK/log" && rm -r "$WORK/pictures" && return 0
    head -n 60 "$WORK/log" >&2
    return 1
}
for quality in draft film; do
    if [ "${2-}" = hall ]; then
        check "patches, hall and odraz in $quality" pictures 3 --fps 1/29 --from 87 --to 146 --quality $quality
    else
        check "point, table and flake in $quality" pictures 4 --fps 1/12 --from 12 --to 60 --quality $quality
        check "credits in $quality" pictures 1 --fps 1 --from 159 --to 160 --quality $quality
    fi
done

# memcheck must find the fault of this program
cat >"$WORK/blind.c" <<'END'
#include <stdlib.h>
int main(void) { int *p = malloc(4); return *p ? 0 : 1; }
END
cc -O0 -o "$WORK/blind" "$WORK/blind.c"
valgrind -q --error-exitcode=9 "$WORK/blind" 2>/dev/null
check "(memcheck would find it)" test $? = 9
finish
