# Packed programs in odd surroundings, and damaged ones: with the example in packer/example.
. "$(dirname "$0")/common.sh"
pack=$BUILD/pack hello=$WORK/hello
check "the example is built and packed" prints 'bytes left' bash "$SOURCE/packer/example/build.sh" "$pack" "$WORK"
check "it runs" exits 7 "hello, 1 words, 42" "$hello"
check "it gets its arguments" exits 7 "hello, 3 words, 42" "$hello" a b
check "it costs its payload and 3,149 bytes" prints '\(3149 of them stub and headers\)' "$pack" "$WORK/hello.elf" -o "$WORK/h"
check "without randomised addresses" exits 7 "hello, 1 words, 42" setarch -R "$hello"
check "with closed descriptors" bash -c "'$hello' <&- >&- 2>&-; test \$? = 7"
check "by another path" exits 7 "hello, 1 words, 42" bash -c "cd '$WORK' && exec ./hello"
check "in little memory" exits 7 "hello, 1 words, 42" bash -c "ulimit -v 120000; exec '$hello'"
check "in too little memory" refuses 1 "not enough free memory" bash -c "ulimit -v 40000; exec '$hello'"
if can_be_unwritten; then check "where written memory may not be executed" refuses 1 "it may not run packed." "${UNWRITTEN[@]}" "$hello"; fi
named() { # named OPTION...: packs the example with names, and it is still opened
    "$pack" "$WORK/hello.elf" -o "$WORK/named" "$@" >/dev/null && "$pack" --test "$WORK/named" >/dev/null
}
check "it may name a program to use instead" named --safe-name hello-safe
if can_be_unwritten; then check "... and does" refuses 1 "use hello-safe instead" "${UNWRITTEN[@]}" "$WORK/named"; fi
check "... and call itself by a name" named --name hello
check "... which runs" exits 7 "hello, 1 words, 42" "$WORK/named"
check "... and prints it" refuses 1 "hello: no memory" bash -c "ulimit -v 40000; exec '$WORK/named'"
check "for Windows, too" bash -c "bash '$SOURCE/packer/example/build.sh' '$pack' '$WORK' --pe >/dev/null && '$pack' '$WORK/hello_windows.elf' --pe -o '$WORK/named.exe' --name hello --safe-name hello-safe >/dev/null && grep -qa 'use hello-safe instead' '$WORK/named.exe' && '$pack' --test '$WORK/named.exe' >/dev/null"
check "a name that does not fit is refused" refuses 2 "--name takes up to 10 letters" "$pack" "$WORK/hello.elf" -o "$WORK/x" --name twelveletter
check "... or is none" refuses 2 "names consist of" "$pack" "$WORK/hello.elf" -o "$WORK/x" --safe-name "a b"

check "--test finds that it is whole" prints ': whole; ' "$pack" --test "$hello"
check "-d gives it back" "$pack" -d "$hello" -o "$WORK/plain"
check "... and that runs" exits 7 "hello, 2 words, 42" "$WORK/plain" a
# The image is as the linker laid it out, except for the loader's tables, which are zeros; this compares the code
read -r offset size <<<"$(readelf -SW "$WORK/hello.elf" | sed -n 's/.* \.text *PROGBITS *[0-9a-f]* \([0-9a-f]*\) \([0-9a-f]*\) .*/\1 \2/p')"
part() { tail -c +$(($2 + 0x$offset + 1)) "$1" | head -c $((0x$size)); }
part "$WORK/plain" 4096 >"$WORK/code"
check "the plain file has code" test "$(stat -c %s "$WORK/code")" = $((0x${size:-0})) -a -s "$WORK/code"
check "... the same as before packing, in the same place" cmp "$WORK/code" <(part "$WORK/hello.elf" 0)

check "-d of the film" "$pack" -d "$BUILD/odraz" -o "$WORK/film"
picture() { "$1" --dump - --from 20 --to 20.04 --size 64x36 >"$WORK/$2" && [ -s "$WORK/$2" ]; }
check "... draws" picture "$WORK/film" unpacked.ppm
check "... as the film draws" picture "$BUILD/odraz" packed.ppm
check "... the same" cmp "$WORK/unpacked.ppm" "$WORK/packed.ppm"

# Damage. Nothing can check the first 656 bytes: the header and the check itself
broken=$WORK/broken
cp "$hello" "$broken"
total=$(stat -c %s "$hello")
is_refused() { refuses 1 "damaged: get it afresh" "$broken" && refuses 2 "$broken: " "$pack" --test "$broken" && refuses 2 "$broken: " "$pack" -d "$broken" -o "$WORK/x"; }
flipped() {
    local at bit
    [ "$total" -gt 2000 ] || return 1
    for at in $(seq 656 41 $((total - 1))) $((total - 1)); do
        cp "$hello" "$broken" && flip "$broken" "$at" $((1 << at % 8)) && is_refused || { echo "at $at"; return 1; }
    done
}
check "a flipped bit anywhere is refused" flipped
numbers() { # wild numbers in the fields that the check reads
    local wild from=$((528 + $(stat -c %s "$BUILD/generated/stub.bin")))
    for wild in '\x55\x55\x55\x55' '\xa9\xcb\xed\x0f' '\xff\xff\xff\xff' '\0\0\0\0'; do
        cp "$hello" "$broken"
        printf "$wild$wild$wild" | dd of="$broken" bs=1 seek=$from conv=notrunc status=none
        is_refused || { echo "at $from: $wild"; return 1; }
    done
}
check "... and wild numbers in the payload header" numbers
cut_short() {
    local size
    for size in $(seq 660 97 $((total - 1))) $((total - 1)); do
        head -c "$size" "$hello" >"$broken" && is_refused || { echo "at $size"; return 1; }
    done
}
check "cut short anywhere it is refused" cut_short
cut_film() { # several pages are missing
    local size
    for size in 700 4096 4097 8192 20000 40000; do
        head -c "$size" "$BUILD/odraz" >"$broken" && is_refused || { echo "at $size"; return 1; }
    done
}
check "the film too" cut_film
{ cat "$hello"; echo "more bytes"; } >"$broken"
check "bytes behind its end do not matter" exits 7 "hello, 1 words, 42" "$broken"
check "... nor to --test" "$pack" --test "$broken"
ls "$WORK" >"$WORK/list"
check "refusals leave nothing behind" lacks '^x|part' "$WORK/list"
check "--test of what is not packed" refuses 2 "not packed by this version of pack" "$pack" --test "$pack"
check "-d of what is not packed" refuses 2 "not packed by this version of pack" "$pack" -d "$BUILD/odraz-safe" -o "$WORK/x"
finish
