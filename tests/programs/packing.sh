# The packer's command line, with the small example.
. "$(dirname "$0")/common.sh"
pack=$BUILD/pack model=$SOURCE/tests/support/small.model
bash "$SOURCE/packer/example/build.sh" true "$WORK" || exit 1 # `true` in place of pack
hello=$WORK/bare
strip -s -o "$hello" "$WORK/hello.elf" || exit 1 # otherwise pack would report symbols
packs=("$pack" "$hello" --model "$model")
"${packs[@]}" -o "$WORK/hello" --report "$WORK/report" >/dev/null
size=$(stat -c %s "$WORK/hello")

check "it packs over its earlier output, and prints the difference" prints ', before [0-9]+ \(\+0\), ' "${packs[@]}" -o "$WORK/hello"
check "... executable" test -x "$WORK/hello"
: >"$WORK/none"
check "the film's packer" "$BUILD/pack_film" elf "$hello" "$WORK/same" "$model" "" 65536 "$WORK/none" "$WORK/none" "$WORK/same.json" >/dev/null
check "... makes the same" eval 'cmp "$WORK/hello" "$WORK/same" && cmp "$WORK/report" "$WORK/same.json"'
check "a plain program" "$pack" "$hello" -o "$WORK/plain" --plain
check "... runs" exits 7 "hello, 3 words, 42" "$WORK/plain" a b

# A search that starts from unsuitable contexts, so that there are better ones to find
awk '$1 == "code" { $2 = "byte4+byte3+instruction1" ($2 == "-" ? "" : "+" $2) } 1' "$model" >"$WORK/unsuited"
check "takes unsuitable contexts" prints 'bytes left' "$pack" "$hello" -o "$WORK/poor" --model "$WORK/unsuited"
in_background "$pack" "$hello" -o "$WORK/found" --model "$WORK/unsuited" --effort 100000 --save-model "$WORK/model"
check "a search reports its progress" await grep -qE 'searching: [0-9]+ bytes after [0-9]+ tries, [0-9]+ of 100000 s' "$WORK/err"
check "... keeps the processor busy" worked $pid 100
kill -INT $pid
check "... and when interrupted packs with the best contexts so far" ended $pid
check "... which is smaller" test "$(stat -c %s "$WORK/found")" -lt "$(stat -c %s "$WORK/poor")"
check "... the model that it saved packs, too" prints 'bytes left' "$pack" "$hello" -o "$WORK/again" --model "$WORK/model"
check "... to the same bytes" cmp "$WORK/found" "$WORK/again"
check "a search ends by itself" prints 'bytes left' bash -c "exec '$pack' '$hello' -o '$WORK/brief' --effort 0.5 2>/dev/null"

cp "$WORK/hello" "$WORK/large"
check "a program over budget is refused, with size and budget" refuses 1 "over budget by 1 bytes (3," "${packs[@]}" -o "$WORK/large" --budget $((size - 1))
check "... and no file is left" test ! -e "$WORK/large"
echo kept >"$WORK/appended"
check "... but a file that is appended to stays" eval '! "${packs[@]}" -o /dev/stdout --budget 9 >>"$WORK/appended" 2>/dev/null && grep -qx kept "$WORK/appended"'
check "a program that has just its budget is accepted" prints ', 0 bytes left' "${packs[@]}" -o "$WORK/c" --budget "$size"
mkfifo "$WORK/fifo"
check "a file that is a pipe" refuses 2 "not a regular file" "$pack" "$WORK/fifo" -o "$WORK/x"
check "a packed program" refuses 2 "it is packed already" "$pack" "$WORK/hello" -o "$WORK/x"
check "an output that cannot be written" refuses 2 "cannot write" "${packs[@]}" -o /dev/full/x
"${packs[@]}" -o "$WORK/p" 2>"$WORK/err" | head -c 0
check "a closed pipe" cmp "$WORK/p" "$WORK/hello"
# (radiosity.sh tests outputs that are pipes)
cp "$hello" "$WORK/in"
for words in "in -o ./in" "in -o x --html in" "in -o x --model model --report model"; do
    check "refused: $words" refuses 2 "would be overwritten" bash -c "cd '$WORK' && exec '$pack' $words"
done
check "... and the input is unchanged" cmp "$hello" "$WORK/in"
check "contexts may replace those that were given" bash -c "cd '$WORK' && exec '$pack' in -o in.packed --model model --save-model model >/dev/null"
ls "$WORK" >"$WORK/list"
check "refusals leave nothing behind" lacks '^x|part' "$WORK/list"
finish
