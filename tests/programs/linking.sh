# Sourced by tests of pack-link: links programs, and compares what they do with what they do when cc links them.
. "$(dirname "$0")/common.sh"
skip_unless gcc
needs_built pack-link
link=$BUILD/pack-link
cd "$WORK" || exit 1

says() { # says COMMAND...: what it prints, on each output, and its exit status
    timeout "$PATIENCE" "$@" >said.1 2>said.2
    echo "status $?" >>said.2
    cat said.1 said.2
} 2>/dev/null # where the shell tells of signals
# takes WAY WORD...: pack-link links them to packed/run, in that way, without a word on stderr
takes() {
    local way=$1
    shift
    mkdir -p packed
    "$link" "$@" -o packed/run >told 2>err && [ ! -s err ] && grep -q "^$way .*<- taken" told && return 0
    cat told err >&2
    return 1
}
# same COMPILER WORD...: packed/run does what the program does that COMPILER links of the words
same() {
    local compiler=$1
    shift
    mkdir -p plain
    $compiler "$@" -o plain/run || return 1
    (cd plain && says ./run a 'b c') >wanted
    (cd packed && says ./run a 'b c') >got
    cmp wanted got && [ "$(wc -l <got)" -gt 1 ]
}
# every OBJECT...: the program is the same by each way that is possible
ways() {
    local way
    for way in dynamic imports; do takes $way --way $way "$@" && same "gcc -no-pie" "$@" || return 1; done
}
