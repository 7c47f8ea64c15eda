# No ordinary test fails because the machine is busy: all tests pass three times during four busy loops, and once on one
# processor.
#   busy.sh BUILD [CTEST OPTION...]
. "$(dirname "$0")/../common.sh"
options=("${@:2}")
mkdir "$WORK/tests" # a separate folder for ctest's own files
echo "subdirs(\"$BUILD\")" >"$WORK/tests/CTestTestfile.cmake"
all_pass() { # all_pass COMMAND...: runs ctest under the command, one test more at a time than there are processors
    "$@" ctest --test-dir "$WORK/tests" --output-on-failure -j $(($("$@" nproc) + 1)) "${options[@]}" >"$WORK/printed" 2>&1 &&
        grep '^100% tests passed' "$WORK/printed" || { cat "$WORK/printed" >&2; return 1; }
}
loops=()
for _ in 1 2 3 4; do
    while kill -0 $$ 2>/dev/null; do :; done &
    loops+=($!)
done
PIDS+=("${loops[@]}")
for round in 1 2 3; do check "all tests pass during four busy loops, round $round" all_pass env; done
kill "${loops[@]}"
check "all tests pass on one processor" all_pass taskset -c 0
finish
