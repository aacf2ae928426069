#!/bin/sh
# style.sh [HOOK ...]: what a reviewer need not say. Hooks: format, shell, spelling, clang; all without
# an argument. pre-commit runs them one by one (.pre-commit-config.yaml), check.sh all.
set -eu
cd "$(dirname "$0")/.."

format() {
  command -v clang-format-14 >/dev/null || {
    echo 'style.sh: the format is not checked: clang-format 14 is in Debian 12 alone'
    return
  }
  find plugins src tests \( -name '*.h' -o -name '*.cpp' -o -name '*.cxx' \) -print0 |
    xargs -0 clang-format-14 --dry-run -Werror
}
shell() {
  shellcheck --severity=warning .ci/run packaging/*.sh tests/benchmark/*.sh
  # Under set -e a test that stands alone ends the script without a word.
  if grep -nE '^ *(\[ .* \]|grep -q .*[^\])$' packaging/*.sh | grep -v '||'; then
    echo 'style.sh: these tests end a script without saying why: add || fail "..."' >&2
    exit 1
  fi
}
# The fuzzers need clang. To build one takes ten times as long as to read core and capture, which is
# where clang has refused what GCC takes; all of io takes three minutes more.
clang() {
  command -v clang++-14 >/dev/null || {
    echo 'style.sh: whether clang compiles core is not checked: clang 14 is in Debian 12 alone'
    return
  }
  find src/capture src/core -name '*.cpp' -print0 |
    xargs -0 -n 20 -P "$(nproc)" clang++-14 -std=c++20 -fsyntax-only -w -Isrc \
      -isystem /usr/include/opencv4 -DHOGELSCOPE_VERSION='""'
}
# Names of our own, and what tests misspell on purpose, in lower case.
names_and_mistakes=bu,dispaly,flie,fo,foundin,fro,hashin,idealy,infront,numberin,parametres,patern
names_and_mistakes=$names_and_mistakes,perview,positionof,reconstuction,sise,vews
spelling() {
  codespell --skip '*.png,*.ipynb,*/seeds/*' \
    --ignore-words-list="$names_and_mistakes" \
    ./*.md cmake docs packaging plugins resources/manual src tests
}

[ $# -gt 0 ] || set -- format shell spelling clang
for hook; do "$hook"; done
