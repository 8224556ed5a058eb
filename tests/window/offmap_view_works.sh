#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# offmap_view_works.sh OFFMAP OFFMAP_VIEW SCREENSHOTS
# A person at the real window under Xvfb: opens a simulated log, plays, steps, asks for a point's verdict, tunes a
# parameter, hides what the map knows, switches the theme, takes a screenshot and quits. Each step has to show on the
# screen. SCREENSHOTS is the beginning of the names under which pictures stay for a look.
set -eu
offmap=$1 viewer=$2 screenshots=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$offmap" simulate office_room --scans 40 -o "$work/log" --quiet

cat >"$work/drive.sh" <<'DRIVE'
set -eu
viewer=$1 screenshots=$2 work=$3
cd "$work" # where screenshots of the program go
say() { echo "$*" >&2; }
fail() {
    import -window root "$screenshots.failed.png" || true
    say "failed: $*"
    cat viewer.log >&2
    exit 1
}

# Until a command succeeds, for at most ten seconds.
eventually() {
    for _ in $(seq 50); do
        if "$@" >/dev/null 2>&1; then return 0; fi
        sleep 0.2
    done
    return 1
}

# Parts of the window: X, Y, width and height.
picture=960x700+10+90 place=160x28+375+34 verdict=370x160+1010+310

# Pixels of a part that an expression of ImageMagick is true for.
pixels() { # PART EXPRESSION
    import -window root -crop "$1" +repage miff:- | convert miff:- -fx "$2" -format '%[fx:round(mean*w*h)]' info:
}
red() { pixels $picture 'r>0.5&&g<0.25&&b<0.25'; }
moreRedThan() { [ "$(red)" -gt "$1" ]; }
lessRedThan() { [ "$(red)" -lt "$1" ]; }
isBright() { [ "$(pixels 200x60+20+100 'r+g+b>2.5')" -gt 10000 ]; }
remember() { import -window root -crop "$1" +repage "before.png"; } # PART
differs() { # PART
    import -window root -crop "$1" +repage "now.png"
    ! cmp -s before.png now.png && [ "$(compare -metric AE before.png now.png null: 2>&1)" -gt 10 ]
}
hasScreenshot() { ls offmap-view-*.png; }
click() { xdotool mousemove "$1" "$2" click 1; }
keep() { import -window root "$screenshots.$1.png"; }

open_window() { # [options of the viewer]
    "$viewer" log/scans.rawlog --map log/map.lines "$@" >viewer.log 2>&1 &
    pid=$!
    trap 'kill -9 $pid 2>/dev/null || true' EXIT
    eventually xdotool search --onlyvisible --name offmap-view || fail "no window appears"
    window=$(xdotool search --onlyvisible --name offmap-view | head -n 1)
    xdotool windowsize "$window" 1400 900 windowmove "$window" 0 0 windowfocus "$window"
    eventually moreRedThan 1500 || fail "the scan does not show what was removed: $(red) pixels"
}

# The program is to end by itself, with success, within two seconds.
ends() { # HOW
    begin=$(date +%s%N)
    while kill -0 $pid 2>/dev/null; do
        [ $((($(date +%s%N) - begin) / 1000000)) -lt 2000 ] || fail "it lives on two seconds after $1"
        sleep 0.02
    done
    code=0
    wait $pid || code=$?
    [ $code -eq 0 ] || fail "it ends with $code after $1"
    say "ended $((($(date +%s%N) - begin) / 1000000)) ms after $1"
}

open_window
xdotool mousemove 500 300
keep opened

remember $place
xdotool key space
eventually differs $place || fail "it does not play"
xdotool key space
sleep 0.5
remember $place
xdotool key Right
eventually differs $place || fail "it does not step"
remember $place
xdotool key Left
eventually differs $place || fail "it does not step back"

xdotool key Home
sleep 1
remember $verdict
# Somewhere on the wall to the left, which is covered with points.
for y in 400 410 420 430 440 450; do
    click 160 $y
    sleep 0.5
    if differs $verdict; then break; fi
done
differs $verdict || fail "no verdict about a point"
keep picked

before=$(red)
click 1205 527 # the page of parameters
sleep 0.5
click 1150 566 # its filter
xdotool type 'min length'
sleep 0.5
click 1275 629
xdotool key ctrl+a
xdotool type '2.9'
xdotool key Return
eventually lessRedThan $((before * 3 / 4)) || fail "a parameter changes nothing: $before and $(red) red pixels"
keep tuned
click 1380 629 # its reset
eventually moreRedThan $((before * 3 / 4)) || fail "the parameter does not go back"

click 20 780 # beside the scan; keys are now for the picture
xdotool key m
eventually lessRedThan 300 || fail "mapped points stay: $(red) red pixels"
xdotool key d
eventually isBright || fail "the theme stays dark"
keep light
xdotool key d m
eventually moreRedThan 1500 || fail "mapped points do not come back"
xdotool key 2
sleep 1
keep height
xdotool key 1 t
sleep 1
keep top
xdotool key p

xdotool key ctrl+s
eventually hasScreenshot || fail "no screenshot is written"
format=$(identify -format %m offmap-view-*.png) || true
[ "$format" = PNG ] || fail "the screenshot is no PNG, but '$format'"
xdotool key ctrl+q
ends 'Ctrl+Q'

open_window --play --speed max
kill -TERM $pid
ends 'SIGTERM while it plays as fast as it can'
DRIVE
HOME=$work xvfb-run -a -s '-screen 0 1400x900x24 +extension GLX' \
    sh "$work/drive.sh" "$viewer" "$screenshots" "$work"
