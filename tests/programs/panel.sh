# The panel of odraz-debug, by keys and mouse, in a window: its title and pictures of it are checked. panel_test and
# panel_parts_test check the parts.
#   panel.sh BUILD [all [PICTURES]]
# With `all`, every part is shown. PICTURES is a folder for pictures of what was seen, for a look at them.
. "$(dirname "$0")/display.sh"
needs_built odraz-debug
all=${2-} keep=${3-}
[ -z "$keep" ] || mkdir -p "$keep"
start_display 660x400
WIDTH=640 HEIGHT=360

WINDOW="^$FILM-debug"
title() { xdotool getwindowname "$window"; }
# shown_at: seconds of the film, of the title "odraz-debug  table  0:25.00  row ..."
shown_at() { title | sed -nE 's/.*  ([0-9]+):([0-9.]+)  row .*/\1 \2/p' | awk '{ print $1 * 60 + $2 }'; }
at() { [ "$(shown_at)" = "$1" ]; } # at SECONDS, as the title writes them
near() { awk "BEGIN { off = $1 - $(shown_at); exit !(off < $2 && off > -$2) }"; } # near SECONDS TOLERANCE
pointer() { xdotool mousemove --window "$window" "$1" "$2"; }
# Two pictures later every request is shown: the title has the time that the last picture took
drawn() {
    local before now i
    for i in 1 2; do
        before=$(title)
        await eval '[ "$(title)" != "$before" ]' || return 1
    done
}
look() { # look NAME: takes a picture of the window, as NAME.png
    drawn
    import -window "$window" "$WORK/$1.png"
    [ -z "$keep" ] || cp "$WORK/$1.png" "$keep"
}
# mean_of NAME GEOMETRY: how bright it is there, 0 .. 1
mean_of() { convert "$WORK/$1.png" -crop "$2" +repage -format '%[fx:mean]' info:; }
# differ A B GEOMETRY: the share of pixels there that differ by more than 2 %
differ() {
    convert "$WORK/$1.png" "$WORK/$2.png" -crop "$3" +repage -compose difference -composite -colorspace gray -threshold 2% \
        -format '%[fx:mean]' info:
}
STRIP=640x45+0+315 REST=400x200+190+110
seconds_at() { awk "BEGIN { print $1 / $WIDTH * 162 }"; } # of a column of the strip

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
pointer 320 340
xdotool mousedown 1
check "a click on it goes there" await near "$(seconds_at 320)" 0.3
xdotool mousemove_relative 40 0
check "... and dragged further, further" await near "$(seconds_at 360)" 0.3
xdotool mousemove_relative -- 0 -200
drawn
check "... even beside it, without turning the camera" near "$(seconds_at 360)" 0.3
xdotool mouseup 1
check "... still paused" titled paused
look scrubbed

press space # play
pointer 120 340
xdotool mousedown 3
xdotool mousemove_relative 3 0
xdotool mouseup 3
inside() { less 29.9 "$(shown_at)" && less "$(shown_at)" 31.6; }
check "the right button marks a loop, which is played" await inside
stays() { # it is seen to go back, and never to leave
    local now before=0 back=0 end=$((SECONDS + 40))
    while [ $SECONDS -lt $end ] && [ $back -lt 2 ]; do
        now=$(shown_at)
        less 29.9 "$now" && less "$now" 33 || { echo "at $now" >&2; return 1; }
        less "$now" "$before" && back=$((back + 1))
        before=$now
        sleep 0.05
    done
    [ $back -ge 2 ]
}
check "... again and again" stays
press space
await titled paused
look looped
press l
check "L ends the loop" eval 'look unlooped; less 0.02 "$(differ looped unlooped 5x45+119+315)"'

# --- Steps ---
pointer 120 340
xdotool click 1
check "a click goes to 30.38 s" await at 30.38
press Next # (the unit tests of the panel make every step)
check "page down: the next bar" await at 32

# --- What it shows ---
if [ -n "$all" ]; then
    press n
    await at 42
    look costs
    press g
    look ghost
    check "G shows the camera from outside" less 0.5 "$(differ costs ghost 180x90+450+10)"
    pointer 540 60
    xdotool mousedown 1 mousemove_relative 60 10 mouseup 1
    look orbit
    check "... from another side, dragged" less 0.2 "$(differ ghost orbit 180x90+450+10)"
    check "... without a move of the film's camera" less "$(differ ghost orbit 250x150+190+130)" 0.001
    press g m
    look materials
    check "M shows the materials" less 0.001 "$(differ costs materials 150x60+10+60)"
    press m p
    look heat
    check "P shows the samples" less 0.8 "$(differ costs heat $REST)"
    press p v
    look split
    check "V shows two qualities" less 0.1 "$(differ costs split 12x200+314+60)"
    press f
    look flip
    check "F shows the difference: dark where there is none" less "$(mean_of flip $REST)" 0.3
    press f v h
    look help
    check "H lists the keys" less 0.3 "$(differ costs help 300x200+170+60)"
    press h Tab
    look hidden_again
    check "TAB hides it all" less "$(differ hidden_again costs $REST)" 0.001
fi

press Escape
check "ESC leaves" eval 'ended $pid'
check "... and prints nothing" test ! -s "$WORK/err"
finish
