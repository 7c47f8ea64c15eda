# Sourced by tools/render: runs the shards by xargs on this machine, by GNU parallel on hosts, by sbatch on a cluster.

# list_shards: writes a line A B NAME for each shard, which has the frames from A to before B
list_shards() {
    local a b
    for ((a = first; a < end; a += shard)); do
        b=$((a + shard < end ? a + shard : end))
        printf '%d %d %06d-%06d\n' $a $b $a $b
    done >"$parts/shards"
}

# check_shard A B NAME: prints "good", "missing", or the fault of the shard
check_shard() {
    local sums=$parts/$3.sums in=$parts want=$(($2 - $1))
    [ -e "$sums" ] || { echo missing; return; }
    [ $kind != frames ] || in=$parts/frames
    if ! (cd "$in" && { [ $kind = frames ] && cat "$sums" || tail -n 1 "$sums"; } | sha256sum --check --status --strict) 2>/dev/null; then
        echo "its file is missing or damaged"
    elif [ "$(grep -cE '^[0-9a-f]{64}  frame-[0-9]{6,}\.ppm$' "$sums")" != $want ]; then
        echo "its list of checksums is damaged"
    else
        echo good
    fi
}

# start COMMAND...: runs the command in the background, in its own process group; sets engine
start() {
    set -m
    "$@" &
    engine=$!
    set +m
}
# signal NAME: signals the engine and the shards, which GNU parallel puts into their own process groups. Fails if none
# runs
signal() {
    local group some=
    for group in "$engine" $(cat "$parts"/*.group 2>/dev/null); do
        kill "-$1" -- "-$group" 2>/dev/null && some=1
    done
    [ -n "$some" ]
}
stop_engine() {
    local tries=0
    [ ! -e "$parts/job" ] || scancel "$(cut -d ';' -f 1 "$parts/job")" 2>/dev/null || true
    while signal TERM && [ $((++tries)) -le 10 ]; do sleep 0.2; done
    signal KILL || true
    wait "$engine" 2>/dev/null || true
    engine=
    rm -f "$parts"/*.group
}

by_xargs() { exec xargs -P "$jobs" -L 1 -a "$parts/todo" bash "$parts/shard" "$parts"; }
by_parallel() {
    local quoted
    printf -v quoted %q "$parts"
    # Do not depend on the caller's shell and settings: without $SHELL parallel does nothing, with status 0
    export PARALLEL_SHELL=$BASH PARALLEL_HOME=$parts/parallel
    mkdir -p "$PARALLEL_HOME"
    exec parallel --will-cite --jobs 100% --sshloginfile "$parts/hosts" --ssh "$parts/here" --retries 2 --halt soon,fail=1 \
        --colsep ' ' -a "$parts/todo" bash "$quoted/shard" "$quoted" '{1} {2} {3} {4} {5}'
}
by_sbatch() {
    # Without buffering, since scancel needs the job's number while sbatch waits
    exec stdbuf -oL sbatch --wait --parsable "${sbatch[@]}" --job-name=render --array="1-$left${jobs:+%$jobs}" --chdir=/ \
        --output="$parts/slurm-%a.log" "$parts/task" >"$parts/job"
}

# meet_hosts: copies the film to every host. A line of hosts.film is a host and the film's folder there
meet_hosts() {
    local line host at
    : >"$parts/hosts.part"
    : >"$parts/hosts.film"
    while read -r line || [ -n "$line" ]; do
        line=${line%%#*} line=${line//[[:space:]]/ }
        read -r line <<<"$line"
        [ -n "$line" ] || continue
        [[ $line =~ ^([1-9][0-9]*/)?([^\ /]+)$ ]] || fail "$hosts: cannot use '$line': write [N/][USER@]HOST, and how to reach it into ~/.ssh/config or --ssh"
        host=${BASH_REMATCH[2]}
        echo "${BASH_REMATCH[1]:-1/}$host" >>"$parts/hosts.part"
        [ "$host" != : ] && ! awk -v host="$host" '$1 == host { found = 1 } END { exit !found }' "$parts/hosts.film" || continue
        at=$($ssh "$host" 'exec sh -c "umask 77; at=\$(mktemp -d \${TMPDIR:-/tmp}/render-XXXXXX) && cat >\$at/film && chmod 700 \$at/film && \$at/film --version >/dev/null && echo \$at"' \
            <"$parts/film" 2>"$parts/host.err" 9>&-) && [ -n "$at" ] ||
            fail "cannot copy the film to $host: $(grep -m 1 . "$parts/host.err" || echo "no message")"
        echo "$host $at" >>"$parts/hosts.film"
    done <"$hosts"
    rm -f "$parts/host.err"
    [ -s "$parts/hosts.part" ] || fail "$hosts has no host"
    mv "$parts/hosts.part" "$parts/hosts"
}
leave_hosts() {
    local host at
    [ -e "$parts/hosts.film" ] || return 0
    while read -r host at; do
        $ssh "$host" "rm -rf $at" </dev/null >/dev/null 2>&1 9>&- || true
    done <"$parts/hosts.film"
    rm -f "$parts/hosts.film"
}

render_shards() {
    local status=0 lacking
    export RENDER_THREADS=$threads RENDER_SSH=$ssh
    if [ -n "$hosts" ]; then
        cp "$ODRAZ/tools/render_parts/here" "$parts/here"
        meet_hosts
        start by_parallel 2>"$parts/engine.err"
    elif [ -n "$slurm" ]; then
        # The number of a task is its line in todo
        printf '#!/bin/bash\nexport RENDER_THREADS=%q\nread -ra words <<<"$(sed -n "${SLURM_ARRAY_TASK_ID}p" %q)"\nexec bash %q %q "${words[@]}"\n' \
            "$threads" "$parts/todo" "$parts/shard" "$parts" >"$parts/task"
        start by_sbatch 2>"$parts/engine.err"
    else
        jobs=${jobs:-1}
        [ -n "$threads" ] || [ "$jobs" = 1 ] || RENDER_THREADS=$((($(nproc) + jobs - 1) / jobs))
        start by_xargs 2>"$parts/engine.err"
    fi
    follow rendering "$frames" frames_done || status=$?
    rm -f "$parts/job"
    leave_hosts
    lacking=$(while read -r _ _ name; do [ -e "$parts/$name.sums" ] || echo "$name"; done <"$parts/shards" | wc -l)
    [ "$lacking" = 0 ] && return 0
    [ $failures -gt 0 ] || echo "tools/render: ended with status $status: $(grep -m 1 . "$parts/engine.err" || echo "no message")" >&2
    fail "$lacking of $total shards are not done;$again continues with them"
}
