#!/bin/bash
# tests/bytes.sh OLD NEW: runs the same commands and the same Python script with two builds of the
# program, and compares all that they write and print, byte for byte. For changes that must not
# change anything: OLD and NEW are paths of bin/hogelscope. Left out are measured times, the
# program's version, the dates in report.html, and the order of a shard's rows. A command that ends
# with another status than is written before it is an error too.
set -u
[ $# -eq 2 ] || { sed -n '2,6s/^# //p' "$0"; exit 2; }
old=$(realpath "$1")
new=$(realpath "$2")
source=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
table1=$source/data/table1.json
room=$source/data/room.json
sheet=$source/data/displays/looking_glass_portrait_sheet.json
scenes=$source/tests/scenes
in=$work/in
mkdir "$in"
"$old" --generate scene --session "$table1" --output "$in/scene.png" --quiet
"$old" --generate spheres --session "$table1" --output "$in/spheres.jpg" --degrade jpeg:60 --quiet
"$old" --export hogels --session "$room" --set 'display.hogels=[64,40]' --output "$in/room.png" --quiet
"$old" --export quilt --session "$sheet" --set 'display.hogels=[42,56]' --set 'display.directions=[12,1]' \
  --output "$in/sheet_qs12x1a0.75.png" --quiet

# A small display of a live scene, with an eye of each kind.
cat >"$in/small.json" <<JSON
{"hogelscope": 1,
 "display": {"size": [0.2, 0.2], "hogels": [32, 32], "directions": [12, 12], "fov": [50, 40]},
 "lightField": {"layout": "live", "source": "scene"},
 "cameras": [
  {"name": "front", "eye": [0, 0, 0.4], "fov": 30, "res": [60, 40]},
  {"name": "wide", "eye": [0.05, 0, 0.3], "fov": 60, "res": [60, 60], "distortion": {"k1": -0.2},
   "psf": {"sigma": 0.67, "windowSize": 3}},
  {"name": "eyes", "eye": [0, 0, 0.4], "fov": 30, "res": [60, 40], "stereo": {"ipd": 0.063},
   "pupil": {"diameter": 0.006, "focus": 0.35, "samples": 8}}]}
JSON
# A small lens sheet that shows a quilt.
cat >"$in/visual.json" <<JSON
{"serial": "test", "pitch": {"value": 5.0}, "slope": -6.0, "center": 0.1, "viewCone": 40,
 "DPI": 50, "screenW": 180, "screenH": 120}
JSON
cat >"$in/sheet.json" <<JSON
{"hogelscope": 1, "display": {"kind": "sheet", "calibration": "visual.json", "spot": 0.0002},
 "lightField": {"file": "sheet_qs12x1a0.75.png", "layout": "quilt"},
 "cameras": [
  {"name": "front", "eye": [0, 0, 0.6], "fov": 6, "res": [120, 80], "stereo": {"ipd": 0.063}},
  {"name": "side", "eye": [0.1, 0, 0.5], "fov": 8, "res": [120, 80]}]}
JSON
# A unit of the small display, a table of designs, a trace.
cat >"$in/unit.json" <<JSON
{"hogelscope": 1, "twin": {
  "lensArray": {"offset": [0.0002, -0.0001], "rotation": 0.1, "pitchError": [0.001, 0.0005],
                "gapError": 0.03, "wedge": [0.01, 0], "focalError": 0.01, "outside": "neighbour"},
  "colour": {"scale": [-0.01, 0, 0.015]}, "leakage": {"sigmaGrowth": 0.5}, "light": {"bits": 7},
  "dead": {"rows": [100], "hogels": [[6, 7]]},
  "random": {"seed": 5, "shift": {"sigma": 0.0001, "length": 2}, "gain": {"sigma": 0.02}}}}
JSON
cat >"$in/table.json" <<JSON
{"parameters": {"display.directions": [[8, 8], [16, 16]], "display.fov": [[40, 40], [60, 60]],
                "twin.lensArray.gapError": [0, 0.02]},
 "figures": ["depthOfField", "megapixels", "mtf:-0.01", "hogelPitch"],
 "pareto": {"depthOfField": "max", "megapixels": "min"}}
JSON
cat >"$in/trace.csv" <<CSV
time,x,y,z
0,0,0,0.5
1,0.1,0,0.5
2,0.1,0.05,0.6
CSV

# Each line is an exit status and a command; what is in [ ] stays as it is.
commands() {
  cat <<LINES
0 --version
0 --help
0 --help report
0 --help sweep
0 --help parameters
0 --help man
0 --help completion
0 --plugins
0 --generate scene --session $table1 --output scene.png
0 --generate spheres --session $table1 --output spheres.jpg --degrade jpeg:60
0 --generate directions --session $table1 --output directions.tif
0 --generate edge --session $table1 --set pattern.depth=0.01 --output edge.png
0 --render --session $table1 --output r/plain --masks
0 --render --session $table1 --output r/exr --format exr
0 --render --session $table1 --output r/tif --format tif --states Fig*1
0 --render --session $table1 --output r/linear --set sampling.reconstruction=quadrilinear --set psf.windowSize=5 --set psf.sigma=0.9
0 --render --session $table1 --output r/direct --set sampling.mapping=direct --set sampling.samplesPerPixel=2
0 --render --session $table1 --output r/tolerance --set sampling.tolerance=2 --explain
0 --render --session $table1 --output r/turned --set display.orientation=[10,20,5] --set display.lens=equiangular
0 --render --session $table1 --output r/memory --memory 8 --quiet
0 --render --session $table1 --output r/shard --shard 2/3
0 --render --session $in/small.json --output r/undistorted --states wide --undistort
0 --render --session $table1 --output r/between --states Fig*[12] --between 2
0 --render --session $room --output r/room --masks
0 --render --session $room --output r/ideal --ideal
0 --render --session $scenes/eyes.json --output r/eyes --explain
0 --render --session $scenes/eyes.json --output r/anaglyph --states two* --stereo anaglyph
0 --render --session $in/small.json --output r/pair --states eyes --stereo side-by-side --save-session s/pair.json
0 --render --session $in/small.json --output r/focus --states eyes --focus-stack 3
0 --render --session $scenes/twin.json --output r/twin --explain --save-session s/twin.json
0 --render --session $in/small.json --twin $in/unit.json --set psf.light=linear --output r/unit --format exr
2 --render --session $in/small.json --twin $in/unit.json --output r/none
0 --make-twin --session $in/small.json --twin $in/unit.json --set psf.light=linear --output t/drawn.json
0 --render --session $in/small.json --twin t/drawn.json --set psf.light=linear --output r/drawn
0 --export hogels --session $in/small.json --twin $in/unit.json --set psf.light=linear --for-twin --output for_unit.png
0 --render --session $in/sheet.json --output r/sheet --masks --explain --save-session s/sheet.json
0 --render --session $sheet --set display.hogels=[42,56] --set camera.res=[90,120] --output r/live_sheet
0 --render --session $in/sheet.json --set twin.lensArray.rotation=0.05 --set twin.lensArray.gapError=0.02 --output r/sheet_unit --save-session s/sheet_unit.json
0 --export woven --session $in/sheet.json --output woven.png
0 --render --session $in/sheet.json --set lightField.file=$work/run/woven.png --set lightField.layout=woven --output r/woven
0 --export views --session $in/sheet.json --output sheet_views
0 --export quilt --session $in/sheet.json --output sheet_quilt.png
0 --pack $in/scene.png --session $table1 --output scene_pack.tif
0 --render --session $table1 --set lightField.file=$work/run/scene_pack.tif --set lightField.layout=pack --output r/pack --explain
0 --export views --session $table1 --output views
0 --export quilt --session $in/small.json --set display.directions=[12,1] --output quilt_qs12x1.png
0 --export mosaic --session $table1 --output mosaic.png
0 --export rig --session $in/small.json --set lightField.viewingDistance=0.6 --output rig.json
0 --export hogels --session $room --set display.hogels=[64,40] --output room.png
0 --export pack --session $room --set display.hogels=[64,40] --output room_pack.tif
0 --info $table1
0 --info $room
0 --info $in/sheet.json
0 --info $in/visual.json
0 --info $in/scene.png
0 --info views
0 --info views --json
0 --info mosaic.png
0 --info woven.png
0 --info quilt_qs12x1.png
0 --info scene_pack.tif
0 --render --session views --output r/views --save-session s/views.json
0 --report --session $table1 --test $in/spheres.jpg --test $in/scene.png --output p/plain --images
0 --report --session $table1 --test $in/spheres.jpg --output p/half --shard 1/2
1 --status p/half
0 --report --session $table1 --test $in/spheres.jpg --output p/half
0 --report --session $table1 --test $in/spheres.jpg --memory 12 --output p/memory --explain
0 --report --session $room --set display.hogels=[64,40] --test $in/room.png --against ideal --output p/ideal
0 --report --session $in/small.json --against design --twin $in/unit.json --twin t/drawn.json --set psf.light=linear --states front --output p/unit --images
0 --report --session $in/sheet.json --test $in/sheet.json --output p/sheet
0 --measure --session $in/small.json --output m/small
0 --measure --session $in/small.json --states front --set psf.windowSize=5 --set psf.sigma=0.67 --output m/leak
0 --measure --session $in/small.json --set twin.lensArray.gapError=0.02 --set psf.light=linear --output m/unit
0 --measure --session $in/sheet.json --output m/sheet
0 --sweep $in/table.json --session $in/small.json --set psf.light=linear --output w/small
0 --sweep $in/table.json --session $in/small.json --set psf.light=linear --output w/half --shard 1/2
1 --status w/half
0 --depth --session $in/small.json --output d/small
0 --depth --session $room --states front --set camera.res=[60,60] --output d/room --fit s/fit.json
2 --depth --session $in/sheet.json --output d/sheet
0 --depth --session views --output d/views --save-session s/depth.json
0 --stability --output stability
0 --make-cameras uniform --session $table1 --count 15 --output s/uniform.json
0 --make-cameras random --session $table1 --output s/random.json --count 9 --seed 4
0 --make-cameras $in/trace.csv --session $table1 --output s/trace.json --set display.size=[0.4,0.4]
2 --render --session nothing.json --output r/none
2 --render --session $table1 --set psf.sigma=-1 --output r/none
2 --render --session $in/sheet.json --set display.fov=[40,40] --output r/none
2 --render --session $in/small.json --set twin.light.black=0.1 --output r/none
2 --sweep $in/table.json --session $in/sheet.json --output r/none
2 --export hogels --session $in/sheet.json --output none.png
2 --make-twin --session $in/sheet.json --output none.json
2 --info $source/CMakeLists.txt
LINES
}

# run FOLDER PROGRAM
run() {
  mkdir "$work/run"
  cd "$work/run" || exit
  count=0
  while read -r expected line; do
    count=$((count + 1))
    # shellcheck disable=SC2086,SC2046  # the words of a line
    HOME=$work "$2" $(eval "echo $(printf '%s' "$line" | sed "s/[][*]/\\\\&/g")") \
      >"out$count" 2>"err$count" </dev/null
    status=$?
    [ $status = "$expected" ] && continue
    echo "$2 $line: ends with $status in place of $expected"
    sed 's/^/  /' "err$count"
  done < <(commands) >"$work/wrong_$1"
  HOME=$work PYTHONPATH=$(dirname "$(dirname "$2")")/lib/python3/dist-packages \
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$source/tests/bytes.py" "$in" >outpy 2>errpy ||
    sed "s#^#bytes.py: #" errpy >>"$work/wrong_$1"
  sed -i -e '/^time spent/d' -e "s#$(dirname "$(dirname "$2")")##" out* err*
  version=$("$2" --version | grep -oE '[0-9]+\.[0-9]+\.[0-9]+' | head -1)
  find . \( -name report.html -o -name 'out*' \) -exec sed -i "s/\b$version\b//g" {} +
  find . -name report.html -exec sed -i -E 's/20[0-9]{2}-[0-9]{2}-[0-9]{2}[T ][0-9:]{5,8}Z?//g' {} +
  find . -name 'report.journal*' -exec sort -o {} {} \;  # of two threads
  mv "$work/run" "$work/$1"
}

run a "$old"
run b "$new"
cat "$work/wrong_a" "$work/wrong_b"
different=$(diff -rq "$work/a" "$work/b") && [ ! -s "$work/wrong_a" ] && [ ! -s "$work/wrong_b" ] && {
  echo "$(commands | wc -l) commands, $(find "$work/a" -type f | wc -l) files: the same bytes"
  exit 0
}
echo "$different"
diff -r "$work/a" "$work/b" | head -40
exit 1
