# pack and tools/ledger pack report sizes: pages, texts and JSON add up to the file, and are compared with earlier ones.
. "$(dirname "$0")/common.sh"
skip_unless perl objdump gcc ar
pack=("$BUILD/pack" --model "$SOURCE/tests/support/small.model") page=$SOURCE/tests/programs/report/page.pl
cd "$WORK" || exit 1

# A program of two files, one of them in an archive, with padding, unnamed constants, and two names for one function
mkdir folder
cat >folder/main.c <<'END_C'
#include <stdio.h>
int twice(int);
int again(int) __attribute__((alias("once")));
int once(int i) { return i * 3 + 1; }
int main(int words, char **word) { return printf("%d of %s\n", twice(once(words)) + again(2), word[0]) < 0; }
END_C
echo 'int twice(int i) { int all = 0; for (int n = 0; n < i; ++n) all += n % 3 ? 2 : i; return all; }' >twice.c
gcc -O1 -c folder/main.c -o folder/main.o && gcc -O1 -c twice.c && ar rc libtwice.a twice.o &&
    gcc folder/main.o libtwice.a -Wl,-Map=program.map -o program || exit 1
packs=("${pack[@]}" program -o packed --map program.map)
sums() { perl "$page" "$@" sums; }
json_sums() { # json_sums REPORT: succeeds if its figures add up, in whole bits
    perl -MJSON::PP -e 'local $/; my $r = decode_json(<>); my $n = 0;
        for my $part (grep { ref $r->{$_} && %{$r->{$_}} } keys %$r) {
            my $all = 8 * $r->{overhead} + $r->{rest}; $all += $_->{bits} for values %{$r->{$part}};
            $all == 8 * $r->{file} or die "$part: $all bits\n"; ++$n }
        exit($n < 2)' "$1"
}
check "a page, a report and a text" "${packs[@]}" --html a.html --report a.json --text a.md --budget 5000 >printed
check "the page adds up to the file" prints '^[0-9]+ bytes of [0-9]+, [0-9]{2} stretches, [1-9][0-9]+ instructions$' sums a.html
check "... whose size is on the page" grep -q " of $(stat -c %s packed), " printed
check "the report adds up, too" json_sums a.json
check "the text has size and budget" grep -qx "\*\*\`packed\`: $(sed ':a; s/\B[0-9]\{3\}\>/,&/; ta' <<<"$(stat -c %s packed)") bytes\*\*, .* left of 5,000" a.md
perl "$page" a.html tables >tables
check "the page names the object in the archive, and the folder" eval 'grep -q "\"twice.o\",\"libtwice.a\"" tables && grep -q "\"main.o\",\"folder\"" tables'
check "a function with two names is listed once" test "$(grep -oE '"(once|again)"\]' tables | wc -l)" = 1
check "unnamed data is listed, too" grep -q '"(nothing named in .rodata)"\]' tables
read -r address size <<<"$(readelf -SW program | sed -n 's/.* \.text *PROGBITS *\([0-9a-f]*\) [0-9a-f]* \([0-9a-f]*\) .*/\1 \2/p')"
objcopy -O binary -j .text program code
check "the page has the program's bytes" cmp code <(perl "$page" a.html bytes | tail -c +$((0x$address + 1)) | head -c $((0x$size)))
check "the page needs no network" eval '! grep -qE "https?://|src=|@import|url\(" a.html'
check "without objdump" env PATH=/none "${pack[@]}" program -o packed --html c.html >/dev/null
check "... a page without instructions" prints ', 0 instructions$' sums c.html
strip program -o stripped
check "a program without symbols" "${pack[@]}" stripped -o packed --html d.html --text d.md >/dev/null
check "... adds up" sums d.html >/dev/null
check "... its text is about sections" grep -q '^|   packed | section |$' d.md
bash "$SOURCE/packer/example/build.sh" true . && bash "$SOURCE/packer/example/build.sh" true . --pe || exit 1
check "a program made for packing" "${pack[@]}" hello.elf -o hello --html e.html --report e.json >/dev/null
check "... adds up" eval 'sums e.html >/dev/null && json_sums e.json'
check "... for Windows" "${pack[@]}" hello_windows.elf -o hello.exe --pe --html f.html --report f.json >printed
used=$(sed -n 's/^"file": \(.*\),/\1/p' f.json) size=$(stat -c %s hello.exe)
check "... adds up" eval 'sums f.html >/dev/null && json_sums f.json'
check "... to the bytes used, all but the zeros that fill the file" test $(((used + 511) / 512 * 512)) = "$size"
check "... which count for the budget" \
    grep -q "^hello.exe: $used bytes used of $size .* $((65536 - used)) bytes left of 65536\$" printed
check "... but the file may not exceed it, either" eval '! "${pack[@]}" hello_windows.elf -o hello.exe --pe \
    --budget $((size - 1)) >printed 2>refusal && grep -q "over budget by 1 bytes (" refusal'

# --- Two builds ---
sed -i 's/i \* 3 + 1/i * 3 + 1 + (i > 5 ? i \/ 7 : i << 20 ^ 0x12345678)/' folder/main.c
gcc -O1 -c folder/main.c -o folder/main.o && gcc folder/main.o libtwice.a -Wl,-Map=program.map -o program || exit 1
echo "house 100 main.o twice.o
stub 4000 (stub)" >rooms
"${packs[@]}" --html g.html --report g.json --text - --than a.json --rooms rooms >text
check "a comparison names what grew, and nothing else is printed" test "$(grep -cE '^\| +\+[0-9]+ \| +[0-9]+ \| +[0-9]+ \| `(once|again)` \|$' text)/$(grep -c '^packed: ' text)" = 1/0
check "... the page, too, and both add up" sums g.html >/dev/null
perl "$page" g.html tables >tables
check "... by rooms and their shares" grep -q '"shares":{"house":100,"stub":4000}' tables
check "... with the stub's" grep -q '"stubRoom":"stub"' tables
check "a comparison with itself lists no changes" prints '^No symbol changed by four bytes or more\.$' "${packs[@]}" --text - --than g.json
over() { "${packs[@]}" --html over.html --budget 9 >/dev/null 2>&1; [ $? = 1 ] && sums over.html >/dev/null; }
check "a program over its budget gets a page, too" over

check "a missing earlier report is noted" eval '"${packs[@]}" --text - --than none >text 2>note && grep -qx "pack: there is no none yet, so nothing is compared: write it with --report" note && grep -q " symbol" text'

# --- Refused before anything is packed or written ---
echo '{"file": 5}' >foreign
rm packed
for words in "--than foreign: foreign: not a report of pack" "--report none/x: cannot write none/x"; do
    check "refused: ${words%%: *}" refuses 2 "${words#*: }" "${packs[@]}" --html x.html ${words%%: *}
done
check "refusals write nothing" eval '[ ! -e packed ] && [ ! -e x.html ] && ! ls | grep part'

# --- tools/ledger, with this program in place of the film ---
mkdir -p film/generated && cp program film/odraz.elf && cp program.map film/odraz.map && ln -s "$BUILD/pack" film/pack && : >film/generated/symbols && cp a.html film/odraz
check "the film's page" env BUILD=film "$SOURCE/tools/ledger" pack --html film.html --than "$SOURCE/intro/size_ledger.json" >/dev/null
check "... adds up" sums film.html >/dev/null
perl "$page" film.html tables >tables
check "... has the stub's share" grep -qE '"shares":\{[^}]*"stub":[0-9]{4}.*"stubRoom":"stub"' tables
check "... and the room of main.cpp.o in the ledger" grep -qE '"before":\{.*"rooms":\{[^}]*"intro":[1-9][0-9]+' tables
finish
