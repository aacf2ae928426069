#!/bin/sh
# Builds Hogelscope and does its main job once: renders every camera state of the sample session and
# reports how a JPEG copy of its light field looks from each of them.
set -eu
here=$(dirname "$0")
"$here/build.sh" hogelscope
cd "$here/.."

program=build/release/bin/hogelscope
output=build/try
mkdir -p "$output"
[ -f "$output/scene.jpg" ] ||
  "$program" --generate scene --session data/table1.json --output "$output/scene.jpg" --quiet
"$program" --render --session data/table1.json --output "$output/views" --masks
"$program" --report --session data/table1.json --test "$output/scene.jpg" --output "$output/report"

cat <<TEXT

The six simulated views:   $PWD/$output/views
The report as CSV:         $PWD/$output/report/report.csv
                and page:  $PWD/$output/report/report.html
The desktop app:           $program data/table1.json
TEXT
