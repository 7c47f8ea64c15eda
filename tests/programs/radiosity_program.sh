# Sourced by tests of the radiosity program: sets radiosity, and enters WORK.
. "$(dirname "$0")/common.sh"
radiosity=$BUILD/radiosity
needs_built radiosity
cd "$WORK" || exit 1
