#!/usr/bin/env bash
# Usage: check_exports.sh LIBRARY HEADER C_COMPILER
# The defined dynamic symbols (weak and unique ones included) must be exactly the functions that the header declares.
set -euo pipefail
library=$1 header=$2 compiler=$3

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
nm -D --defined-only "$library" | awk '{ print $NF }' | LC_ALL=C sort -u >"$work/exported"
[ -s "$work/exported" ] || { echo "$library exports nothing"; exit 1; }

# GCC lists the prototypes it has seen, each behind a comment with its place.
if "$compiler" -x c -std=c99 -fsyntax-only -aux-info "$work/prototypes" "$header" 2>/dev/null && [ -f "$work/prototypes" ]
then
  sed -nE 's@^/\* .*/bempd\.h:[0-9]+:[A-Z]+ \*/ [^(]*[ *](bempd_[a-z0-9_]+) \(.*@\1@p' "$work/prototypes" |
    LC_ALL=C sort -u >"$work/declared"
else
  echo "$compiler cannot list prototypes: only the names are checked"
  grep '^bempd_' "$work/exported" >"$work/declared"
fi

if ! diff --label declared --label exported -u "$work/declared" "$work/exported"; then
  echo "the exported symbols (+) differ from the functions declared in bempd.h (-)"
  exit 1
fi
echo "$(wc -l <"$work/exported") functions are exported, all declared"
