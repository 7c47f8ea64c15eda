# `tradeoff pack`, which measures the packer's speed and size: its quick run.
. "$(dirname "$0")/common.sh"
needs_built tradeoff
tradeoff=$BUILD/tradeoff
check "the packer's trade-off is measured" \
    "$tradeoff" pack --quick --model "$SOURCE/intro/odraz.model" --csv "$WORK/csv" --plot "$WORK/svg" "$BUILD/odraz-safe"
check "... as a table" grep -qx "file,setting,shipped,bytes,encode_s,decode_kb_s,memory_mb" "$WORK/csv"
check "... with one point that ships, whose size is the film's" \
    table "$WORK/csv" 'if ($3 == 1) { ++shipped; bytes = $4 }' "shipped == 1 && bytes > 10000 && bytes <= $(($(stat -c %s "$BUILD/odraz") - 2634))"
check "... and as a plot" grep -q '^<svg' "$WORK/svg"
check "... of at least five" test "$(grep -c 'class="mark"' "$WORK/svg")" -ge 5
check "a missing film" refuses 2 "cannot read" "$tradeoff" pack "$WORK/none"
check "a film that is none" refuses 2 "not an ELF file" "$tradeoff" pack "$SOURCE/README.md"
check "a missing model" refuses 2 "cannot read" "$tradeoff" pack --model "$WORK/none" "$BUILD/odraz-safe"
check "no name" refuses 2 "a command is missing, trace or pack" "$tradeoff"
finish
