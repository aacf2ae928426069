#!/bin/sh
# Makes what a campaign needs: three light fields (two of data/room.glb, and the card of data/scene.png), each as
# views (SCENE/original), coded by JPEG, WebP and JPEG 2000 at five rates (SCENE/jpeg-20 …), a session with
# 24 states for each (SCENE.json), and campaign.json. Needs mogrify of ImageMagick.
#
#   data/three_scenes.sh OUTPUT [hogelscope]
set -eu
data=$(dirname "$0")
output=$1
program=${2:-hogelscope}
mkdir -p "$output"
scene() {  # NAME SESSION FIELD_OF_VIEW [OPTION…]
  name=$1 session=$2 fov=$3
  shift 3
  "$program" --export views --session "$session" --output "$output/$name/original" --quiet "$@"
  "$program" --make-cameras random --session "$output/$name/original" --count 24 --seed 1 --quiet \
    --set 'display.size=[0.5,0.5]' --set "display.fov=[$fov,$fov]" --output "$output/$name.json"
}
code() {  # NAME FORMAT ENDING QUALITY…
  name=$1 format=$2 ending=$3
  shift 3
  for quality in "$@"; do
    folder=$output/$name/$format-$quality
    mkdir -p "$folder"
    mogrify -path "$folder" -format "$ending" -quality "$quality" "$output/$name/original/*.png"
  done
}
views='--set display.hogels=[192,192] --set display.directions=[7,7] --set display.fov=[30,30]'
# shellcheck disable=SC2086  # a list of options
scene room "$data/room.json" 30 $views
# shellcheck disable=SC2086
scene corner "$data/room.json" 30 $views --set 'lightField.mesh.orientation=[0,35,0]' \
  --set lightField.mesh.scale=1.8
scene card "$data/table1.json" 60
for name in room corner card; do
  code $name jpeg jpg 20 40 60 80 90
  code $name webp webp 10 30 50 70 90
  code $name jp2 jp2 26 30 34 38 42
done
cat >"$output/campaign.json" <<'END'
{
  "scenes": { "room": "room.json", "corner": "corner.json", "card": "card.json" },
  "tests": [
    { "group": "JPEG", "name": "q{q}", "q": [20, 40, 60, 80, 90], "file": "{scene}/jpeg-{q}" },
    { "group": "WebP", "name": "q{q}", "q": [10, 30, 50, 70, 90], "file": "{scene}/webp-{q}" },
    { "group": "JPEG 2000", "name": "q{q}", "q": [26, 30, 34, 38, 42], "file": "{scene}/jp2-{q}" }
  ]
}
END
