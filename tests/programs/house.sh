# Code includes and links only rooms that its own room knows (tools/build/rooms.cmake), and no room knows itself
# through others.
. "$(dirname "$0")/common.sh"

house() { perl "$SOURCE/tests/programs/house.pl" "$SOURCE" "$@"; }
check "every include and every link goes to a known room" house

# Each planted include must be found
finds() { [ "$(house "$@" | grep -c includes)" = 1 ]; }
while read -r file included; do
    check "($file including $included would be found)" finds "$file" "$included"
done <<'PLANTED'
intro/base/text.h intro/host/files.h
intro/trace/quality.h intro/trace/scene/shape.h
intro/host/files.h intro/host/linux/sys.h
intro/main.cpp intro/maker/screen.h
intro/new.cpp intro/base/text.h
intro/show/hall.cpp <GL/gl.h>
intro/trace/picture/frame.cpp <vector>
packer/main.cpp intro/base/text.h
packer/model/search.cpp packer/stub/format.h
tools/engine/machine.cpp tools/radiosity/read/mesh.h
tools/radiosity/read/mesh.h tools/radiosity/solution/solution.h
tools/picture/flip.cpp tests/support/open_room.h
PLANTED

# With CDPATH set, cd prints the folder. Scripts must find the repository nevertheless
for script in watch test golden ledger new-film release render measure/all; do
    check "tools/$script with CDPATH" eval '(cd "$SOURCE" && CDPATH=.:/tmp "tools/$script" --help) >"$WORK/help"'
done

# The film is built from intro/ and packer/ alone
if command -v ninja >/dev/null && [ -e "$BUILD/build.ninja" ]; then
    ninja -C "$BUILD" -t inputs odraz odraz-safe | sed "s|^$SOURCE/||" >"$WORK/inputs"
    check "the film is made of files of intro and packer" grep -qx 'intro/main.cpp' "$WORK/inputs"
    check "... no files of tests, and of tools only what the packer knows" lacks '^(tests|tools/(radiosity|measure|engine|picture))/' "$WORK/inputs"
fi
finish
