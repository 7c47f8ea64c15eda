# The film's pictures against those in tests/golden. (pictures.sh looks whether the packed film draws the same.)
. "$(dirname "$0")/common.sh"
check "golden pictures" "$SOURCE/tools/golden" compare "$BUILD"
finish
