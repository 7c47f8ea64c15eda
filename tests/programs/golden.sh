# The film's pictures and music are those in tests/golden.
. "$(dirname "$0")/common.sh"
check "golden pictures" "$SOURCE/tools/golden" check "$BUILD"
check "golden music" "$SOURCE/tools/golden" hear "$BUILD"
finish
