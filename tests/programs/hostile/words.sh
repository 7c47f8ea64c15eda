# Random command lines of words that are right, wrong, extreme, missing, repeated, empty, very long or not even text.
# The program ends with status 0, 1 or 2, and leaves no half-written file. When it fails it prints one line on standard
# error and nothing on standard output; when it succeeds it prints nothing on standard error.
#   words.sh BUILD odraz|odraz-safe|pack|radiosity [RUNS] [SEED]
. "$(dirname "$0")/../common.sh"
name=${2:-odraz-safe} runs=${3:-100} seed=${4:-$((EPOCHSECONDS % 30000))}
needs_built "$name"
program=$BUILD/$name
unset DISPLAY WAYLAND_DISPLAY
echo "    seed $seed"
RANDOM=$seed

# --- The words ---
pick() { local n=$(($# > 0 ? RANDOM * 32768 + RANDOM : 0)); picked=${@:n % $# + 1:1}; } # sets picked
long=$(printf '%0100000d' 0)
junk=('' ' ' - -- 0 -1 1e999 -nan inf 99999999999999999999 0x10 +1 .5 1. '٣' 'žluťoučký kůň' $'\xff\xfe\x01' $'two\nlines' $'\e[31mred' %n%s%x "$long"
    --help= -h ... '*' "'" '"' \\ /dev/null/x none/deeper)
folders=(d d/ ./e . d/. ž $'\xff' - none/d file /proc "${long:0:300}" "${long:0:5000}")
files=(a ./b ž $'\xfe' - none/b . file /dev/full /dev/null "${long:0:300}" "${long:0:5000}")
values() { # values OPTION PLACEHOLDER: sets good to values to try, by its name or its placeholder in --help
    case $name$1 in
    odraz*--dump) good=("${folders[@]}") ;;
    odraz*--wav) good=("${files[@]}") ;;
    odraz*--fps) good=(25 30 1000 60 24000/1001 1/1000 23.976 1001 0 25/0 23.9761 1000000/1000000) ;;
    odraz*--from) good=(20 20.04 20.1 20.123456 20.1234567 00020 164 163.999999 165 100001) ;;
    odraz*--to) good=(20 20.04 20.1 20.2 0 19 164.000001 165 '') ;;
    odraz*--size) good=(16x9 1x1 64x36 7x13 7680x1 1x4320 0x0 7681x1 16x 16X9 16x9x3 x9 -16x9 99999999999x9) ;;
    odraz*--quality) good=(draft play film reference live Draft) ;;
    odraz*--threads) good=(1 2 64 65 0 1.5) ;;
    pack-o | pack--report | pack--html | pack--text | pack--save-model) good=("${files[@]}") ;;
    pack--than | pack--rooms) good=(hello.json hello.json hello.json hello.rooms file fifo /dev/zero none . '') ;;
    pack--map | pack--model) good=(hello.model hello.model hello.model hello hello.elf file fifo /dev/zero none . '') ;;
    pack--test | pack-d) good=(hello hello hello.elf hello.model file fifo /dev/zero /dev/null none . '') ;;
    pack--budget) good=(65536 1e8 9999 1 0 1e9 1.5) ;;
    pack--effort) good=(fast 0 0.1 fastest) ;;
    radiosity-o | radiosity--csv | radiosity--ply | radiosity--obj) good=("${files[@]}" x.obj x.png) ;;
    radiosity--lamps) good=(all none 1 l=2 2 1,1 l= ,) ;;
    radiosity--gloss*) good=(l m 0.06,16 none '' 1,1 0,1000 2,1 1,0 1) ;;
    radiosity--page) good=(256 8192 16384 255 16385) ;;
    radiosity--residual) good=(1 1e-4 0.5 1e-8 2) ;;
    radiosity--resume) good=(m.rad m.obj file none fifo .) ;;
    *)
        case ${2-} in
        *[a-z]\|[a-z]*) good=(${2//|/ } both) ;;
        DIR) good=("${folders[@]}") ;;
        N | PX | K) good=(8 1 32 2 16 25 64 0 2 6 7 33 65 1026 32769 1.5 -1) ;;
        A | AREA | S) good=(1 10 30 0.01 1e30 1e31 1e-19 1e6 0 -1) ;;
        DEGREES) good=(10 60 -90 170 0 171 1e9) ;;
        STOPS) good=(0 -20 20 21) ;;
        MB) good=(500 100 900 1 0.5 1e6 1e7) ;;
        X,Y,Z) good=(0,5,4.9 0,4,-5 0,0,0 1e30,0,0 1,2 1,2,3,4 nan,0,0) ;;
        WxH) good=(16x9 1x1 8x8 7681x1 0x0 16x) ;;
        R,G,B*) good=(1,1,1 0.2,0.3,0.5 file m.obj fifo /dev/zero none -1,0,0 1,2 nan,0,0) ;;
        ELEVATION,*) good=(30,60,5,5,5 90,0,1,2,3 -90,400,1,1,1 1,2,3,4 1,2,3,4,-5) ;;
        X,Y,Z,SIZE*) good=(1,2,3,0.5,9,9,9 0,0,0,1e-9,1,1,1 1e9,0,0,1,1,1,1 0,0,0,0,1,1,1 1,2,3) ;;
        *FACTOR) good=(0.5 0,0.5,1 l=1 2 1,2,3 l=1,1,2 l=0 l=1e13 none=1 1,2 =) ;;
        *) good=() ;;
        esac ;;
    esac
}
# Each command's options; other commands get all options
declare -A known
[ "$name" != radiosity ] || for command in generate solve transfer export render; do
    known[$command]=$("$program" $command --help)
done
known[all]=$("$program" --help; printf '%s\n' "${known[@]}")
for command in "${!known[@]}"; do
    known[$command]=$(sed -nE 's/^ +(--?[a-z][a-z-]*)( ([^ ]+))?.*/\1 \3/p' <<<"${known[$command]}" | sort -u)
done
check "--help lists options" test "$(wc -l <<<"${known[all]}")" -ge 6

# Sets words to a random command line. `bounds`, before or after it, keeps the run short
make_words() {
    local groups=$((RANDOM % 5)) group option
    words=()
    mapfile -t options <<<"${known[${bounds[0]:-all}]-${known[all]}}"
    for ((group = 0; group < groups; ++group)); do
        pick "${options[@]}"
        option=${picked% *}
        values "$option" "${picked#* }"
        case $((RANDOM % 32)) in
        0) words+=("$option") ;;                                     # without a value, or with the next word as its value
        1) pick "${junk[@]}"; words+=("$picked") ;;                  # a value without an option
        2) words+=("${option%?}") ;;                                 # misspelt
        3) pick "${good[@]-x}"; words+=("$option=$picked") ;;
        4 | 5) pick "${junk[@]}"; words+=("$option" "$picked") ;;
        6 | 7) words+=("$option"); [ ${#good[@]} = 0 ] || { pick "${good[@]}"; words+=("$picked"); } ;;
        # the first three of an option's values are valid
        *) words+=("$option"); [ ${#good[@]} = 0 ] || { pick "${good[@]:0:3}"; words+=("$picked"); } ;;
        esac
    done
    if [ $((RANDOM % 2)) = 0 ]; then words=("${bounds[@]}" "${words[@]}"); else words+=("${bounds[@]}"); fi
}
begin() { # sets bounds for the next command line
    case $name in
    odraz*) bounds=(--size 16x9 --quality draft --from 20 --to 20.04); [ $((RANDOM % 3)) = 0 ] || bounds+=(--dump e) ;;
    pack) pick 'hello.elf -o out' '--test hello' '-d hello -o out' hello.elf fifo '--test fifo' '/dev/zero -o out' 'file -o out'; bounds=($picked) ;;
    radiosity)
        pick 'generate cube -o x.obj' 'solve m.obj -o x.rad' 'export m.rad --csv x.csv' 'render m.rad -o x.png --size 16x9 --eye 0,5,4 --at 0,4,-5' 'transfer m.obj -o x.prt --rays 8' 'render m.prt -o x.png --size 16x9 --eye 0,5,4 --at 0,4,-5' 'render m.prt' 'export m.prt --csv x.csv' 'solve m.rad' 'export m.obj' 'solve fifo -o x.rad' solve render 'sing' ''
        bounds=($picked) ;;
    esac
}

# --- The files that the words name ---
mkdir "$WORK/given" "$WORK/run"
echo "a text" >"$WORK/given/file"
mkfifo "$WORK/given/fifo"
case $name in
pack)
    bash "$SOURCE/packer/example/build.sh" "$program" "$WORK/given" >/dev/null
    "$program" "$WORK/given/hello.elf" -o "$WORK/given/hello" --save-model "$WORK/given/hello.model" \
        --report "$WORK/given/hello.json" >/dev/null
    echo "room 9 a.o" >"$WORK/given/hello.rooms" ;;
radiosity)
    printf 'newmtl l\nKe 5 5 5\n' >"$WORK/given/m.mtl"
    printf 'mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nf 1 4 3 2\nusemtl l\nf 5 6 7\n' >"$WORK/given/m.obj"
    "$program" solve "$WORK/given/m.obj" -o "$WORK/given/m.rad" --patch 1 --element 1 >/dev/null
    "$program" transfer "$WORK/given/m.obj" -o "$WORK/given/m.prt" --bands 2 --element 1 >/dev/null ;;
esac
given=$(ls "$WORK/given")

# --- Checks ---
complaint() { # complaint STATUS: prints what is wrong with the last run
    local status=$1 lines
    [ $name != radiosity ] || sed -i '/^progress: /d' err # lines of --progress
    lines=$(wc -l <err)
    case $status in
    0)
        # (radiosity prints notes on the model, pack its search's progress, and a note if the file of --than is missing)
        case $name in radiosity) grep -v '^radiosity: ' err ;; pack) grep -vE '^(searching|pack: there is no)' err ;; *) cat err ;; esac |
            sed 's/^/although it succeeded: /' ;;
    1 | 2)
        # (--doctor prints a list, and exits with 1 if something is missing)
        [ $status = 1 ] && grep -q '^processor: ' out && return
        [ "$lines" = 1 ] && [ -z "$(tail -c 1 err)" ] || echo "$lines lines on standard error"
        # (pack prints its results before it fails to write a file)
        [ ! -s out ] || [ $name = pack ] || echo "standard output although it failed" ;;
    124 | 137) echo "it did not end" ;;
    *) echo "exit status $status" ;;
    esac
    LC_ALL=C grep -aq $'[\x01-\x09\x0b-\x1f]' err && echo "control characters on standard error"
    [ "$(ls run)" = "$given" ] && return
    find run -name '*.part' | sed 's/^/left behind: /'
    find run -name '*.ppm' -exec perl -e 'for (@ARGV) { open F, "<", $_; local $/; my $p = <F>; $p =~ /^P6\n(\d+) (\d+)\n255\n/s && length($p) == length($&) + 3 * $1 * $2 or print "not whole: $_\n" }' {} +
}
cd "$WORK" || exit 1
cp -a given/. run
tried() {
    local n status wrong succeeded=0 failed=0
    for ((n = 1; n <= runs; ++n)); do
        begin
        make_words
        (cd run && exec timeout -k 5 "$PATIENCE" "$program" "${words[@]}" >../out 2>../err </dev/null)
        status=$?
        wrong=$(complaint $status)
        if [ -n "$wrong" ]; then
            echo "run $n of seed $seed: $wrong" >&2
            printf '%s %s\n' "$name" "$(printf '%.300q ' "${words[@]}")" >&2
            head -c 1000 err >&2
            return 1
        fi
        [ $status = 0 ] && succeeded=$((succeeded + 1)) || failed=$((failed + 1))
        [ "$(ls run)" = "$given" ] || { rm -rf run && cp -a given run; }
    done
    echo "    $succeeded succeeded, $failed failed"
    [ $succeeded -gt $((runs / 50)) ] && [ $failed -gt $((runs / 50)) ] # otherwise the words would test little
}
check "$runs command lines for $name" tried
finish
