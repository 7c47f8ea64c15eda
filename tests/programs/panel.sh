# Uses the panel of odraz-debug in a window, by keys and mouse, and checks the title and screenshots. panel_test and
# panel_parts_test test the parts.
. "$(dirname "$0")/display.sh"
needs_built odraz-debug
start_display 660x400
WIDTH=640 HEIGHT=360

WINDOW="^$FILM-debug"
# shown_at: prints the film's time in seconds, from the title "odraz-debug  table  0:25.00  row ..."
shown_at() { title | sed -nE 's/.*  ([0-9]+):([0-9.]+)  row .*/\1 \2/p' | awk '{ print $1 * 60 + $2 }'; }
at() { [ "$(shown_at)" = "$1" ]; } # at SECONDS, written as in the title
near() { awk "BEGIN { off = $1 - $(shown_at); exit !(off < $2 && off > -$2) }"; } # near SECONDS TOLERANCE
pointer() { xdotool mousemove --window "$window" "$1" "$2"; }
look() { drawn && import -window "$window" "$WORK/$1.png"; } # look NAME: saves a screenshot of the window
# differ A B GEOMETRY: prints the share of pixels in that rectangle that differ by more than 2 %
differ() {
    convert "$WORK/$1.png" "$WORK/$2.png" -crop "$3" +repage -compose difference -composite -colorspace gray -threshold 2% \
        -format '%[fx:mean]' info:
}
STRIP=640x25+0+335 REST=400x200+190+110
ROWS=$(sed -n 's/.* kEndRow = \([0-9]*\);.*/\1/p' "$SOURCE/intro/show/length.h") # the film's length, 8 a second
seconds_at() { awk "BEGIN { print $1 / $WIDTH * $ROWS / 8 }"; } # seconds_at COLUMN: prints the time of a column of the strip

check "it opens a window" begin "$BUILD/$FILM-debug" --from 25 --size ${WIDTH}x$HEIGHT --mute
xdotool windowfocus "$window"
await titled 'row'
press space
check "space pauses" await titled paused
look hidden

# --- The time line ---
press Tab
look shown
check "TAB shows the time line" less 0.5 "$(differ hidden shown $STRIP)"
check "... and leaves the rest of the picture" less "$(differ hidden shown $REST)" 0.001
pointer 320 350
xdotool mousedown 1
check "a click on it seeks there" await near "$(seconds_at 320)" 0.3
xdotool mousemove_relative 40 0
check "... and dragging seeks further" await near "$(seconds_at 360)" 0.3
xdotool mousemove_relative -- 0 -200
drawn
check "... even off the strip, without turning the camera" near "$(seconds_at 360)" 0.3
xdotool mouseup 1
check "... still paused" titled paused
look plain
press p
look heat
check "P shows the samples" less 0.8 "$(differ plain heat $REST)"
press p

# (panel_test tests how a loop is played)
pointer 120 350
xdotool mousedown 3
xdotool mousemove_relative 3 0
xdotool mouseup 3
look looped
press l
check "the right button marks a loop, which L ends" eval 'look unlooped; less 0.02 "$(differ looped unlooped 5x25+119+335)"'
pointer 120 350
xdotool click 1
check "a click seeks there, paused" await at "$(printf %05.2f "$(seconds_at 120)")"
press Next # (the unit tests of the panel test all steps)
check "page down seeks to the next bar" await at 32
pointer 639 350
xdotool click 1
press space
check "after its end the film begins again" await near 1.5 1.5
press space

look before
press Tab
look after
check "TAB hides it" less 0.5 "$(differ before after $STRIP)"
press Escape
check "ESC quits" eval 'ended $pid'
check "... and prints nothing" test ! -s "$WORK/err"
finish
