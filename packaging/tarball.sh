#!/bin/sh
# tarball.sh: makes build/release/packages/hogelscope-VERSION-x86_64.tar.zst: the programs with all
# libraries that they need, which run from any folder of a Linux that is not older than Debian 12,
# without installing; not the Python package. Installs Debian's patchelf and zstd.
set -eu
here=$(dirname "$0")
printf '%s\n' patchelf zstd | "$here/install.sh" /dev/stdin
"$here/build.sh" hogelscope_installed
cd "$here/.."

version=$(sed -n 's/^CMAKE_PROJECT_VERSION:.*=//p' build/release/CMakeCache.txt)
name=hogelscope-$version-$(uname -m)
work=$PWD/build/release/tarball
top=$work/$name
lib=$top/lib/hogelscope/lib
absent=libhogelscope-absent.so
rm -rf "$work"
mkdir -p "$work"
umask 022

# The system's: what goes with its kernel, its graphics driver and its X server, and what these
# load too, of which the newer must win. libstdc++ and libgcc_s are those of the system since its
# driver may need newer ones than Debian 12's, and newer ones still have all that was in older ones.
isSystems() {
  case $1 in
    libc.so.6 | libm.so.6 | libdl.so.2 | librt.so.1 | libpthread.so.0 | libresolv.so.2) ;;
    ld-linux*.so.* | libstdc++.so.6 | libgcc_s.so.1 | libz.so.1 | libexpat.so.1) ;;
    libEGL.so.1 | libGL.so.1 | libGLX.so.0 | libOpenGL.so.0 | libGLdispatch.so.0) ;;
    libdrm.so.2 | libgbm.so.1 | libwayland-*) ;;
    libX11.so.6 | libX11-xcb.so.1 | libXext.so.6 | libXfixes.so.3 | libICE.so.6 | libSM.so.6) ;;
    libxcb.so.1 | libxcb-dri[23].so.0 | libxcb-glx.so.0 | libxcb-present.so.0) ;;
    libxcb-randr.so.0 | libxcb-shm.so.0 | libxcb-sync.so.1 | libxcb-xfixes.so.0) ;;
    libfontconfig.so.1 | libfreetype.so.6) ;;
    *) return 1 ;;
  esac
}

# What the bundled libraries want for things that Hogelscope never asks of them: half of all
# libraries. All of Debian's libraries bind every function when they are loaded, so $absent has to
# have them; it says "no" to whoever calls one. It has a name of its own, or the system's driver
# would be given it in place of the library.
isAbsent() {
  case $1 in
    # OpenCV's, which is here for JPEG and for arithmetic: maps, medical pictures, neural networks.
    libgdal.so.* | libgdcm* | libopencv_dnn.so.*) ;;
    # OpenImageIO's: cameras, and volumes, which are no pictures.
    libopencv_videoio.so.* | libopenvdb.so.*) ;;
    # VTK's: a way to move around that is not used, with all of MPI.
    libvtkFiltersExtraction-*) ;;
    # FFmpeg's, which is here to read videos: encoders, second decoders, speech, drawings, the
    # decoders of graphics cards, the network.
    libx26[45].so.* | libSvtAv1Enc.so.* | librav1e.so.* | libxvidcore.so.*) ;;
    libaom.so.* | libvpx.so.* | libjxl* | libcodec2.so.*) ;;
    librsvg-2.so.* | libcairo.so.* | libgobject-2.0.so.*) ;;
    libOpenCL.so.* | libmfx.so.* | libva.so.* | libva-*.so.* | libvdpau.so.*) ;;
    libbluray.so.* | libgnutls.so.* | librabbitmq.so.* | librist.so.*) ;;
    libsrt-* | libssh-* | libxml2.so.* | libzmq.so.*) ;;
    # HDF5's: files in clouds. D-Bus's: being a service.
    libcurl.so.* | libcrypto.so.* | libsystemd.so.*) ;;
    *) return 1 ;;
  esac
}

needed() { readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'; }

# symbols FILE: its dynamic symbols: yes or no for whether it defines it, type, bytes, name.
symbols() {
  readelf --dyn-syms -W "$1" | awk '$1 ~ /^[0-9]+:$/ && $8 != "" {
    sub("@@", "@", $8); print ($7 == "UND" ? "no" : "yes"), $4, $3, $8 }'
}

for component in program window libraries; do
  cmake --install build/release --prefix "$top" --strip --component $component
done >"$work/install.log"
rm -f "$lib"/libhogelscope_vtk*  # for programs of others
plugins=$top/lib/hogelscope/qt
mkdir -p "$plugins"
qt=$(dirname "$(ldd "$top/bin/hogelscope" | awk '$1 ~ /^libQt6Core/ { print $3 }')")/qt6/plugins
for plugin in platforms/libqxcb platforms/libqoffscreen xcbglintegrations/libqxcb-glx-integration \
  xcbglintegrations/libqxcb-egl-integration imageformats/libqsvg imageformats/libqjpeg \
  iconengines/libqsvgicon platforminputcontexts/libcomposeplatforminputcontextplugin \
  platforminputcontexts/libibusplatforminputcontextplugin; do
  mkdir -p "$plugins/$(dirname $plugin)"
  cp "$qt/$plugin.so" "$plugins/$plugin.so"
  readlink -f "$qt/$plugin.so" >>"$work/copied"
done
printf '[Paths]\nPrefix = ..\nPlugins = lib/hogelscope/qt\n' >"$top/bin/qt.conf"

# The queue grows while it is read.
find "$top/bin" "$top/lib" -type f \( -name '*.so*' -o -perm -u+x \) >"$work/queue"
cp "$work/queue" "$work/roots"
xargs -d '\n' ldd <"$work/roots" | awk '$2 == "=>" { print $1, $3 }' | sort -u >"$work/found"
while read -r file; do
  for library in $(needed "$file"); do
    if isSystems "$library"; then
      echo "$library" >>"$work/systems"
      continue
    fi
    from=$(awk -v name="$library" '$1 == name { print $2; exit }' "$work/found")
    [ -n "$from" ] || { echo "tarball.sh: $library of $file is not installed" >&2; exit 1; }
    if isAbsent "$library"; then
      { symbols "$file"; symbols "$from"; } | awk '
        $1 == "no" { wanted[$4] = 1 }
        $1 == "yes" && $4 in wanted { print $2, $3, $4 }' >>"$work/absent"
      patchelf --replace-needed "$library" $absent "$file"
    elif [ ! -e "$lib/$library" ]; then
      cp "$from" "$lib/$library"
      readlink -f "$from" >>"$work/copied"
      echo "$lib/$library" >>"$work/queue"
    fi
  done
done <"$work/queue"

# C functions answer 0, which is NULL, false or none; those of C++ may return anything: they throw.
sort -u -o "$work/absent" "$work/absent"
awk 'BEGIN {
    print "#include <stdexcept>"
    print "[[noreturn]] static void absent() {"
    print "  throw std::runtime_error(\"needs a library that this tarball leaves out\");"
    print "}"
  }
  { split($3, name, "@") }
  $1 == "OBJECT" { printf "extern char a%d[] __asm__(\"%s\");\nchar a%d[%d];\n", NR, name[1], NR, $2
    next }
  { isCpp = name[1] ~ /^_Z/
    printf "long a%d() __asm__(\"%s\");\nlong a%d() { %s; }\n", NR, name[1], NR,
      isCpp ? "absent()" : "return 0" }' "$work/absent" >"$work/absent.cpp"
# Whoever was linked with versions of symbols wants them.
awk '{ split($3, name, "@") }
  name[2] != "" { of[name[2]] = of[name[2]] " " name[1] ";" }
  END { for (version in of) print version " { global:" of[version] " };" }' \
  "$work/absent" | sort >"$work/absent.map"
g++ -shared -fPIC -Os -s -o "$lib/$absent" -Wl,-soname,$absent -Wl,-z,now \
  -Wl,--version-script="$work/absent.map" "$work/absent.cpp"

# RUNPATH, not RPATH: the latter would also be the system's graphics driver's. Not in one command
# with replacing names: patchelf 0.14 then writes one of them into the other's place.
while read -r file; do
  patchelf --set-rpath "\$ORIGIN/$(realpath --relative-to="$(dirname "$file")" "$lib")" "$file"
done <"$work/queue"
find "$top/lib" -name plugin.json | while read -r json; do
  folder=$(dirname "$json")
  bytes=$(stat -c %s "$folder/$(basename "$folder").so")
  sed -i "s/\"bytes\": [0-9]*/\"bytes\": $bytes/" "$json"
done

# No function without a library; none of this machine but the system's and what those load.
xargs -d '\n' ldd -r <"$work/roots" >"$work/ldd" 2>&1 || true
if grep -E 'not found|undefined symbol|no version information' "$work/ldd"; then
  echo "tarball.sh: libraries of the tarball lack what these lines name" >&2
  exit 1
fi
while read -r file; do needed "$file"; done <"$work/queue" | sort -u | while read -r library; do
  isSystems "$library" && continue
  others=$(awk -v name="$library" '$1 == name { print $3 }' "$work/ldd" | grep -v "^$top/" || true)
  [ -e "$lib/$library" ] && [ -z "$others" ] && continue
  echo "tarball.sh: $library is not that of the tarball: $others" >&2
  exit 1
done

packageOf() { dpkg-query -S "$1" 2>/dev/null || dpkg-query -S "${1#/usr}"; }
while read -r file; do packageOf "$file"; done <"$work/copied" | sed 's/: .*//' >"$work/packages"
echo nlohmann-json3-dev >>"$work/packages"  # compiled in
mkdir "$top/licenses"
cp LICENSE "$top/licenses/hogelscope"
cp -r /usr/share/common-licenses "$top/licenses/"
sort -u "$work/packages" | while read -r package; do
  dpkg-query -W -f '${Package} ${Version} of ${source:Package} ${source:Version}\n' "$package"
  cp -L "/usr/share/doc/${package%:*}/copyright" "$top/licenses/${package%:*}"
done >"$top/licenses/packages.txt"

# What the files want of the system.
newest() {
  xargs -d '\n' readelf -V -W <"$work/queue" | sed -n "s/.*Name: \($1_[0-9.]*\) .*/\1/p" |
    sort -uV | tail -1
}
systems=$(awk 'NR == FNR { wanted[$1]; next } $1 in wanted { print $2 }' \
  "$work/systems" "$work/found" |
  while read -r file; do packageOf "$(readlink -f "$file")"; done | sed 's/:.*//' |
  grep -Ev '^(libc6|libgcc-s1|libstdc\+\+6|zlib1g)$' | sort -u | tr '\n' ' ')
{
  cat <<TEXT
Hogelscope $version

Simulates what a viewer sees of a light field display. Nothing has to be installed: this folder can
lie anywhere, and is all that there is. To start the window and batch mode:

    bin/hogelscope
    bin/hogelscope --help
    bin/hogelscope --render --session share/hogelscope/samples/table1.hogelscope --output views

The system has to be Linux on $(uname -m), with
$(newest GLIBC) in its C library and $(newest GLIBCXX) in its libstdc++,
as Debian 12 has and all that is newer. Any desktop has the rest: OpenGL, the X11 libraries,
fontconfig and a font. A machine without a desktop may lack them; batch mode needs no X server, but
is linked with these libraries too. In Debian and Ubuntu they are

TEXT
  echo "sudo apt-get install $systems" | fold -s -w 96 | sed 's/ $//; $!s/$/ \\/; s/^/    /'
  cat <<TEXT

For videos that it writes Hogelscope calls ffmpeg, if that is installed. The Python package is not
in here.

The libraries in lib/hogelscope/lib are those of Debian, changed only in where they look for other
libraries, and in that they do without some; licenses has the licence of each, and packages.txt
there their versions, of which snapshot.debian.org has the sources. FFmpeg's, as Debian makes them,
are under the GPL, so this folder as a whole is too; Hogelscope itself is under the BSD licence in
licenses/hogelscope.
TEXT
} >"$top/README.txt"

mkdir -p build/release/packages
output=build/release/packages/$name.tar.zst
tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner --format=gnu \
  --mtime="@${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}" -cf - "$name" |
  zstd -q -f -19 --long=25 -T0 -o "$output"
echo "$output: $(find "$lib" -name '*.so*' | wc -l) libraries, $(du -sm "$top" | cut -f1) MB," \
  "$(du -m "$output" | cut -f1) MB compressed"
