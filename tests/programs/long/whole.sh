# The film is optimised as a whole when it is linked. It makes the same pictures and music as when each of its files is
# optimised alone, as in tools and tests.
. "$(dirname "$0")/../common.sh"
. "$(dirname "$0")/same_film.sh"
check "the film is linked file by file" cmake --build "$BUILD" --target odraz-parts.elf
check "its code differs" test "$(objdump -d "$BUILD/odraz-parts.elf" | wc -l)" != "$(objdump -d "$BUILD/odraz.elf" | wc -l)"
check "pictures and music are the same" same_film "$BUILD/odraz-parts.elf" "$BUILD/odraz-safe"
finish
