# soak.sh finds faults: stand-ins for the film leak, print or fail.
. "$(dirname "$0")/common.sh"
skip_unless Xvfb c++
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
    FAULT=$fault bash "$(dirname "$0")/soak.sh" "$BUILD" 0.12 "$WORK/film" 0.2 >"$WORK/report.$fault" 2>&1 &
    runs+=($!)
done
PIDS+=("${runs[@]}")
for fault in nothing memory descriptors threads words signal; do
    wait "${runs[0]}"
    echo $? >>"$WORK/report.$fault"
    runs=("${runs[@]:1}")
done
# finds FAULT LINE: it fails for this one reason
finds() { [ "$(tail -n 1 "$WORK/report.$1")/$(grep ^FAILED "$WORK/report.$1")" = "1/FAILED: $2" ] || { cat "$WORK/report.$1"; return 1; }; }
check "one without a fault" eval '[ "$(tail -n 1 "$WORK/report.nothing")" = 0 ]'
check "... is looked at" grep -qE '^    [0-9]{2} looks: [0-9.]+ MB, [0-9]+ descriptors, [0-9]+ threads at most$' "$WORK/report.nothing"
check "memory that grows" finds memory "... takes at most 8 MB more after its first third"
check "descriptors that stay open" finds descriptors "... no more descriptors"
check "threads that stay" finds threads "... no more threads"
check "text on standard error" finds words "... prints nothing on standard error"
check "a signal, which ends it all" finds signal "run 1, 0 to 7 s, ends with status 0"
finish
