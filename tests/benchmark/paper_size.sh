#!/bin/bash
# The figures of docs/measurements.md, "The paper's size", by hand: an hour and 12 GB of disk.
#   tests/benchmark/paper_size.sh FOLDER [HOGELS [STATES]]     default: 512 200
# Light fields and stores that FOLDER has already are used again. Needs Debian's `time`.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
program=$root/build/release/bin/hogelscope
mkdir -p "$1" && cd "$1"
hogels=${2:-512}
states=${3:-200}
content=(--session "$root/data/table1.json" --set "display.hogels=[$hogels,$hogels]"
  --set "display.directions=[600,600]")

# Runs the rest, and says what it took: seconds, CPU seconds, most memory.
measure() {
  local name=$1
  shift
  /usr/bin/time -o time.txt -f "%e s, %U + %S s of CPU, %M kB" "$@" --quiet
  echo "$name: $(cat time.txt)" | tee -a figures.txt
}

echo "$hogels×$hogels hogels of 600×600, $states states, $(nproc) cores, $(date +%F)" | tee -a figures.txt
[ -f "paper$hogels.png" ] ||
  measure "generate" "$program" --generate spheres "${content[@]}" --output "paper$hogels.png"
[ -f "blur$hogels.png" ] ||
  measure "generate, blur:1" "$program" --generate spheres "${content[@]}" --degrade blur:1 \
    --output "blur$hogels.png"

# One state of Table I without distortion, and random ones in the box before the panel.
python3 - "$root/data/table1.json" "$hogels" <<'PYTHON'
import json, sys
session = json.load(open(sys.argv[1]))
session['display'].update(hogels=[int(sys.argv[2])] * 2, directions=[600, 600])
session['lightField']['file'] = f'paper{sys.argv[2]}.png'
session['cameras'] = [session['cameras'][3]]
json.dump(session, open('one.json', 'w'))
PYTHON
rm -f states.json
"$program" --make-cameras random --session one.json --count $((states - 1)) --region box --seed 1 \
  --output states.json --quiet
ls -l "paper$hogels.png" "blur$hogels.png" | tee -a figures.txt
rm -rf report_png report_store view

measure "one view, PNG" "$program" --render --session one.json --output view
measure "report, PNG against PNG" "$program" --report --session states.json \
  --test "blur$hogels.png" --images --output report_png
for name in paper blur; do
  [ -f "$name$hogels.tif" ] ||
    measure "pack $name" "$program" --pack "$name$hogels.png" --session one.json \
      --output "$name$hogels.tif"
done
ls -l "paper$hogels.tif" "blur$hogels.tif" | tee -a figures.txt
stored=(--set "lightField.file=paper$hogels.tif" --set lightField.layout=pack)
measure "one view, store" "$program" --render --session one.json "${stored[@]}" --output view
measure "report, store against store" "$program" --report --session states.json "${stored[@]}" \
  --test "blur$hogels.tif" --images --output report_store

# Every pixel, and every figure.
for part in reference test1; do diff -r "report_png/$part" "report_store/$part"; done
cmp report_png/report.csv <(sed "s/blur$hogels.tif/blur$hogels.png/" report_store/report.csv)
echo "store and PNG: every picture is the same" | tee -a figures.txt
