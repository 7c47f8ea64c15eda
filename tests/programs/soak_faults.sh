# tests/support/soak finds faults: stand-ins for the film leak, print or fail.
. "$(dirname "$0")/common.sh"
skip_unless Xvfb c++
soak=$SOURCE/tests/support/soak
unset DISPLAY
cat >"$WORK/film.cpp" <<'END'
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <unistd.h>
int main() {
    std::string fault = getenv("FAULT");
    std::puts("first picture after 0.10 s");
    std::fflush(stdout);
    for (int i = 0; i < 26; ++i) {
        if (fault == "memory") memset(malloc(2 << 20), 1, 2 << 20);
        if (fault == "descriptors") dup(0);
        if (fault == "threads") std::thread([] { sleep(9); }).detach();
        usleep(200000);
    }
    if (fault == "words") std::fputs("a word\n", stderr);
    if (fault == "signal") abort();
    std::fflush(nullptr), _exit(0); // whatever the threads do
}
END
c++ -O0 -pthread "$WORK/film.cpp" -o "$WORK/film" 2>"$WORK/err" || { cat "$WORK/err"; exit 1; }
# One run of five seconds each. All faults run at once, because they mostly wait
runs=()
for fault in nothing memory descriptors threads words signal; do
    { FAULT=$fault "$soak" 0.12 --every 0.2 --film "$WORK/film" >"$WORK/report.$fault" 2>"$WORK/err.$fault"; echo $? >"$WORK/status.$fault"; } &
    runs+=($!)
done
wait "${runs[@]}"
soaks() { cp "$WORK/report.$1" "$WORK/report" && [ "$(cat "$WORK/status.$1")" = 0 ]; }
finds() { ! soaks "$1" && grep -qxF -- "- $2" <(sed 's/took [0-9.]* MB/took some MB/' "$WORK/report"); }
check "one without a fault" soaks nothing
check "... its run is in the table" \
    grep -qE '^\| 1 \| 0 to [67] \| 0.10 \| [0-9]+ \| [0-9]+ / [0-9]+ / [0-9]+ \| [0-9.]+ \|' "$WORK/report"
check "... and that it is well" \
    grep -q '^Every run ended with status 0 and printed nothing on standard error' "$WORK/report"
check "memory that grows" finds memory "run 1 took some MB more after its first third"
check "descriptors that stay open" finds descriptors "run 1 took more descriptors"
check "threads that stay" finds threads "run 1 took more threads"
check "text on standard error" finds words "run 1 printed something on standard error"
check "... is repeated" grep -qx 'Run 1 printed: a word' "$WORK/report"
check "a signal" finds signal "run 1 ended with status 134"
check "... ends it all" test "$(grep -c '^| [0-9]' "$WORK/report")" = 1

check "no minutes" refuses 2 "how many MINUTES" "$soak"
check "minutes that are none" refuses 2 "MINUTES needs a number" "$soak" soon
check "no film" refuses 2 "is not there: build it first" "$soak" 1 --film "$WORK/none"
check "an unknown option" refuses 2 "cannot use '--fast'" "$soak" --fast
check "--help" prints '^usage: tests/support/soak MINUTES' "$soak" --help
finish
