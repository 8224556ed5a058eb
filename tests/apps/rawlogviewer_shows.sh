#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# rawlogviewer_shows.sh OFFMAP SOURCE_FOLDER SCREENSHOT.png
# Reduces the VLP-16 scan of mrpt-common, opens the result in RawLogViewer under Xvfb, chooses the scan, and succeeds
# once its 3D view holds points: they are coloured by height there, everything else is grey.
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
    -o "$work/reduced.rawlog" --quiet

cat >"$work/drive.sh" <<'DRIVE'
set -eu
RawLogViewer "$1/reduced.rawlog" >"$1/viewer.log" 2>&1 &
viewer=$!
trap 'kill $viewer 2>/dev/null || true' EXIT
tries=0
while [ $tries -lt 40 ]; do
    tries=$((tries + 1))
    sleep 1
    window=$(xdotool search --onlyvisible --name RawLogViewer 2>/dev/null | head -n 1) || true
    [ -n "$window" ] || continue
    xdotool windowsize "$window" 1390 890 windowmove "$window" 0 0
    xdotool mousemove 122 122 click 1  # the first entry of the tree
    sleep 1
    import -window root "$2"
    coloured=$(convert "$2" -crop 970x240+410+485 +repage -colorspace HSL -channel G -separate \
        -threshold 60% -format '%[fx:round(mean*w*h)]' info:)
    echo "try $tries: $coloured coloured pixels in the 3D view"
    [ "$coloured" -gt 5000 ] && exit 0
done
echo "RawLogViewer does not show the reduced scan:"
tail -n 5 "$1/viewer.log"
exit 1
DRIVE
HOME=$work xvfb-run -a -s '-screen 0 1400x900x24 +extension GLX' sh "$work/drive.sh" "$work" "$screenshot"
