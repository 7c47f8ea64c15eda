# For tests/support/soak. Reads the lines "played,...", "sample,..." and "run,...", and writes a table of the runs
# and a verdict. Exits with 1 if a run failed or something grew. Variables to set: room (MB), length_ (s), table,
# verdict (files).
#
# Samples of a run count only after its start-up, which lasts 1.5 times the time of its first picture plus one second,
# from when the program's first part runs. After that, memory must not exceed the maximum of the first third by more
# than `room`. Descriptors and threads must not stay above their maximum of the first third during all of the last
# third. The first run is the whole film: no later run's maximum of memory may exceed that of the first by more than
# `room`.

$1 == "played" { first[$2] = $3; shown[$2] = $4; missed[$2] = $5; next }
$1 == "sample" {
    run = $2
    if (first[run] == "none" || $3 / 1000 < 1.5 * first[run] + 1) next
    n = ++samples[run]
    mb[run, n] = $4 / 1024; descriptors[run, n] = $5; threads[run, n] = $6
    if ($7 > sounds[run]) sounds[run] = $7
    next
}
$1 == "run" { runs = $2; from[$2] = $3; to[$2] = $4; status[$2] = $5; printed[$2] = $6; display[$2] = $7 }

# the maximum of a run's values, from sample a to b
function most(values, run, a, b,   i, m) { m = values[run, a]; for (i = a; i <= b; ++i) if (values[run, i] > m) m = values[run, i]; return m }
function least(values, run, a, b,   i, m) { m = values[run, a]; for (i = a; i <= b; ++i) if (values[run, i] < m) m = values[run, i]; return m }
function complain(text) { bad = bad "\n- " text }
function range(values, run, n) { return sprintf("%.0f, %.0f, %.0f", values[run, 1], values[run, n], most(values, run, 1, n)) }
# commas separate a table's cells, so a cell must not have any
function cell(text) { gsub(/, /, " / ", text); return text }

function judge(run,   n, third, growth) {
    n = samples[run]
    third = int((n + 2) / 3)
    if (status[run] != 0) complain("run " run " ended with status " status[run] (status[run] == 137 ? " (killed: it did not end)" : ""))
    if (printed[run] > 0) complain("run " run " printed something on standard error")
    if (n < 3) { complain("run " run " was looked at only " n + 0 " times after its first picture"); return "-" }
    growth = most(mb, run, 1, n) - most(mb, run, 1, third)
    if (growth > room) complain(sprintf("run %d took %.1f MB more after its first third", run, growth))
    if (least(descriptors, run, n - third + 1, n) > most(descriptors, run, 1, third)) complain("run " run " took more descriptors")
    if (least(threads, run, n - third + 1, n) > most(threads, run, 1, third)) complain("run " run " took more threads")
    if (growth > greatest_growth) greatest_growth = growth
    if (most(mb, run, 1, n) > peak) { peak = most(mb, run, 1, n); peak_of = run }
    if (most(descriptors, run, 1, n) > all_descriptors) all_descriptors = most(descriptors, run, 1, n)
    if (most(threads, run, 1, n) > all_threads) all_threads = most(threads, run, 1, n)
    return sprintf("%.1f", growth)
}

END {
    print "run,of the film (s),first picture (s),looked at,MB resident: first / last / greatest,growth after its first third,descriptors,threads,sounds,pictures shown,sixtieths missed,the display's MB,exit status" >table
    for (run = 1; run <= runs; ++run) {
        n = samples[run]
        growth = judge(run)
        seconds += to[run] - from[run]; all_samples += n; all_shown += shown[run]; all_missed += missed[run]
        printf "%d,%d to %d,%s,%d,%s,%s,%s,%s,%s,%d,%d,%s,%s\n", run, from[run], to[run], first[run], n, n ? cell(range(mb, run, n)) : "-", growth,
            n ? cell(range(descriptors, run, n)) : "-", n ? cell(range(threads, run, n)) : "-", sounds[run] ? "yes" : "no", shown[run], missed[run], display[run], status[run] >table
    }
    if (!runs) complain("nothing was played")
    printf "all,%d in all,,%d,%.0f at most,%.1f at most,%d at most,%d at most,,%d,%d,,\n", seconds, all_samples, peak, greatest_growth, all_descriptors, all_threads, all_shown, all_missed >table

    whole = runs && from[1] == 0 && to[1] == length_ && samples[1]
    if (whole && runs > 1) {
        over = peak - most(mb, 1, 1, samples[1])
        if (over > room) complain(sprintf("run %d took %.1f MB more than the first, which was the whole film", peak_of, over))
        if (all_descriptors > most(descriptors, 1, 1, samples[1]) + 4) complain("a later run took more descriptors than the first")
        if (all_threads > most(threads, 1, 1, samples[1]) + 4) complain("a later run took more threads than the first")
    }
    if (bad != "") { print "Something is wrong:\n" bad >verdict; exit 1 }
    printf "Every run ended with status 0 and printed nothing on standard error; none took more memory (%d MB of room), descriptors or threads after its first third", room >verdict
    if (whole && runs > 1) printf ", and the most that a run took, %.0f MB, is %.1f MB above the first's", peak, over >verdict
    print "." >verdict
}
