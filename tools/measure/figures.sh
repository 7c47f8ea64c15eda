# Sourced by tools/measure/all: the figures in README.md. Its lines between <!-- figures --> and <!-- /figures --> are
# made of cells of RESULTS.md, so README.md cannot have a figure that RESULTS.md lacks.

# cell SECTION COLUMN ROW: the cell of the section's first table that has this column and this row
cell() {
    awk -F ' *[|] *' -v column="$2" -v row="$3" '
        !/^[|]/ { inside = 0; next }
        !inside { inside = 1; at = 0; for (i = 2; i < NF; ++i) if ($i == column) at = i }
        at && $2 == row && $at != "" { print $at; found = 1; exit }
        END { exit !found }' "$WORK/kept/$1" || { echo "figures: section $1 has no '$3' below '$2'" >&2; echo '?'; }
}
# cells SECTION COLUMN: all cells below this title, a line each
cells() {
    awk -F ' *[|] *' -v column="$2" '
        !/^[|]/ { if (at) exit; inside = 0; next }
        !inside { inside = 1; for (i = 2; i < NF; ++i) if ($i == column) at = i; next }
        at && !/^[|]---/ { print $at; found = 1 }
        END { exit !found }' "$WORK/kept/$1" || { echo "figures: section $1 has no '$2'" >&2; echo '?'; }
}
thousands() { sed -E ':again s/^([0-9]+)([0-9]{3})/\1,\2/; t again'; }
# Rounds to the given number of digits
rounded() { awk -v digits="$1" '/^[-+0-9.]/ { printf "%.*f\n", digits, $1; next } { print }'; }
# Reads a number from each line and prints "least to most"
range() {
    awk '/[0-9]/ { if (!n++ || $1 < least) least = $1; if (n == 1 || $1 > most) most = $1 }
        END { print n ? least " to " most : "?" }'
}
# of_all ROW: from the section `seen`, a row's PSNR over all scenes
of_all() { cell seen all "$1" | cut -d' ' -f1; }

# (a backslash at a line's end joins it with the next)
figures() {
    local packed='`odraz`: packed' linked='`odraz-safe`: linked and stripped' peer='POV-Ray +AM2 +A0.1 +R3'
    cat <<END
- **Size:** $(cell size Linux "$packed" | thousands) bytes of 65,536, \
packed from $(cell size Linux "$linked" | thousands); for Windows $(cell size Windows "$packed" | thousands).
- **Start:** the window after $(cell start 'seconds until its window is seen' '`odraz`' | rounded 1) s, \
the first picture after $(cell start 'until the first picture' '`odraz`' | rounded 1) s, with the hall solved; \
$(cell start 'MB resident at most' '`odraz`') MB.
- **Playing** at 1280x720 by software OpenGL: \
$(cells film 'shown a second' | rounded 0 | range) pictures a second, by scene.
- **In a browser:** $(cell web bytes '`odraz.html`' | thousands) bytes; first picture \
$(cell web 's from the click to the first picture' chromium | rounded 1) s after the click; \
$(cells web 'chromium: shown a second' | rounded 0 | range) a second, of \
$(cells web 'chromium: pixels traced across' | rounded 0 | range) pixels across.
- **Seen**, against \`film\`: $(of_all '1280x720: 16') dB (sRGB) at 1280x720 on two cores, \
$(of_all '1920x1080: 128') at 1920x1080 on sixteen (simulated).
- **Tracing** ten balls: FLIP $(cell povray 'mean FLIP' 'odraz play') to the reference; \
POV-Ray has $(cell povray 'mean FLIP' "$peer") in $(cell povray 'times of play' "$peer" | rounded 0) times the time.
- **Radiosity** of $(cell radiosity triangles columns | thousands) triangles: \
$(cell radiosity 'odraz, s' columns | rounded 1) s (the thesis: $(cell radiosity 'the thesis, s' columns) s), \
$(cell radiosity 'median of 1,000 places, %' columns | rounded 1) % off path tracing in the median.
- **Transfer:** 64 lights of the hall solved in $(cell transfer 'processor s, the median of 5' all | rounded 1) s \
and relit in $(cell transfer 'all texels' noon | rounded 1) ms a picture, \
$(cells transfer 'rms of all light, %' | rounded 1 | range) % off.
- **Packing:** machine code takes $(cells packers 'to xz' | range) of its size by \`xz -9e --x86\`.
END
}

# with_figures: prints README.md with the figures between its marks
with_figures() {
    figures >"$WORK/figures"
    sed -e '/^<!-- figures -->$/,/^<!-- \/figures -->$/{/^<!-- /!d}' -e "/^<!-- figures -->\$/r $WORK/figures" \
        "$ODRAZ/README.md"
}
write_figures() {
    with_figures >"$WORK/readme"
    cmp -s "$WORK/readme" "$ODRAZ/README.md" || { cat "$WORK/readme" >"$ODRAZ/README.md"; echo "written: README.md"; }
}
check_figures() {
    if [ "$(grep -cE '^<!-- /?figures -->$' "$ODRAZ/README.md")" != 2 ]; then
        echo "README.md: the marks <!-- figures --> and <!-- /figures --> are needed"
    elif ! with_figures | cmp -s - "$ODRAZ/README.md"; then
        echo "README.md has other figures than RESULTS.md: tools/measure/all --readme"
    fi
}
