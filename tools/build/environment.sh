# Sourced first by every script, so that nothing depends on the caller's environment.

# bash -p ignores SHELLOPTS, BASHOPTS, BASH_ENV, GLOBIGNORE and exported functions, and passes none of these options on.
# Child shells would still get the functions, so they are removed first
[[ $- = *p* ]] || { unset -f $(compgen -A function); exec bash -p "$0" "$@"; }
set -euo pipefail
# Git's own list has the variables that name another repository, as in a hook; it also has settings, which may be needed
unset CDPATH BASH_ENV GLOBIGNORE GIT_{LITERAL,GLOB,NOGLOB,ICASE}_PATHSPECS \
    $(git rev-parse --local-env-vars 2>/dev/null | grep -v CONFIG_)

# commit: prints the commit of these sources. Fails, and prints why, if they are not the top of a work tree or git refuses
commit() {
    local prefix parse=(git -C "$ODRAZ" rev-parse)
    prefix=$("${parse[@]}" --show-prefix 2>/dev/null) || { "${parse[@]}" --show-prefix 2>&1 | tr -s '[:space:]' ' '; return 1; }
    [ -z "$prefix" ] || { echo "$ODRAZ is a folder of another git repository"; return 1; }
    "${parse[@]}" --short=12 HEAD 2>/dev/null || { echo "$ODRAZ has no commit yet"; return 1; }
}
