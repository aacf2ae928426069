#!/bin/sh
# style.sh [HOOK ...]: what a reviewer need not say. Hooks: format, shell, spelling; all without an
# argument. pre-commit runs them one by one (.pre-commit-config.yaml), check.sh all.
set -eu
cd "$(dirname "$0")/.."

format() {
  find plugins src tests \( -name '*.h' -o -name '*.cpp' -o -name '*.cxx' \) -print0 |
    xargs -0 clang-format-14 --dry-run -Werror
}
shell() { shellcheck --severity=warning .ci/run packaging/*.sh tests/benchmark/*.sh; }
# The words are names of our own, and what tests misspell on purpose.
spelling() {
  codespell --skip '*.png,*.ipynb,*/seeds/*' \
    --ignore-words-list=bu,dispaly,flie,fo,fro,parametres,patern,positionof,sise \
    ./*.md cmake docs packaging plugins resources/manual src tests
}

[ $# -gt 0 ] || set -- format shell spelling
for hook; do "$hook"; done
