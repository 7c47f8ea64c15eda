# Sourced by tools/measure/all: copies figures from the sections into READMEs.
#
# A README marks each figure: <!--SECTION.NAME-->64,760<!--/-->. The function `figures` of the section's file finds its
# value in the section's text in RESULTS.md, so a README cannot have a figure that RESULTS.md lacks.

# Within `figures`: figure NAME VALUE; an empty VALUE is left out
figure() { [ -z "$2" ] || printf '%s.%s\t%s\n' "$SECTION" "$1" "$2"; }
# cell ROW COLUMN: a cell of the first table of the section that has both
cell() {
    awk -F ' *[|] *' -v row="$1" -v column="$2" '
        /^[|]/ {
            if (!inside) { at = 0; for (i = 2; i < NF; ++i) if ($i == column) at = i }
            inside = 1
            if (at && $2 == row && $at != "") { print $at; exit }
            next
        }
        { inside = 0 }' "$WORK/kept/$SECTION"
}
# column COLUMN: all cells of the column, a line each, of the first table that has it
column() {
    awk -F ' *[|] *' -v column="$1" '
        /^[|]/ {
            if (!row++) { at = 0; for (i = 2; i < NF; ++i) if ($i == column) at = i }
            else if (at && row > 2) print $at
            next
        }
        { if (at && row) exit; row = 0 }' "$WORK/kept/$SECTION"
}
# said PATTERN: what the group of a pattern (sed's, extended) matches first in the section
said() { sed -nE "/$1/ { s/.*$1.*/\1/p; q }" "$WORK/kept/$SECTION"; }
# Rounds to so many digits behind the point, or puts commas between thousands. Empty stays empty.
rounded() { awk -v digits="$1" 'NF { printf "%.*f\n", digits, $1 }'; }
thousands() { sed -E ':again s/^([0-9]+)([0-9]{3})/\1,\2/; t again'; }
# Reads a number from each line and prints "least to most"
range() { awk 'NF { if (!n++ || $1 < least) least = $1; if (n == 1 || $1 > most) most = $1 } END { if (n) print least " to " most }'; }

# all_figures: prints "SECTION.NAME<tab>VALUE" for all sections in the results
all_figures() {
    for SECTION in "${SECTIONS[@]}"; do
        describe "$SECTION"
        [ -z "$(type -t figures)" ] || figures
    done
}
readmes() { git -C "$ODRAZ" ls-files '*.md' | grep -v '^tools/measure/RESULTS.md$'; }

# write_readmes: writes every figure as its section has it; a figure that no section has stays
write_readmes() {
    local file
    all_figures | awk -F '\t' '{ gsub(/[\\&|]/, "\\\\&", $2); printf "s|<!--%s-->[^<]*<!--/-->|<!--%s-->%s<!--/-->|g\n", $1, $1, $2 }' >"$WORK/figures.sed"
    readmes | while read -r file; do
        sed -f "$WORK/figures.sed" "$ODRAZ/$file" >"$WORK/readme"
        cmp -s "$WORK/readme" "$ODRAZ/$file" && continue
        # (cat keeps the file's mode)
        cat "$WORK/readme" >"$ODRAZ/$file"
        echo "written: $file"
    done
}

# check_readmes: prints a line for each figure that no section has, or has otherwise; in a chapter "Figures" also for
# numbers with a unit that have no mark
check_readmes() {
    all_figures >"$WORK/figures"
    readmes | while read -r file; do
        awk -F '\t' -v file="$file" '
            NR == FNR { value[$1] = $2; next }
            {
                rest = $0; bare = ""
                while (match(rest, /<!--[a-z-]+\.[a-z0-9-]+-->[^<]*<!--\/-->/)) {
                    bare = bare substr(rest, 1, RSTART - 1) "#"
                    mark = substr(rest, RSTART, RLENGTH); rest = substr(rest, RSTART + RLENGTH)
                    name = mark; sub(/^<!--/, "", name); sub(/-->.*/, "", name)
                    sub(/^<!--[^>]*>/, "", mark); sub(/<.*/, "", mark)
                    if (!(name in value)) print file ": " name " stands in no section"
                    else if (value[name] != mark) print file ": " name " is " value[name] " by its section, not " mark ": tools/measure/all --readme"
                }
                bare = bare rest
                if (bare ~ /<!--\/-->|<!--[a-z-]+\.[a-z0-9-]+-->/) print file ":" FNR ": a figure needs both marks on one line"
                if (/^#/) figures = /^## Figures/
                if (figures && match(bare, /[0-9.]+ (%|s|ms|MB|KB|dB|LUFS|pictures|bytes)( |[.,;:)]|$)/))
                    print file ":" FNR ": " substr(bare, RSTART, RLENGTH - 1) " has no mark, so it stands in no section"
            }' "$WORK/figures" "$ODRAZ/$file"
    done
}
