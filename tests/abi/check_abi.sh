#!/usr/bin/env bash
# Usage: check_abi.sh LIBRARY [DESCRIPTION HEADER_FOLDER]
# Compares a library's binary interface with a stored description. Ends with
#   0   they agree
#   1   the interface changed and the description has to be renewed
#   2   programs linked with the old library would break, and the SONAME is still the old one
#   77  they could not be compared
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
library=$1
description=${2:-$here/bempd.abi}
headers=${3:-$here/../../include}

command -v abidiff >/dev/null || { echo "skipped: abidiff (package abigail-tools) is not installed"; exit 77; }
[ -f "$description" ] || { echo "skipped: no stored description yet; tests/abi/update.sh makes one"; exit 77; }

result=0
abidiff --drop-private-types --headers-dir2 "$headers" "$description" "$library" || result=$?
if [ "$result" -eq 0 ]; then
  echo "the binary interface is the stored one"
  exit 0
fi
if [ $((result & 3)) -ne 0 ]; then
  echo "abidiff failed"
  exit 1
fi

old=$(sed -n "s/.* soname='\([^']*\)'.*/\1/p" "$description" | head -n 1)
new=$(readelf -d "$library" | sed -n 's/.*(SONAME).*\[\(.*\)\]/\1/p')
# Additions are harmless; abidiff calls what else has changed a change of what was there.
added_only=$(abidiff --drop-private-types --headers-dir2 "$headers" --no-added-syms "$description" "$library" \
  >/dev/null && echo yes || echo no)
if [ "$added_only" = no ] && [ "$old" = "$new" ]; then
  echo "An existing function or type changed, but the SONAME is still $old: raise SOVERSION in src/capi/CMakeLists.txt."
  exit 2
fi
echo "The binary interface changed. If that is wanted, note it in CHANGELOG.md and renew the stored description with"
echo "tests/abi/update.sh."
exit 1
