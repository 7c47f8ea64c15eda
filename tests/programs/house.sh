# The house's first rule: code includes and links only rooms that its room knows, and there is no circle.
. "$(dirname "$0")/common.sh"

house() { perl "$SOURCE/tests/programs/house.pl" "$SOURCE" "$@"; }
check "every include and every link goes to a room that is known" house

# Finds planted includes in every part of the tree
finds() { [ "$(house "$@" | grep -c includes)" = 1 ]; }
while read -r file included; do
    check "(it would be found that $file includes $included)" finds "$file" "$included"
done <<'PLANTED'
intro/base/text.h intro/host/files.h
intro/timeline/shot.h intro/show/show.h
intro/trace/quality.h intro/trace/scene/shape.h
intro/trace/rays/view.h intro/trace/picture/frame.h
intro/sound/mixer.h intro/timeline/track.h
intro/radiosity/solve.h intro/transfer/relight.h
intro/show/hall.cpp intro/host/headless.h
intro/host/files.h intro/host/linux/sys.h
intro/play/player.cpp intro/inside.h
intro/play/player.cpp intro/maker/panel/panel.h
intro/main.cpp intro/maker/screen.h
intro/main_debug.cpp tools/measure/detect/screening.h
intro/new.cpp intro/base/text.h
intro/maker/panel/canvas.cpp tools/engine/machine.h
intro/show/hall.cpp <GL/gl.h>
intro/trace/picture/frame.cpp <vector>
packer/main.cpp tools/picture/picture.h
packer/main.cpp intro/base/text.h
packer/model/search.cpp packer/stub/format.h
packer/read/program.h packer/write/texts.h
tools/common/text.cpp packer/decoder.h
tools/picture/picture.cpp tools/engine/machine.h
tools/engine/machine.cpp tools/radiosity/read/mesh.h
tools/radiosity/read/mesh.h tools/radiosity/solution/solution.h
tools/radiosity/view/mesh.cpp tools/measure/detect/screening.h
tools/measure/oracle/sampler.cpp tools/measure/bench/subject.h
tools/picture/flip.cpp tests/support/open_room.h
PLANTED

# The film is made of intro/ and packer/ alone
if command -v ninja >/dev/null && [ -e "$BUILD/build.ninja" ]; then
    ninja -C "$BUILD" -t inputs odraz odraz-safe | sed "s|^$SOURCE/||" >"$WORK/inputs"
    check "the film is made of files of intro and packer" grep -qx 'intro/main.cpp' "$WORK/inputs"
    check "... none of tests, and of tools only what the packer knows" lacks '^(tests|tools/(radiosity|measure|engine|picture))/' "$WORK/inputs"
fi
finish
