# Sourced by tools/measure/all: the sections of RESULTS.md, and the sources that they were measured from.
#
# Above each section is its mark, with git's hashes of its sources: <!-- size: intro 286356691e85, ... -->. A source
# is a folder or a file of the repository, as it is in the working tree (`git rev-parse HEAD:intro` prints the same
# hash). So it is the same in every clone, and a rebase does not change it. READMEs and odraz-debug are left out.

# describe SECTION: loads what its file defines
describe() {
    title= minutes= sources=() targets=() packages=()
    . "$ODRAZ/tools/measure/results/$1"
    sources+=("tools/measure/results/$1")
}

# read_results FILE: puts each section's text into $WORK/kept, and its record of sources into $WORK/records
read_results() {
    local name
    mkdir "$WORK/kept" "$WORK/records"
    for name in "${SECTIONS[@]}"; do : >"$WORK/kept/$name" >"$WORK/records/$name"; done
    [ ! -r "$1" ] || awk -v work="$WORK" '
        function keep() {
            sub(/\n+$/, "\n", text)
            if (name != "") printf "%s", text >(work "/kept/" name)
            text = ""
        }
        /^<!-- [a-z-]+(: .*)? -->$/ {
            keep()
            name = $2; sub(/:$/, "", name)
            record = $0
            if (sub(/^<!-- [a-z-]+: /, "", record) && sub(/ -->$/, "", record)) print record >(work "/records/" name)
            next
        }
        { text = text $0 "\n" }
        END { keep() }' "$1"
}

# write_results: writes all sections to $to
write_results() {
    local name
    {
        head_of_results
        for name in "${SECTIONS[@]}"; do
            if [ -s "$WORK/kept/$name" ] && [ -s "$WORK/records/$name" ]; then
                printf '\n<!-- %s: %s -->\n' "$name" "$(cat "$WORK/records/$name")"
                cat "$WORK/kept/$name"
            else
                describe "$name"
                printf '\n<!-- %s -->\n## %s\n\n' "$name" "$title"
                printf 'Not measured yet: `tools/measure/all --only %s`, %s minutes.\n' "$name" "$minutes"
            fi
        done
    } >"$PLOTS/.results.$$"
    mv "$PLOTS/.results.$$" "$to"
}

processor() { echo "$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores"; }
head_of_results() {
    cat <<END
# Measured

\`tools/measure/all\` writes this page: \`--only NAME\` measures one section, \`--stale\` those whose sources have
changed since, \`--check\` prints which these are. Below each title are its day and machine, how many processors other
programs kept busy meanwhile (above 0.5, times are too long), and the commands. Times are those of processors, unless
a column is headed otherwise: of all threads, user and system. Callgrind counts instructions, which other programs do
not disturb. Where cores are shared, ratios within one run are more reliable than times.

| the last run | |
|---|---|
| day | $(date -u +%Y-%m-%d) |
| processor | $(processor) |
| memory | $(awk '/^MemTotal/ { printf "%.0f GB", $2 / 1048576 }' /proc/meminfo) |
| system | $(. /etc/os-release && echo "$PRETTY_NAME"), Linux $(uname -r) |
| compiler | $(c++ --version | head -n 1) |
| Mesa | $(dpkg-query -W -f '${Version}' libgl1-mesa-dri 2>/dev/null || echo "not Debian's") |
END
}

# --- What is stale ---

# hash_sources SECTION...: fills `hash_now`, from source to hash; a source that git does not know stays empty
declare -A hash_now
hash_sources() {
    local path name
    git -C "$ODRAZ" rev-parse --git-dir >/dev/null 2>&1 || refuse "$ODRAZ is no checkout: git finds what is stale"
    rm -rf "$WORK/objects"
    mkdir "$WORK/objects"
    for name; do (describe "$name" && printf '%s\n' "${sources[@]}"); done | sort -u >"$WORK/sources"
    (
        cd "$ODRAZ"
        # A temporary index and object store
        index=$(git rev-parse --git-path index) store=$(git rev-parse --git-path objects)
        cp -p "$index" "$WORK/index" # with its time: git compares the content of files that are as young
        export GIT_INDEX_FILE=$WORK/index GIT_OBJECT_DIRECTORY=$WORK/objects
        export GIT_ALTERNATE_OBJECT_DIRECTORIES=$(cd "$store" && pwd)
        git add --all
        git ls-files -z '*.md' intro/maker intro/main_debug.cpp | git update-index -z --force-remove --stdin
        tree=$(git write-tree)
        sed "s/^/$tree:/" "$WORK/sources" | git cat-file --batch-check='%(objectname)'
    ) >"$WORK/hashes"
    while read -r path <&3 && read -r name <&4; do
        hash_now[$path]=
        [ "${name% missing}" != "$name" ] || hash_now[$path]=${name:0:12}
    done 3<"$WORK/sources" 4<"$WORK/hashes"
}
# verdict SECTION: prints nothing if its sources are unchanged; else one line with the reason
verdict() {
    local path record changed=()
    describe "$1"
    record=$(cat "$WORK/records/$1")
    [ -n "$record" ] || { echo "unmeasured: $1: tools/measure/all --only $1, $minutes minutes"; return; }
    for path in "${sources[@]}"; do
        [ -n "${hash_now[$path]}" ] || { echo "unknown: $1 measures $path, which git does not have"; return; }
        [[ ", $record, " = *", $path ${hash_now[$path]}, "* ]] || changed+=("$path")
    done
    [ ${#changed[@]} -eq 0 ] || echo "stale: $1: since then ${changed[*]}"
}

# --- Measuring ---

# made_by COMMAND...: puts a command into the section's head, with paths as a reader would write them
made_by() {
    local words=$1 word
    for word in "${@:2}"; do
        [[ $word != *" "* ]] || word="\"$word\""
        words+=" $word"
    done
    words=${words//"$WORK/"/} words=${words//"$PLOTS/"/} words=${words//"$BUILD/"/build/}
    echo "${words//"$ODRAZ/"/}" >>"$WORK/commands"
}
# ... and runs it
run() {
    made_by "$@"
    "$@"
}
# In hundredths of a second: how long the processors worked, how long a process and its children worked, the clock
busy() { awk '/^cpu / { print $2 + $3 + $4 + $7 + $8 + $9 }' /proc/stat; }
own() { awk '{ sub(/.*\) /, ""); print $12 + $13 + $14 + $15 }' "/proc/$1/stat"; }
clock() { echo $((${EPOCHREALTIME/[.,]/} / 10000)); }

# measure_section NAME: writes its text to $WORK/section and the record of its sources to $WORK/record
measure_section() {
    local self=$BASHPID all_before own_before began took others path
    hash_sources "$1"
    describe "$1"
    if [ -z "$built" ]; then
        need_for_building
        [ ${#packages[@]} -eq 0 ] || need "measuring $1" "${packages[@]}"
        build "${targets[@]}"
    fi
    for path in "${sources[@]}"; do echo "$path ${hash_now[$path]}"; done | paste -sd , | sed 's/,/, /g' >"$WORK/record"
    : >"$WORK/commands"
    began=$(clock) all_before=$(busy) own_before=$(own $self)
    measure >"$WORK/body"
    took=$(($(clock) - began))
    others=$(($(busy) - all_before - $(own $self) + own_before))
    {
        printf '## %s\n\n%s, %s, others %s, took %d.%d s. By ' "$title" "$(date -u +%Y-%m-%d)" "$(processor)" \
            "$(awk "BEGIN { printf \"%.2f\", $others < 0 ? 0 : $others / ($took + 1) }")" \
            $((took / 100)) $((took / 10 % 10))
        awk '!seen[$0]++ { printf "%s`%s`", (NR > 1 ? "; " : ""), $0 } END { printf ":\n\n" }' "$WORK/commands"
        sed '/./,$!d' "$WORK/body"
    } >"$WORK/section"
}
