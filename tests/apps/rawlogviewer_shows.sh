#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# rawlogviewer_shows.sh OFFMAP SOURCE_FOLDER SCREENSHOT.png
# Reduces the VLP-16 scan of mrpt-common, opens the result in RawLogViewer under Xvfb, chooses the scan, and succeeds
# once its 3D view holds points: they are coloured by height there, everything else is grey. Then the same with what
# --inspect wrote, which has to show the dark red of what was removed and the light green of what was kept.
set -eu
offmap=$1 source=$2 screenshot=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir "$work/.RawLogViewer"
cat >"$work/.RawLogViewer/config.cfg" <<'CONFIG'
[tips]
show=0
[ParametersView3DPoints]
colorFromRGBimage=0
colorizeByAxis=2
CONFIG
"$offmap" reduce /usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog \
    --map "$source/share/maps/vlp16_demo.lines" --config "$source/config/vlp16.yaml" --pose 0,0,0 \
    -o "$work/reduced.rawlog" --inspect "$work/inspect.rawlog" --quiet

cat >"$work/drive.sh" <<'DRIVE'
set -eu
work=$1 screenshot=$2 log=$3
RawLogViewer "$work/$log.rawlog" >"$work/viewer.log" 2>&1 &
viewer=$!
trap 'kill $viewer 2>/dev/null || true' EXIT

# Pixels of the 3D view in the screenshot that an expression of ImageMagick is true for.
pixels() {
    convert "$screenshot" -crop 970x240+410+485 +repage -fx "$1" -format '%[fx:round(mean*w*h)]' info:
}

shown() {
    case $log in
        reduced)
            coloured=$(pixels 'saturation>0.6')
            echo "try $tries: $coloured coloured pixels"
            [ "$coloured" -gt 5000 ]
            ;;
        inspect)
            red=$(pixels 'r>0.5&&g<0.2&&b<0.2') green=$(pixels 'g>0.8&&r<0.7&&b<0.7')
            echo "try $tries: $red dark red, $green light green pixels"
            [ "$red" -gt 200 ] && [ "$green" -gt 50 ]
            ;;
    esac
}

tries=0
while [ $tries -lt 40 ]; do
    tries=$((tries + 1))
    sleep 1
    window=$(xdotool search --onlyvisible --name RawLogViewer 2>/dev/null | head -n 1) || true
    [ -n "$window" ] || continue
    xdotool windowsize "$window" 1390 890 windowmove "$window" 0 0
    xdotool mousemove 122 122 click 1  # the first entry of the tree
    sleep 1
    # The wheel takes the camera further away, to where the walls come into view.
    [ $log = reduced ] || xdotool mousemove 880 600 click --repeat 6 --delay 50 5
    sleep 1
    import -window root "$screenshot"
    ! shown || exit 0
done
echo "RawLogViewer does not show $log.rawlog:"
tail -n 5 "$work/viewer.log"
exit 1
DRIVE
for log in reduced inspect; do
    HOME=$work xvfb-run -a -s '-screen 0 1400x900x24 +extension GLX' \
        sh "$work/drive.sh" "$work" "${screenshot%.png}.$log.png" $log
done
