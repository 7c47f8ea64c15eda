# How far solutions are from path tracing, at random places, in percent: the limit of a room, and the orders of settings
# in it. With "all" as the second argument, the limits of two others with more places and paths, their orders, and the
# limits of two models of many small polygons.
. "$(dirname "$0")/radiosity_program.sh"
needs_built radiosity_errors
paths=(500 24)
[ "${2-}" != all ] || paths=(1000 36)

# solved NAME MODEL PLACES SIDE OPTION...: solves MODEL with these options; its errors are NAME's: rms and median
declare -A rms median area
solved() {
    local name=$1 model=$2 places=$3 side=$4 errors
    shift 4
    "$radiosity" solve "$model.obj" -o "$model.rad" "$@" >out 2>err || { cat err >&2; return 1; }
    errors=$("$BUILD/radiosity_errors" "$model.obj" "$model.rad" --probes "$places" --side "$side") || return
    echo "    $model, $name: $errors"
    median[$model $name]=$(sed -E 's/.*median ([0-9.]+) %.*/\1/' <<<"$errors")
    rms[$model $name]=$(sed -E 's/.*rms ([0-9.]+) %.*/\1/' <<<"$errors")
}
# generated MODEL: also finds its area
generated() {
    "$radiosity" generate "$1" -o "$1.obj" >out
}
part() { awk "BEGIN { print ${area[$1]} / $2 }"; } # part MODEL N: an N-th of its area

room() { # room MODEL LIMIT: few places at the edges of shadows make most of its rms
    generated "$1"
    check "$1: is solved" solved default "$1" "${paths[@]}"
    check "... its light is within $2 percent" less "${rms[$1 default]}" "$2"
    "$radiosity" export "$1.rad" --csv "$1.csv"
    area[$1]=$(awk -F, 'NR > 1 { sum += $8 } END { print sum }' "$1.csv")
}
orders() { # orders MODEL
    local name
    solved "few elements" "$1" "${paths[@]}" --element "$(part "$1" 7500)"
    solved patches "$1" "${paths[@]}" --hemicube 16
    solved "few patches" "$1" "${paths[@]}" --patch "$(part "$1" 1500)"
    solved "seen lamps" "$1" "${paths[@]}" --direct hemicube --hemicube 32
    check "$1: patches are within a percent more" less "${rms[$1 patches]}" "$(awk "BEGIN { print ${rms[$1 default]} + 1 }")"
    check "... fewer elements are worse" less "${rms[$1 default]}" "${rms[$1 few elements]}"
    check "... and fewer patches" less "${rms[$1 patches]}" "${rms[$1 few patches]}"
    check "... and lamps that hemicubes see" less "${rms[$1 patches]}" "${rms[$1 seen lamps]}"
}
planes() { # planes MODEL LIMIT: of many small planes; the median includes the noise of the paths
    generated "$1"
    check "$1: is solved" solved default "$1" 600 68
    check "... its median is within $2 percent" less "${median[$1 default]}" "$2"
    solved "16 rays" "$1" 600 68 --rays 16
    check "... 16 rays are worse" less "${median[$1 default]}" "${median[$1 16 rays]}"
}

if [ "${2-}" = all ]; then
    room corner 1.5
    room columns 2.5
    orders corner
    orders columns
    planes vault 4
    check "vault: its rms is within ten percent" less "${rms[vault default]}" 10
    planes terrain 2
else
    room cube 0.7
    orders cube
fi
finish
