# The whole film in a window, and part of it again: every scene is shown; it ends by itself and prints nothing on
# standard error; memory, descriptors and threads do not grow. SOAK_MINUTES=0.5 makes it shorter, to try it.
. "$(dirname "$0")/../common.sh"
skip_unless Xvfb
minutes=${SOAK_MINUTES:-3}
unset DISPLAY
soaks() { "$SOURCE/tests/support/soak" "$minutes" --film "$BUILD/odraz" >"$WORK/soak"; }
check "it plays for $minutes minutes without a fault" soaks
cat "$WORK/soak"
scenes=(point table flake patches hall odraz credits)
[ "$minutes" = 3 ] || scenes=(point)
for scene in "${scenes[@]}"; do
    check "... $scene was shown" grep -qE "^\| $scene \|( [0-9]+ \|){2} [1-9]" "$WORK/soak"
done
check "... within 512 MB" \
    less "$(sed -n 's/^| all |.*| \([0-9]*\) at most | [0-9.]* at most.*/\1/p' "$WORK/soak" | head -n 1)" 512
finish
