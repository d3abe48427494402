#!/usr/bin/env bash
# Usage: check_abi.sh LIBRARY
# Compares the binary interface with the stored description; 77 means that it could not be compared.
set -euo pipefail
library=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

command -v abidiff >/dev/null || { echo "skipped: abidiff (package abigail-tools) is not installed"; exit 77; }
[ -f "$here/bempd.abi" ] || { echo "skipped: no stored description yet; tests/abi/update.sh makes one"; exit 77; }

if ! abidiff --drop-private-types --headers-dir2 "$here/../../include" "$here/bempd.abi" "$library"; then
  echo "The binary interface changed. If that is wanted: note it in CHANGELOG.md, raise SOVERSION if an existing function"
  echo "or type changed, and renew the stored description with tests/abi/update.sh."
  exit 1
fi
echo "the binary interface is the stored one"
