# Sourced by the tests of `radiosity view`: skips them where something is missing, and starts a display.
. "$(dirname "$0")/display.sh"
. "$(dirname "$0")/room.sh"
skip_unless convert
needs_built radiosity compare
radiosity=$BUILD/radiosity
"$radiosity" view 2>&1 | grep -q 'left out of this build' &&
    { echo "SKIPPED: radiosity was built without GLFW"; exit 77; }
cd "$WORK" || exit 1

WINDOW='^radiosity: '
start_display 900x700
