# Sourced by tools/measure/all: records the sources that each section was measured from, as git's hashes.
#
# A source is a folder or a file of the repository. Its hash is git's hash of its tree or blob in the working tree,
# committed or not (`git rev-parse HEAD:intro/trace` prints the same). So it is the same in every clone, and a rebase
# does not change it. READMEs are left out, because figures are written into them, and so are odraz-debug and pack-link,
# of which nothing is measured.

# sources_of SECTION: its sources, a line each; they always include the section's own file
sources_of() {
    describe "$1"
    printf '%s\n' "${sources[@]}" "tools/measure/results/$1"
}

# hash_sources SECTION...: fills `hash_now`, from source to hash; a source that git does not know stays empty
declare -A hash_now
hash_sources() {
    local tree path name objects=$WORK/objects
    git -C "$ODRAZ" rev-parse --git-dir >/dev/null 2>&1 || refuse "staleness is told by git, and $ODRAZ is no checkout"
    rm -rf "$objects" "$WORK/index"
    mkdir "$objects"
    for name; do sources_of "$name"; done | sort -u >"$WORK/sources"
    (
        cd "$ODRAZ"
        # Use a temporary index and object store
        index=$(git rev-parse --git-path index) store=$(git rev-parse --git-path objects)
        cp "$index" "$WORK/index"
        export GIT_INDEX_FILE=$WORK/index GIT_OBJECT_DIRECTORY=$objects
        export GIT_ALTERNATE_OBJECT_DIRECTORIES=$(cd "$store" && pwd)
        git add --all
        git ls-files -z '*.md' intro/maker intro/main_debug.cpp packer/link | git update-index -z --force-remove --stdin
        tree=$(git write-tree)
        sed "s/^/$tree:/" "$WORK/sources" | git cat-file --batch-check='%(objectname)'
    ) >"$WORK/hashes"
    while read -r path <&3 && read -r name <&4; do
        hash_now[$path]=
        [ "${name% missing}" != "$name" ] || hash_now[$path]=${name:0:12}
    done 3<"$WORK/sources" 4<"$WORK/hashes"
}

# told_sources SECTION: prints the sources as the section's head has them
told_sources() {
    local path
    sources_of "$1" | while read -r path; do printf '`%s` %s\n' "$path" "${hash_now[$path]}"; done | paste -sd , | sed 's/,/, /g'
}

# verdict SECTION: prints nothing if the sources are unchanged; else one line, unmeasured, unknown or stale, and why
verdict() {
    local path told= changed=() head=()
    [ ! -s "$WORK/kept/$1" ] || mapfile -t -n 3 head <"$WORK/kept/$1"
    describe "$1"
    if [ ${#head[@]} -lt 3 ] || [[ ${head[2]} = "Not measured yet"* ]]; then
        echo "unmeasured: $1: tools/measure/all --only $1, $minutes minutes"
        return
    fi
    sources+=("tools/measure/results/$1")
    for path in "${sources[@]}"; do
        [ -n "${hash_now[$path]}" ] || { echo "unknown: $1 measures $path, which git does not have"; return; }
    done
    [[ ! ${head[2]} =~ \.\ Sources:\ (.*)\.\ (By|It)\  ]] || told=${BASH_REMATCH[1]//\`/}
    [[ "$told, " =~ ^([^ ,]+\ [0-9a-f]{12},\ )+$ ]] || { echo "unknown: $1 names no hash of its sources"; return; }
    for path in "${sources[@]}"; do
        [[ "$told, " = *"$path ${hash_now[$path]}, "* ]] || changed+=("$path")
    done
    [ ${#changed[@]} -eq 0 ] || echo "stale: $1: since then ${changed[*]}"
}
