#!/bin/sh
# Builds Hogelscope and does its main jobs once: renders every camera state of the sample session and
# reports how a JPEG copy of its light field looks from each of them; renders a live scene, and what
# the eye would see of it without the display.
set -eu
here=$(dirname "$0")
"$here/build.sh" hogelscope hogelscope-window hogelscope_plugin_mesh
cd "$here/.."

program=build/release/bin/hogelscope
output=build/try
mkdir -p "$output"
[ -f "$output/scene.jpg" ] ||
  "$program" --generate scene --session data/table1.json --output "$output/scene.jpg" --quiet
"$program" --render --session data/table1.json --output "$output/views" --masks
"$program" --report --session data/table1.json --test "$output/scene.jpg" --output "$output/report"
"$program" --render --session data/room.json --output "$output/room"
"$program" --render --ideal --session data/room.json --output "$output/room_ideal"

cat <<TEXT

The six simulated views:   $PWD/$output/views
A room, perceived:         $PWD/$output/room
        and ideal:         $PWD/$output/room_ideal
The report as CSV:         $PWD/$output/report/report.csv
                and page:  $PWD/$output/report/report.html
The desktop app:           $program data/table1.json
TEXT
