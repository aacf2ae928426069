#!/bin/sh
# check_files.sh [BUILD]: checks the built packages as files, without installing them: lintian, the
# desktop file, the metainfo, the MIME type, the man page, and that jobs do not need the window's
# libraries.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=${1:-$here/../build/release}
cd "$build"
fail() { echo "check_files.sh: $*" >&2; exit 1; }

lintian --fail-on error,warning --suppress-tags bad-distribution-in-changes-file \
  --allow-root packages/*.deb || fail "lintian complains"
for heavy in libvtk libqt6widgets; do
  if dpkg-deb -f packages/hogelscope_*.deb Depends | grep -E "(^| )$heavy"; then
    fail "the package hogelscope depends on $heavy"
  fi
done
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
for package in packages/*.deb; do dpkg-deb -x "$package" "$root"; done
share=$root/usr/share
app=io.github.hogelscope.Hogelscope
desktop-file-validate "$share/applications/$app.desktop"
appstreamcli validate --no-net --pedantic "$share/metainfo/$app.metainfo.xml"
cp -r "$share/mime" "$root/mime"
XDG_DATA_DIRS=$root update-mime-database "$root/mime"
grep -q '^application/vnd.hogelscope.session+json:\*.hogelscope$' "$root/mime/globs" ||
  fail "the MIME type of sessions is not registered"
warnings=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z \
  "$share/man/man1/hogelscope.1.gz" 2>&1 >/dev/null)
[ -z "$warnings" ] || fail "hogelscope.1: $warnings"
bash -n "$share/bash-completion/completions/hogelscope"
