#!/usr/bin/env bash
# Renews the stored description of the binary interface, tests/abi/bempd.abi.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"

cmake --preset ci
cmake --build --preset ci --target bempd
abidw --no-corpus-path --no-comp-dir-path --no-show-locs --no-elf-needed --drop-private-types --headers-dir include --exported-interfaces-only \
  --out-file tests/abi/bempd.abi build/ci/src/capi/libbempd.so
sed -i "s@path='$root/@path='@" tests/abi/bempd.abi
git --no-pager diff --stat -- tests/abi/bempd.abi 2>/dev/null || true
