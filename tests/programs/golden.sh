# The film's pictures as the packed film dumps them, against those in tests/golden.
. "$(dirname "$0")/common.sh"
check "golden pictures" "$SOURCE/tools/golden" compare "$BUILD"
finish
