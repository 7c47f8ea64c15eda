# The packed program of packer/example, in odd environments and damaged.
. "$(dirname "$0")/common.sh"
pack=$BUILD/pack hello=$WORK/hello
check "the example is built and packed" prints 'bytes left' bash "$SOURCE/packer/example/build.sh" "$pack" "$WORK"
check "it runs" exits 7 "hello, 1 words, 42" "$hello"
check "it gets its arguments" exits 7 "hello, 3 words, 42" "$hello" a b
check "its size is its payload and 3,147 bytes" prints '\(3147 of them stub and headers\)' "$pack" "$WORK/hello.elf" -o "$WORK/h"
check "without randomised addresses" exits 7 "hello, 1 words, 42" setarch -R "$hello"
check "with closed descriptors" bash -c "'$hello' <&- >&- 2>&-; test \$? = 7"
check "by another path" exits 7 "hello, 1 words, 42" bash -c "cd '$WORK' && exec ./hello"
check "with little memory" exits 7 "hello, 1 words, 42" bash -c "ulimit -v 120000; exec '$hello'"
check "with too little memory" refuses 1 "not enough free memory" bash -c "ulimit -v 40000; exec '$hello'"
if has_mdwe; then check "where written memory may not be executed" refuses 1 "it may not run packed." "${MDWE[@]}" "$hello"; fi
check "it may name a program to use instead" eval '"$pack" "$WORK/hello.elf" -o "$WORK/named" --safe-name hello-safe --fast >/dev/null && "$pack" --test "$WORK/named" >/dev/null'
check "... which runs" exits 7 "hello, 1 words, 42" "$WORK/named"
if has_mdwe; then check "... and prints that name" refuses 1 "use hello-safe instead" "${MDWE[@]}" "$WORK/named"; fi

check "--test reports that it is whole" prints ': whole; ' "$pack" --test "$hello"
check "-d unpacks it" "$pack" -d "$hello" -o "$WORK/plain"
check "... and that runs" exits 7 "hello, 2 words, 42" "$WORK/plain" a
# -d gives the image as the linker laid it out, except for the loader's tables, which are zeros. Compare the code
read -r offset size <<<"$(readelf -SW "$WORK/hello.elf" | sed -n 's/.* \.text *PROGBITS *[0-9a-f]* \([0-9a-f]*\) \([0-9a-f]*\) .*/\1 \2/p')"
part() { tail -c +$(($2 + 0x$offset + 1)) "$1" | head -c $((0x$size)); }
part "$WORK/plain" 4096 >"$WORK/code"
check "the plain file has code" test "$(stat -c %s "$WORK/code")" = $((0x${size:-0})) -a -s "$WORK/code"
check "... the same as before packing, in the same place" cmp "$WORK/code" <(part "$WORK/hello.elf" 0)

# Damage. Nothing can check the first 656 bytes: the header and the check itself. (elf_test damages each byte for --test
# and -d; hostile/damaged.sh cuts and overwrites the film)
broken=$WORK/broken total=$(stat -c %s "$hello")
is_refused() { refuses 1 "damaged: copy it again" "$broken"; }
flipped() {
    local at
    for at in $(seq 656 97 $((total - 1))) $((total - 1)); do
        cp "$hello" "$broken" && flip "$broken" "$at" $((1 << at % 8)) && is_refused || { echo "at $at"; return 1; }
    done
}
check "a flipped bit anywhere is refused" flipped
check "... by --test, too" refuses 2 "$broken: damaged" "$pack" --test "$broken"
numbers() { # writes extreme numbers into the fields that the check reads
    local wild from=$((528 + $(stat -c %s "$BUILD/generated/stub.bin")))
    for wild in '\x55\x55\x55\x55' '\xa9\xcb\xed\x0f' '\xff\xff\xff\xff' '\0\0\0\0'; do
        cp "$hello" "$broken"
        printf "$wild$wild$wild" | dd of="$broken" bs=1 seek=$from conv=notrunc status=none
        is_refused || { echo "at $from: $wild"; return 1; }
    done
}
check "... and extreme numbers in the payload header" numbers
{ cat "$hello"; echo "more bytes"; } >"$broken"
check "bytes after its end do not matter" exits 7 "hello, 1 words, 42" "$broken"
check "... nor to --test" "$pack" --test "$broken"
finish
