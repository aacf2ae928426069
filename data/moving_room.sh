#!/bin/sh
# Makes a light field in time and codes it: data/room.glb turns by half a degree a frame, 48 frames of 7×7
# views at 24 frames/s, in PNG (original/0000/000_000.png …) and as a video of each view in HEVC and AV1 at
# four rates (hevc-22/000_000.mp4 …, av1-24/000_000.mp4 …). Needs ffmpeg with libx265 and libsvtav1.
#
#   data/moving_room.sh OUTPUT [hogelscope]
set -eu
room=$(dirname "$0")/room.json
output=$1
program=${2:-hogelscope}
frames=48
mkdir -p "$output"
frame=0
while [ $frame -lt $frames ]; do
  angle=$(awk "BEGIN { print $frame / 2 - 12 }")
  "$program" --export views --session "$room" --output "$output/original/$(printf %04d $frame)" --quiet \
    --set 'display.hogels=[192,192]' --set 'display.directions=[7,7]' --set 'display.fov=[30,30]' \
    --set "lightField.mesh.orientation=[0,$angle,0]"
  frame=$((frame + 1))
done
code() {  # FOLDER ENCODER QUALITY PRESET [OPTION…]
  folder=$output/$1 encoder=$2 quality=$3 preset=$4
  shift 4
  mkdir -p "$folder"
  for view in "$output"/original/0000/*.png; do
    name=$(basename "$view" .png)
    ffmpeg -y -loglevel error -framerate 24 -i "$output/original/%04d/$name.png" -pix_fmt yuv420p \
      -c:v "$encoder" -crf "$quality" -preset "$preset" "$@" "$folder/$name.mp4"
  done
}
for quality in 22 27 32 37; do
  code hevc-$quality libx265 $quality medium -x265-params log-level=none
done
for quality in 24 34 44 54; do
  SVT_LOG=0 code av1-$quality libsvtav1 $quality 8
done
