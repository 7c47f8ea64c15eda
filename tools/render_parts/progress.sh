# Sourced by tools/render: prints its progress, on a terminal as a bar.

# frames_done: counts the frames of all shards, including unfinished ones
frames_done() {
    find "$parts" -maxdepth 1 \( -name '*.sums' -o -name '*.sums.part' -o -name '*.hashes.part' \) -exec cat {} + 2>/dev/null |
        awk '/frame-|^0,/ { ++n } END { print n + 0 }'
}

clock() { # clock SECONDS: prints [HOURS:]MINUTES:SECONDS
    if [ "$1" -ge 3600 ]; then printf '%d:%02d:%02d' $(($1 / 3600)) $(($1 / 60 % 60)) $(($1 % 60)); else printf '%d:%02d' $(($1 / 60)) $(($1 % 60)); fi
}

# show WHAT DONE OF BEGAN DONE-THEN: prints the progress; estimates the time left from the rate since BEGAN
show() {
    local what=$1 done=$2 of=$3 took=$((SECONDS - $4)) new=$(($2 - $5)) left= full width=30
    if [ $new -gt 0 ] && [ $took -gt 0 ]; then left=", $(clock $((took * (of - done) / new))) left"; fi
    full=$((done * width / of))
    [ ! -t 2 ] || what+=" [$(printf "%${full}s" | tr ' ' '#')$(printf "%$((width - full))s")]"
    progress "$what: $done of $of frames$left"
}

# follow WHAT OF COUNT-COMMAND: prints progress until the process $engine ends; returns its status
follow() {
    local what=$1 of=$2 status=0 then since=$SECONDS shown=-1
    shift 2
    then=$("$@")
    while kill -0 "$engine" 2>/dev/null; do
        if [ $SECONDS != $shown ]; then
            shown=$SECONDS
            show "$what" "$("$@")" "$of" "$since" "$then"
            report_failures
        fi
        sleep 0.1
    done
    wait "$engine" || status=$?
    engine=
    progress_ends
    report_failures
    return $status
}

# report_failures: prints a line for every shard that has failed since the last call
failures=0
report_failures() {
    local failed name host reason
    for failed in "$parts"/failed-*; do
        [ -e "$failed" ] || continue
        name=${failed##*/failed-} reason=
        { read -r host && read -r reason; } <"$failed" || true
        rm "$failed"
        failures=$((failures + 1))
        progress_ends
        echo "tools/render: frames $((10#${name%%-*})) to $((10#$(cut -d - -f 2 <<<"$name") - 1)) failed${host:+ on $host}: ${reason:-no message}" >&2
    done
}
