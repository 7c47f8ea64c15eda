# The packer's command line.
. "$(dirname "$0")/common.sh"
pack=$BUILD/pack in=$BUILD/odraz-safe model=$SOURCE/intro/odraz.model
check "packs to the same bytes again" bash -c "'$pack' '$in' -o '$WORK/a' --model '$model' >/dev/null && cmp '$WORK/a' '$BUILD/odraz'"
check "packs the file with symbols alike" bash -c "'$pack' '$BUILD/odraz.elf' -o '$WORK/b' --model '$model' >/dev/null && cmp '$WORK/b' '$BUILD/odraz'"
check "its output is executable" test -x "$WORK/a"
check "prints size, previous size and bytes left" bash -c "'$pack' '$in' -o '$WORK/a' --model '$model' | grep -qE ' [0-9]+ bytes .*before [0-9]+ \(\+0\), [0-9]+ bytes left of 65536'"
size=$(stat -c %s "$WORK/a")
check "the report adds up to the payload" bash -c "'$pack' '$BUILD/odraz.elf' -o '$WORK/a' --map '$BUILD/odraz.map' --report '$WORK/report' | grep -q '^whitted.cpp.o ' && awk -F'[:}]' '/\"sections\"/{on=1} /\"objects\"/{on=0} on && /\"bits\"/{sum+=\$(NF-1)} /\"file\"/{file=\$2+0} /\"overhead\"/{over=\$2+0} END{d=file-over-sum/8; exit !(d > -40 && d < 40)}' '$WORK/report'"
check "a search finds and keeps contexts" bash -c "'$pack' '$in' -o '$WORK/s' --effort 4 --save-model '$WORK/model' 2>'$WORK/err' >/dev/null && grep -q 'searching: [0-9]* bytes after' '$WORK/err'"
check "... with which the same bytes are made again" bash -c "'$pack' '$in' -o '$WORK/t' --model '$WORK/model' >/dev/null && cmp '$WORK/s' '$WORK/t'"
interrupted() {
    "$pack" "$in" -o "$WORK/i" --effort 1000 2>"$WORK/err" >/dev/null &
    local pid=$!
    sleep 3
    kill -INT $pid
    wait $pid && [ -x "$WORK/i" ]
}
check "an interrupted search packs with what it has" interrupted
check "over budget is refused" refuses 1 "over budget by 1 bytes" "$pack" "$in" -o "$WORK/c" --model "$model" --budget $((size - 1))
check "... and nothing written" test ! -e "$WORK/c"
check "... nor replaced" bash -c "cp '$WORK/a' '$WORK/d'; '$pack' '$in' -o '$WORK/d' --budget 100 2>/dev/null; cmp '$WORK/a' '$WORK/d'"
check "at the budget is fine" bash -c "'$pack' '$in' -o '$WORK/c' --model '$model' --budget $size | grep -q ', 0 bytes left'"
check "no input" refuses 2 "it takes IN.elf -o OUT" "$pack"
check "no output" refuses 2 "it takes IN.elf -o OUT" "$pack" "$in"
check "bad budget" refuses 2 "--budget needs" "$pack" "$in" -o "$WORK/x" --budget 64k
check "bad effort" refuses 2 "--effort needs fast, normal, best or a number of seconds" "$pack" "$in" -o "$WORK/x" --effort more
check "a missing model" refuses 2 "cannot read" "$pack" "$in" -o "$WORK/x" --model "$WORK/none"
echo "code byte7" >"$WORK/bad"
check "a wrong model" refuses 2 "line 1: unknown field in 'byte7'" "$pack" "$in" -o "$WORK/x" --model "$WORK/bad"
check "a missing map" refuses 2 "cannot read" "$pack" "$in" -o "$WORK/x" --map "$WORK/none"
echo "a map" >"$WORK/map"
check "a map that is none" refuses 2 "not a map of GNU ld" "$pack" "$in" -o "$WORK/x" --map "$WORK/map"
check "two at once" refuses 2 "it takes IN.elf -o OUT" "$pack" "$in" -o "$WORK/x" --test "$in"
check "what is for packing alone" refuses 2 "--budget is for packing alone" "$pack" --test "$BUILD/odraz" --budget 1
check "an unknown option" refuses 2 "cannot use '--fast'" "$pack" --fast
check "a full disk" refuses 2 "cannot write" "$pack" "$in" -o /dev/full/x
check "a closed pipe" bash -c "'$pack' '$in' -o '$WORK/p' --model '$model' 2>'$WORK/err' | head -c 0; cmp -s '$WORK/p' '$BUILD/odraz'"
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
