# The programs that measure: their quick runs, and what they refuse.
. "$(dirname "$0")/common.sh"
tradeoff=$BUILD/tradeoff
check "the packer's trade is measured" bash -c "'$tradeoff' pack --quick --model '$SOURCE/tests/odraz.model' --csv '$WORK/csv' --plot '$WORK/svg' '$BUILD/odraz-safe' >'$WORK/out'"
check "... as a table" grep -qx "file,setting,shipped,bytes,encode_s,decode_kb_s,memory_mb" "$WORK/csv"
check "... with one point that ships" test "$(awk -F, '$3 == 1' "$WORK/csv" | wc -l)" = 1
check "... whose size is the film's" bash -c "[ \$(awk -F, '\$3 == 1 { print \$4 }' '$WORK/csv') -le \$((\$(stat -c %s '$BUILD/odraz') - 2560)) ]"
check "... and as a plot" bash -c "grep -q '^<svg' '$WORK/svg' && [ \$(grep -c '<circle' '$WORK/svg') -ge 5 ]"
check "no name" refuses 2 "name what to measure" "$tradeoff"
check "an unknown option" refuses 2 "cannot use '--slow'" "$tradeoff" pack --slow
check "a missing film" refuses 2 "cannot read" "$tradeoff" pack "$WORK/none"
check "a film that is none" refuses 2 "not an ELF file" "$tradeoff" pack "$SOURCE/README.md"
check "a missing model" refuses 2 "cannot be read" "$tradeoff" pack --model "$WORK/none" "$BUILD/odraz-safe"
check "bench_pack refuses options it does not know" refuses 2 "usage: bench_pack" "$BUILD/bench_pack" --slow
finish
