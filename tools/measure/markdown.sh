# Sourced by tools/measure/all: writes Markdown tables. Input is CSV without quotes.

# The first line becomes the head
markdown() {
    awk -F, '{
        printf "|"
        for (i = 1; i <= NF; ++i) printf " %s |", $i
        print ""
        if (NR == 1) { printf "|"; for (i = 1; i <= NF; ++i) printf "---|"; print "" }
    }'
}

# matrix CORNER: makes a table of lines row,column,value; rows and columns keep the order in which they first come
matrix() {
    awk -F, -v corner="$1" '
        !($1 in rows) { rows[$1] = 1; row[++down] = $1 }
        !($2 in columns) { columns[$2] = 1; column[++across] = $2 }
        { value[$1, $2] = substr($0, length($1 $2) + 3) } # the value may have commas
        END {
            printf "| %s |", corner
            for (i = 1; i <= across; ++i) printf " %s |", column[i]
            printf "\n|"
            for (i = 0; i <= across; ++i) printf "---|"
            for (j = 1; j <= down; ++j) {
                printf "\n| %s |", row[j]
                for (i = 1; i <= across; ++i) printf " %s |", value[row[j], column[i]]
            }
            print ""
        }'
}

# proofs PROGRAM...: runs tests of build/tests and prints a table of what they print, by test. Fails if a test fails.
proofs() {
    local program
    printf '| test | |\n|---|---|\n'
    for program in "$@"; do
        run "$BUILD/tests/$program" >"$WORK/printed" 2>&1 || { cat "$WORK/printed" >&2; return 1; }
        awk '
            function tell() { if (said != "") printf "| %s | %s |\n", name, said; said = "" }
            /^\[ RUN/ { tell(); name = $4; next }
            /^\[/ || /^Running main/ || /^$/ { next }
            name != "" { sub(/^ */, ""); gsub(/\|/, "/"); said = said (said == "" ? "" : "<br>") $0 }
            END { tell() }' "$WORK/printed"
    done
}

# shown PLOT TEXT: shows a plot that lies beside the results
shown() { printf '\n![%s](%s)\n' "$2" "$1"; }

# Writes paragraphs around the tables
prose() { printf '\n'; cat; }
