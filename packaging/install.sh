#!/bin/sh
# install.sh LIST…: installs the Debian packages of the lists that are missing, one a line; as root, or
# with sudo. A package with a release behind it ("clang-format-14 bookworm") is for that one alone.
set -eu

# Names that installed packages have or provide: Debian 13's qt6-base-dev is libqt6opengl6-dev too.
# shellcheck disable=SC2016  # fields of dpkg-query
installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}, ${Provides}\n' |
  sed -n 's/^installed //p' | tr ',' '\n' | sed 's/^ *//; s/ .*//')
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
missing=
while read -r package only; do
  case $package in '' | '#'*) continue ;; esac
  case $only in '' | "$release") ;; *) continue ;; esac
  echo "$installed" | grep -Fqx "$package" || missing="$missing $package"
done <<EOF
$(cat "$@")
EOF
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
  as_root=sudo
  command -v sudo >/dev/null || {
    echo "install.sh: run it as root, or install sudo: missing are$missing" >&2
    exit 1
  }
fi
echo "Installing:$missing"
$as_root apt-get update -qq
# shellcheck disable=SC2086  # one word a package
$as_root env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends $missing >/dev/null
