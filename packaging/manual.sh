#!/bin/sh
# Makes the manual's measured pictures and tables again, on this machine: resources/manual. Needs
# rsvg-convert (librsvg2-bin) and montage (imagemagick).
set -eu
here=$(dirname "$0")
"$here/install.sh" "$here/test-packages.txt"
"$here/build.sh" hogelscope
cmake --build --preset release --target screenshots
cd "$here/.."

program=build/release/bin/hogelscope
output=build/manual
mkdir -p "$output"
"$program" --tradeoff --session data/table1.json --states 'Fig [136]' --output "$output/display"
"$program" --tradeoff --session data/table1.json --states 'Fig [136]' --output "$output/ideal" \
  --set sampling.reconstruction=quadrilinear
"$program" --stability --output "$output/stability"
"$program" --measure --session data/table1.json --output "$output/measure"
rsvg-convert -w 1200 -b white "$output/measure/plots/mtf_page.svg" -o resources/manual/mtf.png
cat > "$output/table.json" <<'TABLE'
{"parameters": {"display.directions": [[10, 10], [20, 20], [40, 40]], "display.fov": [[30, 30], [60, 60]],
                "psf.sigma": {"from": 0.4, "to": 1.6, "count": 4}},
 "figures": ["depthOfField50", "mtf:0.02", "crosstalk", "viewingZone", "megapixels"],
 "pareto": {"depthOfField50": "max", "viewingZone": "max", "megapixels": "min"}}
TABLE
"$program" --sweep "$output/table.json" --session data/table1.json --states 'Fig 1' --output "$output/sweep" \
  --set psf.windowSize=5
rsvg-convert -w 1400 -b white "$output/sweep/plots/parallel.svg" -o resources/manual/sweep.png
"$program" --depth --session data/room.json --output "$output/depth"
data/moving_room.sh "$output/moving" "$program"
printf 'time,x,y,z\n0,-0.1,0.02,0.6\n2,0.1,0.02,0.56\n' > "$output/moving/walk.csv"
"$program" --make-cameras "$output/moving/walk.csv" --session "$output/moving/original/{T}" --count 48 \
  --set lightField.fps=24 --set 'display.size=[0.5,0.5]' --set 'display.fov=[30,30]' \
  --set cameraSet.keepTemplate=false --output "$output/moving/walking.json"
(cd "$output/moving" && "../../../$program" --report --session walking.json --output report \
  --test hevc-22 --test hevc-27 --test hevc-32 --test hevc-37 \
  --test av1-24 --test av1-34 --test av1-44 --test av1-54)
rsvg-convert -w 700 -b white "$output/moving/report/plots/frames_mean_psnr_seen.svg" \
  -o resources/manual/frames_psnr.png
cp "$output/depth/depth.png" resources/manual/depth_budget.png
cp "$output/display/tradeoff.png" resources/manual/tradeoff_display.png
cp "$output/ideal/tradeoff.png" resources/manual/tradeoff_ideal.png
cp "$output/stability/stability.png" resources/manual/stability.png
"$program" --help parameters > resources/manual/parameters.md
"$program" --generate scene --session data/table1.json --degrade jpeg:10 --output "$output/jpeg10.png"
"$program" --render --session data/room.json --states front --set 'camera.res=[880,560]' \
  --set camera.fov=31 --output "$output"
"$program" --render --session data/table1.json --states 'Fig 1' --set 'camera.res=[440,280]' \
  --set camera.fov=36 --output "$output"
"$program" --render --session data/room.json --states front --set 'camera.res=[420,420]' \
  --set pupil.diameter=0.012 --focus-stack 2 --output "$output"
sheet=data/displays/looking_glass_portrait_sheet.json
"$program" --render --session $sheet --output "$output/sheet"
aside() {  # NAME [OPTIONS]
  made=$1
  shift
  "$program" --render --session $sheet --states near --set stereo.ipd=0 --set 'camera.eye=[0.12,0,0.6]' \
    --set camera.fov=18 --output "$output/sheet/$made" "$@"
}
aside right
aside pitch --set lightField.calibration.pitch=52.3
aside slope --set lightField.calibration.slope=-7.6
aside spot --set display.spot=0.0001
beside() {  # PICTURE FILE…
  made=$1
  shift
  montage "$@" -tile x1 -geometry 300x400+3+3 +dither -colors 128 -strip "PNG8:resources/manual/$made"
}
beside lens_sheet_eyes.png "$output"/sheet/eyes.left.png "$output"/sheet/eyes.right.png \
  "$output"/sheet/flip.left.png "$output"/sheet/flip.right.png
beside lens_sheet_wrong.png "$output"/sheet/right/near.png "$output"/sheet/pitch/near.png \
  "$output"/sheet/slope/near.png "$output"/sheet/spot/near.png
cp "$output/front.focus01.png" resources/manual/focus_near.png
cp "$output/front.focus02.png" resources/manual/focus_far.png
cp "$output/front.png" resources/home/room.png
cp "$output/Fig 1.png" resources/home/table1.png
"$program" --render --session data/as_built.json --states front --set 'camera.res=[440,216]' \
  --set camera.fov=25 --output "$output/home"
cp "$output/home/front.png" resources/home/as_built.png
"$program" --render --session $sheet --states eyes --set stereo.ipd=0 --set 'camera.res=[440,216]' \
  --set camera.fov=5.6 --output "$output/home"
cp "$output/home/eyes.png" resources/home/looking_glass_portrait_sheet.png
"$program" --render --session data/arc.json --set 'camera.res=[144,106]' --set camera.fov=48 \
  --output "$output/home"
montage "$output"/home/eye\ [134679].png -tile 3x2 -geometry 144x106+1+1 -background black -strip \
  resources/home/arc.png
screenshots() {
  xvfb-run -a -s "-screen 0 2560x1600x24" build/release/bin/screenshots resources/manual "$@"
}
screenshots 1280x800 "$output/jpeg10.png"
screenshots 1600x900 data/room.json layoutCompareAction compareIdealAction wipeAction
screenshots 2560x1440 data/room.json layoutViewAction
screenshots 1440x900 data/room.json layoutDesignAction designDirections=560 sweepButton \
  compareDesigns tintBox
mv resources/manual/window_1440x900.png resources/manual/window_measure.png
"$program" --render --session data/room.json --states front --output "$output/built" \
  --save-session "$output/built.json" --set 'display.directions=[45,45]' --set psf.light=linear \
  --set twin.lensArray.rotation=0.05 --set twin.lensArray.gapError=0.02 --set twin.random.seed=3 \
  --set twin.random.shift.sigma=3e-5 --set twin.random.shift.length=30 \
  --set twin.random.gain.sigma=0.08 --set twin.random.gain.length=20
screenshots 1440x900 "$output/built.json" scenePanelPictureAction
mv resources/manual/window_1440x900.png resources/manual/window_twin.png
QT_SCALE_FACTOR=2 screenshots 1280x800 data/room.json lightColours
