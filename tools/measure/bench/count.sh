# Sourced: counts the instructions of a part of a picture, by callgrind on one thread. Two runs: one poses the scene
# without callgrind, under which the hall would take half an hour; the other is counted.

# posed PROGRAM FILE SCENE [WxH]: poses a scene with a build's trace_once and keeps it in FILE
posed() { "$1" pose "$2" "$3" ${4:+--size "$4"} >&2; }

# counted PROGRAM FILE WHAT [SETTING]: prints the instructions of the part WHAT of a picture: posing; trace, with a
# SETTING; glare; development
counted() {
    local log of words
    case $3 in
    posing) of='odraz::measure::poseSubject*' words=(again "$2") ;;
    trace) of='odraz::forTiles*' words=(trace "$2" "$4") ;;
    development) of='odraz::develop(*const&)' words=(develop "$2") ;;
    glare) of='odraz::spreadGlare*' words=(develop "$2") ;;
    esac
    log=$(mktemp)
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --collect-atstart=no --toggle-collect="$of" \
        "$1" "${words[@]}" >"$log" 2>&1 || { cat "$log" >&2; rm "$log"; return 1; }
    awk '$2 == "Collected" { print $4 }' "$log"
    rm "$log"
}

# spent [--of FUNCTION] COMMAND...: prints the instructions of a program, in millions; with --of those of a function and
# all that it calls, by callgrind. Whole programs are counted by the processor if perf is allowed to, which takes no
# extra time.
spent() {
    local of=() log counted=
    if [ "$1" = --of ]; then
        of=(--collect-atstart=no --toggle-collect="$2")
        shift 2
    fi
    log=$(mktemp)
    [ ${#of[@]} -gt 0 ] || ! grep -q '[0-9] *instructions' <<<"$(perf stat -e instructions:u true 2>&1)" || {
        perf stat -x, -e instructions:u -o "$log" "$@" >/dev/null 2>&1
        counted=$(awk -F, '$3 ~ /^instructions/ { print $1 }' "$log")
    }
    if [ -z "$counted" ]; then
        valgrind --tool=callgrind --callgrind-out-file=/dev/null "${of[@]}" "$@" >/dev/null 2>"$log" ||
            { cat "$log" >&2; rm "$log"; return 1; }
        counted=$(awk '$2 == "Collected" { print $4 }' "$log")
    fi
    rm "$log"
    awk "BEGIN { v = $counted / 1e6; printf v < 10 ? \"%.2f\\n\" : \"%.0f\\n\", v }"
}
