# The packer's command line: with the film where its bytes matter, otherwise with the small example.
. "$(dirname "$0")/common.sh"
skip_unless objdump
pack=$BUILD/pack in=$BUILD/odraz-safe model=$SOURCE/intro/odraz.model
bash "$SOURCE/packer/example/build.sh" "$pack" "$WORK" >/dev/null || exit 1
hello=$WORK/bare size=$(stat -c %s "$WORK/hello")
strip -s -o "$hello" "$WORK/hello.elf" || exit 1 # pack would report on symbols

# (binary.sh packs the stripped one)
check "packs to the same bytes again, with a report" prints '^adaptive.cpp.o ' "$pack" "$BUILD/odraz.elf" -o "$WORK/b" --model "$model" --safe-name odraz-safe --map "$BUILD/odraz.map" --symbols "$BUILD/generated/symbols" --report "$WORK/report"
check "... the film's size in it" grep -qE ' [0-9]+ bytes .*, [0-9]+ bytes left of 65536' "$WORK/printed"
check "... those of the film" cmp "$WORK/b" "$BUILD/odraz"
check "... executable" test -x "$WORK/b"
check "... which adds up to the payload" awk -F'[:}]' '
    /"sections"/ { on = 1 } /"objects"/ { on = 0 }
    on && /"bits"/ { sum += $(NF - 1); ++lines }
    /"file"/ { file = $2 + 0 } /"overhead"/ { over = $2 + 0 }
    END { d = file - over - sum / 8; exit !(lines > 2 && file > 10000 && d > -40 && d < 40) }' "$WORK/report"
check "prints how it compares to the file before" prints ' [0-9]+ bytes .*before [0-9]+ \(\+0\), ' "$pack" "$hello" -o "$WORK/hello"

# For Windows, not packed; and for Linux
check "makes an example for Windows" bash "$SOURCE/packer/example/build.sh" "$pack" "$WORK" --pe
check "... PE for x86-64" prints 'pei-x86-64' objdump -p "$WORK/hello.exe"
check "a plain one for Linux" "$pack" "$hello" -o "$WORK/plain" --plain
check "... runs" test "$("$WORK/plain" a b)" = "hello, 3 words, 42"

# A search from unsuitable contexts, so that there is something to find
awk '$1 == "code" { $2 = "byte4+byte3+instruction1" ($2 == "-" ? "" : "+" $2) } 1' "$model" >"$WORK/unsuited"
check "takes contexts that do not suit" prints 'bytes left' "$pack" "$hello" -o "$WORK/poor" --model "$WORK/unsuited"
behind "$pack" "$hello" -o "$WORK/found" --model "$WORK/unsuited" --effort 100000 --save-model "$WORK/model"
check "a search reports its progress" await grep -qE 'searching: [0-9]+ bytes after [0-9]+ tries, [0-9]+ of 100000 s' "$WORK/err"
check "... works" worked $pid 300
kill -INT $pid
check "... and interrupted packs with what it has" ended $pid
check "... which is smaller" test "$(stat -c %s "$WORK/found")" -lt "$(stat -c %s "$WORK/poor")"
check "... kept, with which the same bytes are made again" prints 'bytes left' "$pack" "$hello" -o "$WORK/again" --model "$WORK/model"
check "... the same" cmp "$WORK/found" "$WORK/again"
check "a search ends by itself" prints 'bytes left' bash -c "exec '$pack' '$hello' -o '$WORK/brief' --effort 0.5 2>/dev/null"

check "over budget is refused" refuses 1 "over budget by 1 bytes" "$pack" "$hello" -o "$WORK/c" --budget $((size - 1))
check "... and nothing written" test ! -e "$WORK/c"
cp "$WORK/b" "$WORK/d"
check "... nor a file that is there replaced" refuses 1 "over budget" "$pack" "$hello" -o "$WORK/d" --budget 100
check "... which stays as it was" cmp "$WORK/b" "$WORK/d"
check "at the budget is fine" prints ', 0 bytes left' "$pack" "$hello" -o "$WORK/c" --budget "$size"
check "no input" refuses 2 "it takes IN -o OUT" "$pack"
check "no output" refuses 2 "it takes IN -o OUT" "$pack" "$in"
check "bad budget" refuses 2 "--budget needs" "$pack" "$in" -o "$WORK/x" --budget 64k
check "bad effort" refuses 2 "--effort needs fast, normal, best or a number of seconds" "$pack" "$in" -o "$WORK/x" --effort more
mkfifo "$WORK/fifo"
for endless in "$WORK/fifo" /dev/zero; do check "a file that is a pipe or a device" refuses 2 "not a regular file" "$pack" "$endless" -o "$WORK/x"; done
check "a name of two lines, printed in one" refuses 2 "cannot use '--two?lines'" "$pack" $'--two\nlines'
check "a missing model" refuses 2 "cannot read" "$pack" "$in" -o "$WORK/x" --model "$WORK/none"
echo "code byte7" >"$WORK/bad"
check "a wrong model" refuses 2 "line 1: unknown field in 'byte7'" "$pack" "$in" -o "$WORK/x" --model "$WORK/bad"
check "a missing map" refuses 2 "cannot read" "$pack" "$in" -o "$WORK/x" --map "$WORK/none"
echo "a map" >"$WORK/map"
check "a map that is none" refuses 2 "not a map of GNU ld" "$pack" "$in" -o "$WORK/x" --map "$WORK/map"
check "two modes at once" refuses 2 "it takes IN -o OUT" "$pack" "$in" -o "$WORK/x" --test "$in"
check "what is for packing alone" refuses 2 "--budget is for packing alone" "$pack" --test "$BUILD/odraz" --budget 1
check "a file where a folder should be" refuses 2 "cannot write" "$pack" "$hello" -o /dev/full/x
"$pack" "$hello" -o "$WORK/p" 2>"$WORK/err" | head -c 0
check "a closed pipe" cmp "$WORK/p" "$WORK/hello"
check "missing file" refuses 2 "cannot read" "$pack" "$WORK/none" -o "$WORK/x"
check "unwritable output" refuses 2 "cannot write" "$pack" "$hello" -o "$WORK/none/x"
check "not an ELF file" refuses 2 "not an ELF file" "$pack" "$SOURCE/README.md" -o "$WORK/x"
check "a position-independent program, for Windows" refuses 2 "position-independent" "$pack" /bin/true -o "$WORK/x" --pe
check "a packed program" refuses 2 "it is packed already" "$pack" "$BUILD/odraz" -o "$WORK/x"
check "what is for packing alone" refuses 2 "--plain is for packing alone" "$pack" -d "$WORK/hello" -o "$WORK/x" --plain
check "a hosted program, for Windows" refuses 2 "constructors" "$pack" "$BUILD/pack" -o "$WORK/x" --pe
# An output that is a pipe or a device is not replaced by a file
cat "$WORK/fifo" >"$WORK/piped" &
PIDS+=($!)
check "a report into a pipe" "$pack" "$hello" -o "$WORK/again" --report "$WORK/fifo" >/dev/null
check "... comes out there" eval 'await grep -q "^}" "$WORK/piped" && [ -p "$WORK/fifo" ]'
if mknod -m 666 "$WORK/null" c 1 3 2>/dev/null && : 2>/dev/null >"$WORK/null"; then
    check "a report into nothing" "$pack" "$hello" -o "$WORK/again" --report "$WORK/null" >/dev/null
    check "... which stays a device" test -c "$WORK/null"
fi
rm -f "$WORK/again" "$WORK/piped"
ls "$WORK" >"$WORK/list"
check "refusals leave nothing behind" lacks '^x|part' "$WORK/list"
finish
