# Sourced: instructions that a part of a picture takes, counted by callgrind on one thread. One run poses (under callgrind
# the hall would take half an hour), another is counted.

# posed PROGRAM FILE SCENE [WIDTH HEIGHT]: keeps a scene in FILE, by a build's trace_once
posed() { "$1" pose "${@:2}" >&2; }

# counted PROGRAM FILE WHAT [SETTING [CALLGRIND-OUT]]: prints the instructions of the part WHAT of a picture: posing; finish,
# which is of posing what builds the tree; trace, with a SETTING; air, which
# scatters light; development, and what it is without air: bare
counted() {
    local log of words
    case $3 in
    posing) of='odraz::poseSubject*' words=(again "$2") ;;
    finish) of='odraz::Scene::finish*' words=(again "$2") ;;
    trace) of='odraz::traceFrame*' words=(trace "$2" "$4") ;;
    development) of='odraz::develop(*' words=(develop "$2") ;;
    bare) of='odraz::develop(*' words=(bare "$2") ;;
    air) of='odraz::scatterLight*' words=(develop "$2") ;;
    esac
    log=$(mktemp)
    valgrind --tool=callgrind --callgrind-out-file="${5-/dev/null}" --collect-atstart=no --toggle-collect="$of" \
        "$1" "${words[@]}" >"$log" 2>&1 || { cat "$log" >&2; rm "$log"; return 1; }
    awk '$2 == "Collected" { print $4 }' "$log"
    rm "$log"
}
