#!/bin/bash
# tests/bytes.sh OLD NEW: runs the same commands with two builds of the program and compares all that
# they write and print, byte for byte. For changes that must not change anything. Left out are
# measured times, the program's version, and the dates in report.html.
set -u
[ $# -eq 2 ] || { sed -n '2,4s/^# //p' "$0"; exit 2; }
old=$(realpath "$1")
new=$(realpath "$2")
source=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
table1=$source/data/table1.json
room=$source/data/room.json
in=$work/in
mkdir "$in"
"$old" --generate scene --session "$table1" --output "$in/scene.png" --quiet
"$old" --generate spheres --session "$table1" --output "$in/spheres.jpg" --degrade jpeg:60 --quiet
"$old" --export hogels --session "$room" --set 'display.hogels=[64,40]' --output "$in/room.png" --quiet

# Each line is a command; $HS is the program.
commands() {
  cat <<LINES
--version
--help
--help report
--help parameters
--help man
--help completion
--plugins
--generate scene --session $table1 --output scene.png
--generate spheres --session $table1 --output spheres.jpg --degrade jpeg:60
--generate directions --session $table1 --output directions.tif
--generate edge --session $table1 --set pattern.depth=0.01 --output edge.png
--render --session $table1 --output r/plain --masks
--render --session $table1 --output r/exr --format exr
--render --session $table1 --output r/tif --format tif --states Fig*1
--render --session $table1 --output r/linear --set sampling.reconstruction=quadrilinear --set psf.windowSize=5 --set psf.sigma=0.9
--render --session $table1 --output r/direct --set sampling.mapping=direct --set sampling.samplesPerPixel=2
--render --session $table1 --output r/tolerance --set sampling.tolerance=2 --explain
--render --session $table1 --output r/turned --set display.orientation=[10,20,5] --set display.hogelLens=equiangular
--render --session $table1 --output r/memory --memory 6 --quiet
--render --session $table1 --output r/shard --shard 2/3
--render --session $room --output r/room --masks
--render --session $room --output r/ideal --ideal
--pack $in/scene.png --session $table1 --output scene_pack.tif
--render --session $table1 --set lightField.file=$PWD/scene_pack.tif --set lightField.layout=pack --output r/pack --explain
--export views --session $table1 --output views
--export quilt --session $table1 --output quilt_qs20x20.png
--export hogels --session $room --set display.hogels=[64,40] --output room.png
--export pack --session $room --set display.hogels=[64,40] --output room_pack.tif
--info $table1
--info $room
--info $in/scene.png
--info views
--info views --json
--info quilt_qs20x20.png
--info scene_pack.tif
--render --session views --output r/views --save-session s/views.json
--report --session $table1 --test $in/spheres.jpg --test $in/scene.png --output p/plain --images
--report --session $table1 --test $in/spheres.jpg --output p/half --shard 1/2
--status p/half
--report --session $table1 --test $in/spheres.jpg --output p/half
--report --session $table1 --test $in/spheres.jpg --memory 12 --output p/memory --explain
--report --session $room --set display.hogels=[64,40] --test $in/room.png --ideal --output p/ideal
--report --session $table1 --test $in/scene.png --test $in/spheres.jpg --group a=$in/scene.png,$in/spheres.jpg --output p/rate
--make-cameras uniform --session $table1 --set cameraSet.count=[3,2,1] --output s/uniform.json
--make-cameras random --session $table1 --output s/random.json --count 9 --seed 4
--render --session nothing.json --output r/none
--render --session $table1 --set psf.sigma=-1 --output r/none
--info $source/CMakeLists.txt
LINES
}

run() {
  mkdir -p "$work/$1"
  cd "$work/$1" || exit
  count=0
  while read -r line; do
    count=$((count + 1))
    # shellcheck disable=SC2086,SC2046  # the words of a line
    HOME=$work "$2" $(eval "echo $(printf '%s' "$line" | sed 's/[][*]/\\&/g')") >"out$count" 2>"err$count" </dev/null
    echo "$? $line" >>statuses
  done < <(PWD=. commands)
  sed -i -e '/^time spent/d' -e "s#$(dirname "$(dirname "$2")")##" out* err*
  version=$("$2" --version | grep -oE '[0-9]+\.[0-9]+\.[0-9]+' | head -1)
  find . \( -name report.html -o -name 'out*' \) -exec sed -i "s/\b$version\b//g" {} +
  find . -name report.html -exec sed -i -E 's/20[0-9]{2}-[0-9]{2}-[0-9]{2}[T ][0-9:]{5,8}Z?//g' {} +
}

run a "$old"
run b "$new"
wrong=$(diff -rq "$work/a" "$work/b") && {
  echo "$(commands | wc -l) commands, $(find "$work/a" -type f | wc -l) files: the same bytes"
  exit 0
}
echo "$wrong"
diff -r "$work/a" "$work/b" | head -40
exit 1
