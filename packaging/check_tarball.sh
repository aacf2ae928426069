#!/bin/sh
# check_tarball.sh SUITE [MIRROR]: tries tarball.sh's tarball in a bare Debian (bookworm, trixie,
# forky), where it installs no more than README.txt says: renders, reads formats, compares the
# pictures with the build tree's, then starts the window. As root, by hand, about 3 minutes and
# 1.5 GB in /tmp. PICTURE=FILE in the environment keeps what the screen showed, as xwd writes it.
# Installs Debian's mmdebstrap.
set -eu
suite=$1
mirror=${2:-http://deb.debian.org/debian}
cd "$(dirname "$0")/.."
echo mmdebstrap | packaging/install.sh /dev/stdin
tarball=$(ls "$PWD"/build/release/packages/hogelscope-*.tar.zst)
formats="avif bmp dpx exr gif heic jp2 jpg pgx png ppm tga tif webp"

work=$(mktemp -d /tmp/check_tarball.XXXXXX)
trap 'rm -rf "$work"' EXIT
fail() { echo "check_tarball.sh: $suite: $*" >&2; exit 1; }
chmod 755 "$work"
root=$work/root
# A snapshot of a suite that changes is soon out of date.
mmdebstrap --quiet --variant=apt --aptopt='Acquire::Check-Valid-Until "false"' \
  "$suite" "$root" "$mirror"
cp /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
# inside USER COMMAND, with a /proc that goes away with the command.
inside() {
  user=$1
  shift
  unshare --mount --pid --fork sh -c 'mount -t proc proc "$0/proc" && exec chroot "$@"' "$root" \
    --userspec="$user" "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/home \
    DEBIAN_FRONTEND=noninteractive "$@"
}
install() {
  inside 0:0 sh -c "apt-get update -qq && apt-get install -y -qq --no-install-recommends $*" \
    >"$work/apt.log" 2>&1 || { cat "$work/apt.log" >&2; fail "apt-get cannot install $*"; }
}

# A folder that its user may not write, with a blank in its name.
mkdir "$root/a folder"
tar -C "$root/a folder" --no-same-owner -xf "$tarball"
mv "$root/a folder"/hogelscope-* "$root/a folder/of it"
# shellcheck disable=SC2046  # one word a package
install $(sed -n '/apt-get install/,/^$/{s/.*apt-get install//; s/\\//; p}' \
  "$root/a folder/of it/README.txt")

mkdir -p "$root/sources/tests" "$root/sources/read"
cp -r data "$root/sources/"
cp -r tests/scenes "$root/sources/tests/"
for format in $formats; do
  [ "$format" = pgx ] ||
    oiiotool data/scene.png --resize 600x400 -o "$root/sources/read/scene.$format"
done
{ printf 'PG ML + 8 600 400\n' && tail -c 240000 "$root/sources/read/scene.bmp"; } \
  >"$root/sources/read/scene.pgx"
cat >"$root/jobs.sh" <<'JOBS'
set -eu
program=$1 sources=$2 output=$3
shift 3
job() { "$program" "$@" --quiet; }
table1=$sources/data/table1.json
for session in "$sources"/data/*.json "$sources"/tests/scenes/*.json; do
  job --render --masks --session "$session" --output "$output/${session#"$sources"}"
done
job --render --session "$table1" --states 'Fig 4' --format tif --output "$output/tif"
job --render --session "$table1" --states 'Fig 4' --format exr --output "$output/exr"
for format in jpg jp2 webp; do
  job --generate scene --session "$table1" --set 'display.hogels=[32,32]' --degrade jpeg:30 \
    --output "$output/degraded.$format"
done
job --stability --output "$output/stability"
for format; do
  job --render --session "$table1" --states 'Fig 4' --set 'display.hogels=[24,16]' \
    --set 'display.directions=[25,25]' --set "lightField.file=$sources/read/scene.$format" \
    --output "$output/of $format"
done
JOBS
# shellcheck disable=SC2086  # one word a format
sh "$root/jobs.sh" "$PWD/build/release/bin/hogelscope" "$root/sources" "$work/out" $formats
chown 1000:1000 "$root/home"
# shellcheck disable=SC2086
inside 1000:1000 sh /jobs.sh "/a folder/of it/bin/hogelscope" /sources /home/out $formats
# Letters are drawn by the system's libraries, and functions of its C library round otherwise.
diff -r -x 'stability.*' "$work/out" "$root/home/out" || fail "its files are not the build tree's"
[ -s "$root/home/out/stability/stability.png" ] || fail "stability.png is missing or empty"
plugins=$(inside 1000:1000 "/a folder/of it/bin/hogelscope" --plugins)
[ "$(echo "$plugins" | grep -c "^[a-z-]* *[0-9].*/a folder/")" -eq \
  "$(find "$root/a folder/of it" -name plugin.json | wc -l)" ] || {
  echo "$plugins" >&2
  fail "the program does not list all plugins of the tarball"
}
echo "$(find "$work/out" -type f | wc -l) files are equal to the build tree's"

# All that the window loads is there before the display server brings its own.
if inside 1000:1000 sh -c 'ldd "$0"/bin/* "$0"/lib/hogelscope/qt/*/*.so 2>/dev/null' \
  "/a folder/of it" | grep 'not found'; then fail "libraries of the window are missing"; fi
install xvfb
mkdir -m 1777 "$root/tmp/.X11-unix"
mkdir -m 777 "$root/screen"
# Xvfb starts black; 124: it ran until the time was over.
status=0
# shellcheck disable=SC2016  # expanded inside
inside 1000:1000 sh -c '
  Xvfb :7 -screen 0 1280x800x24 -nolisten tcp -fbdir /screen 2>/dev/null &
  sleep 3
  DISPLAY=:7 timeout 40 "$0" /sources/data/table1.json & sleep 35
  cp /screen/Xvfb_screen0 /screen/picture
  wait $!' "/a folder/of it/bin/hogelscope" >"$work/window.log" 2>&1 || status=$?
cat "$work/window.log"
[ $status -eq 124 ] || fail "the window ended with $status"
[ "$(tr -d '\000' <"$root/screen/picture" | wc -c)" -gt 2000000 ] || fail "the window's picture is black"
[ -z "${PICTURE-}" ] || cp "$root/screen/picture" "$PICTURE"
echo "The window runs in $suite."
