# Sourced: reads CSV by the titles of its columns, and writes Markdown tables. CSV here has no quotes.

# column TITLE FILE: prints the column's number; fails if the file has no such title
column() {
    head -n 1 "$2" | tr , '\n' | grep -nxF -- "$1" | cut -d: -f1 | grep . ||
        { echo "$2 has no column '$1'" >&2; return 1; }
}
# csv PROGRAM FILE...: awk over the rows of the files. In the program, $title is the cell below that title, which the
# first or another file must have: in a file without it the cell is empty. Titles are letters, digits and _, and
# begin with a small letter.
csv() {
    local program=$1 title find= heads
    shift
    heads=$(for file; do head -n 1 "$file"; done | tr , '\n')
    for title in $(grep -oE '\$[a-z_][A-Za-z0-9_]*' <<<"$program" | tr -d '$' | sort -u); do
        grep -qxF -- "$title" <<<"$heads" || column "$title" "$1" || return 1
        find+="$title = (\"$title\" in at_) ? at_[\"$title\"] : 999; "
    done
    awk -F, "FNR == 1 { delete at_; for (i_ = 1; i_ <= NF; ++i_) at_[\$i_] = i_; $find next } $program" "$@"
}

# columns FILE TITLE[=HEADING]...: writes these columns of a CSV, under other headings if there are any
columns() {
    local file=$1 one number cells= heads=
    shift
    for one; do
        number=$(column "${one%%=*}" "$file") || return 1
        cells+=" \",\" \$$number" heads+=",${one#*=}"
    done
    { echo "${heads#,}"; awk -F, "NR > 1 { print substr($cells, 2) }" "$file"; } | markdown
}
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
# plot FILE TEXT: shows a plot that lies beside the results
plot() { printf '\n![%s](%s)\n' "$2" "$1"; }
# Writes paragraphs around the tables
prose() { printf '\n'; cat; }

# played FILE: what the film prints with --stats, as CSV; `rate` is the pictures shown in a second
played() {
    echo scene,traced,between,shown,missed,trace_ms,trace_95,between_ms,between_95,show_ms,show_95,samples,width,rate
    awk 'NF == 13 && $2 ~ /^[0-9]+$/ { $14 = sprintf("%.1f", 60 * $4 / ($4 + $5)); print }' OFS=, "$1"
}
