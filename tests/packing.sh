# The packer's command line.
. "$(dirname "$0")/common.sh"
pack=$BUILD/pack in=$BUILD/odraz-safe
check "packs to the same bytes again" bash -c "'$pack' '$in' -o '$WORK/a' >/dev/null && cmp '$WORK/a' '$BUILD/odraz'"
check "packs the file with symbols alike" bash -c "'$pack' '$BUILD/odraz.elf' -o '$WORK/b' >/dev/null && cmp '$WORK/b' '$BUILD/odraz'"
check "its output is executable" test -x "$WORK/a"
check "prints size, previous size and bytes left" bash -c "'$pack' '$in' -o '$WORK/a' | grep -qE ' [0-9]+ bytes .*before [0-9]+ \(\+0\), [0-9]+ bytes left of 65536'"
size=$(stat -c %s "$WORK/a")
check "over budget is refused" refuses 1 "over budget by 1 bytes" "$pack" "$in" -o "$WORK/c" --budget $((size - 1))
check "... and nothing written" test ! -e "$WORK/c"
check "... nor replaced" bash -c "cp '$WORK/a' '$WORK/d'; '$pack' '$in' -o '$WORK/d' --budget 100 2>/dev/null; cmp '$WORK/a' '$WORK/d'"
check "at the budget is fine" bash -c "'$pack' '$in' -o '$WORK/c' --budget $size | grep -q ', 0 bytes left'"
check "no input" refuses 2 "it takes IN.elf -o OUT" "$pack"
check "no output" refuses 2 "it takes IN.elf -o OUT" "$pack" "$in"
check "bad budget" refuses 2 "--budget needs" "$pack" "$in" -o "$WORK/x" --budget 64k
check "missing file" refuses 2 "cannot read" "$pack" "$WORK/none" -o "$WORK/x"
check "unwritable output" refuses 2 "cannot write" "$pack" "$in" -o "$WORK/none/x"
check "not an ELF file" refuses 2 "not an ELF file" "$pack" "$SOURCE/README.md" -o "$WORK/x"
check "a position-independent program" refuses 2 "position-independent" "$pack" /bin/true -o "$WORK/x"
check "a packed program" refuses 2 "linked below" "$pack" "$BUILD/odraz" -o "$WORK/x"
check "a hosted program" refuses 2 "constructors" "$pack" "$BUILD/pack" -o "$WORK/x"
head -c 3000 "$in" >"$WORK/short"
check "a file cut short" refuses 2 "cut short" "$pack" "$WORK/short" -o "$WORK/x"
check "refusals leave nothing behind" bash -c "! ls '$WORK' | grep -qE '^x|part'"
finish
