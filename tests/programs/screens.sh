# The film on screens of many sizes: its picture is in the middle, as large as possible, and the rest is black.
. "$(dirname "$0")/display.sh"
odraz=$BUILD/odraz-safe

# shows WIDTH HEIGHT X Y W H [OPTION...]: plays on a screen of this size; succeeds if the film fills the rectangle at
# (X, Y) and the rest is black. At 24 s the sky is bright in the upper corners
shows() {
    start_display "$1x$2"
    await plays "lit $3 $4 $5 $6 $1 $2" "${@:7}"
}
# plays CONDITION [OPTION...]: plays the film until the condition holds; fails if the film ends first, as may happen on
# a busy machine
plays() {
    in_background "$odraz" --mute --threads 1 --from 24 --to 60 "${@:2}"
    comes "$1" && kill $pid && await gone $pid
}
brightness() { convert "$WORK/screen.png" -crop "$1" +repage -colorspace gray -format '%[fx:round(255*mean)]' info:; }
lit() { # lit X Y W H WIDTH HEIGHT: succeeds if just this rectangle of the screen is lit
    import -window root -quality 0 "$WORK/screen.png" 2>/dev/null || return 1
    [ "$(brightness "2x2+$(($1 + 2))+$(($2 + 2))")" -gt 20 ] && [ "$(brightness "2x2+$(($1 + $3 - 4))+$(($2 + 2))")" -gt 20 ] || return 1
    [ "$1" -lt 2 ] || [ "$(brightness "$(($1 - 1))x$6+0+0")" = 0 ] || return 1
    [ "$2" -lt 2 ] || [ "$(brightness "$5x$(($2 - 1))+0+0")" = 0 ]
}
check "1366x768" shows 1366 768 0 0 1365 768
check "1280x1024: bars above and below" shows 1280 1024 0 152 1280 720
check "1000x300: bars at the sides" shows 1000 300 233 0 533 300
check "3000x1800: more than it traces" shows 3000 1800 0 56 3000 1687
check "--size: scaled to the screen" shows 1280 720 0 0 1280 720 --size 320x180
check "... with its own aspect" shows 1280 720 280 0 720 720 --size 200x200
finish
