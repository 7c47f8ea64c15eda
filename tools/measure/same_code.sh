# Sourced by tools/measure/all: --same-code. A change of comments, names or headers makes every section stale that was
# measured of those sources, though not an instruction has changed. Here that is shown, and the sections stay.

# code_of TREE: a line for each object of the film that is built from a tree: what it holds but for debugging and for
# the link as a whole, hashed, and its name
code_of() {
    local tree=$1 object targets=(engine play output options host)
    (BUILD=$tree/build ODRAZ=$tree && build "${targets[@]}") || return 1
    find "$tree/build/intro" -name '*.o' -path '*.dir/*' | LC_ALL=C sort | while read -r object; do
        objcopy -g -R '.gnu.lto_*' -R .comment -R '.gnu.debuglto_*' "$object" "$WORK/code.o" 2>/dev/null
        printf '%s %s\n' "$(objdump -s -r "$WORK/code.o" | sed '/file format/d' | sha256sum | cut -c 1-16)" "${object#"$tree/build/"}"
    done
}

# others_of TREE: the same for what is not compiled: how it is linked and packed. (Of what makers have nothing is measured.)
others_of() {
    (cd "$1" && find intro -path intro/maker -prune -o -type f ! -name '*.cpp' ! -name '*.h' ! -name '*.md' ! -name '*.png' -print0 |
        LC_ALL=C sort -z | xargs -0 sha256sum)
}

# same_code COMMIT: renews the hashes of sections that were measured of this commit, and are stale by intro/ alone
same_code() {
    local name path then=$WORK/then line sections=()
    git -C "$ODRAZ" rev-parse --verify -q "$1^{commit}" >/dev/null || refuse "--same-code needs a commit, and '$1' is none"
    git -C "$ODRAZ" worktree add -q --detach "$then" "$1"
    trap 'git -C "$ODRAZ" worktree remove -f "$WORK/then"; rm -rf "$WORK"' EXIT
    # What was measured of that commit
    (ODRAZ=$then && hash_sources "${SECTIONS[@]}" && declare -p hash_now) | sed 's/^declare -A/declare -gA/; s/hash_now/hash_then/' >"$WORK/hash_then"
    . "$WORK/hash_then"
    hash_sources "${SECTIONS[@]}"
    for name in "${SECTIONS[@]}"; do
        line=$(verdict "$name")
        [[ $line = "stale: "* ]] || continue
        line=${line#*since then }
        for path in $line; do
            [[ $path/ = intro/* ]] && grep -qF "\`$path\` ${hash_then[$path]}" "$WORK/kept/$name" || continue 2
        done
        sections+=("$name")
    done
    [ ${#sections[@]} -gt 0 ] || { echo "nothing is stale by intro/ alone that was measured of $1"; return; }
    # The tree as it is now, with what is not committed, in a folder like the other
    mkdir "$WORK/now"
    (cd "$ODRAZ" && git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$WORK/now" 2>/dev/null) || true
    code_of "$then" >"$WORK/code.then"
    code_of "$WORK/now" >"$WORK/code.now"
    others_of "$then" >>"$WORK/code.then"
    others_of "$WORK/now" >>"$WORK/code.now"
    [ -s "$WORK/code.then" ] || refuse "no objects were built"
    if ! diff "$WORK/code.then" "$WORK/code.now" >"$WORK/code.diff"; then
        sed -n 's/^[<>] [0-9a-f]* */not the same as then: /p' "$WORK/code.diff" | sort -u >&2
        return 1
    fi
    for name in "${sections[@]}"; do
        describe "$name"
        for path in "${sources[@]}"; do
            [ "${hash_then[$path]:-}" = "${hash_now[$path]}" ] ||
                sed -i "3s#\`$path\` ${hash_then[$path]}#\`$path\` ${hash_now[$path]}#" "$WORK/kept/$name"
        done
    done
    write_results
    echo "$(wc -l <"$WORK/code.now") objects and scripts are the same to the byte; still measured: ${sections[*]}"
}
