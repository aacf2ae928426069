# What the tests of engines share, read by `.`: $program is hogelscope. A small report, made by one
# process into whole/, is what every engine has to reach to the byte.
folder=$(mktemp -d)
trap 'stop_all; rm -rf "$folder"' EXIT
stop_all() { :; }
cd "$folder"
export HOGELSCOPE="$program"

cat > s.json <<'S'
{ "hogelscope": 1,
  "display": { "hogels": [32, 32], "directions": [8, 8] },
  "lightField": { "file": "a.png" },
  "sampling": { "samplesPerPixel": 4 },
  "cameras": [ { "name": "c", "eye": [0, 0, 0.7], "res": [160, 120],
                 "psf": { "sigma": 0.8, "windowSize": 5 } } ] }
S
"$program" --generate scene --session s.json --output a.png --quiet
"$program" --generate scene --session s.json --output b.png --degrade noise:4 --quiet
"$program" --generate scene --session s.json --output c.png --degrade blur:1 --quiet
"$program" --make-cameras random --session s.json --count 39 --seed 5 --output many.json --quiet
arguments="--session many.json --test b.png --test c.png"
# shellcheck disable=SC2086 # words
"$program" --report $arguments --output whole --quiet

# Only report.html says when and by which command it was made.
same_as_whole() {
  diff -r --exclude=report.html --exclude=report.hashes whole "$1"
  [ -s "$1/report.html" ]
}
