#!/usr/bin/env bash
# Usage: linking_lines.sh ROOT INSTALLED LIBDIR WORK VERSION
# Runs the lines of docs/linking.md that compile and link with a library in a prefix of one's own, as they stand there, and the
# compile order of the Fortran sources as bindings/fortran/README.md has it.
set -euo pipefail
root=$1 installed=$2 libdir=$3 work=$4 version=$5
[ "$libdir" = lib ] || { echo "the lines are for lib; this build has $libdir"; libdir_shown=$libdir; }

# The lines do not quote what pkg-config says, and need not in a place without spaces.
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cp -r "$installed" "$place/prefix"
cd "$place"
cp "$root/tests/package/consumer/main.c" host.c
cp "$root/tests/package/consumer/main.f90" host.f90
export PREFIX=$place/prefix
unset LD_LIBRARY_PATH

# The code block of a page that has a line with these words.
block() { awk -v words="$2" '/^```sh/ { on = 1; text = ""; next } /^```/ { if (on && index(text, words)) printf "%s", text; on = 0 }
  on { text = text $0 "\n" }' "$1"; }

lines=$(block "$root/docs/linking.md" 'rpath="-Wl' | grep -v '^cmake')
[ "$(wc -l <<<"$lines")" -ge 4 ] || { echo "docs/linking.md has no such lines any more"; exit 1; }
lines=${lines//\/lib\/pkgconfig//${libdir_shown:-lib}/pkgconfig}
eval "set -e; $lines"
for program in ./host ./host_fortran; do
  said=$($program)
  echo "$program: $said"
  [ "$said" = "bempd $version" ] || { echo "expected 'bempd $version'"; exit 1; }
done

# The makefile of that page does the same.
awk '/^```make/ { on = 1; next } /^```/ { on = 0 } on' "$root/docs/linking.md" >Makefile
sed -i "s|/lib/pkgconfig|/${libdir_shown:-lib}/pkgconfig|" Makefile
env -u PKG_CONFIG_PATH make made_host made_host_fortran PREFIX="$PREFIX"
for program in ./made_host ./made_host_fortran; do
  said=$($program)
  [ "$said" = "bempd $version" ] || { echo "$program: expected 'bempd $version', came '$said'"; exit 1; }
done

lines=$(block "$root/bindings/fortran/README.md" 'bempd_support.f90')
[ -n "$lines" ] || { echo "bindings/fortran/README.md has no compile order any more"; exit 1; }
rm -f host_fortran ./*.mod
eval "set -e; $lines"
said=$(./host_fortran)
echo "from sources: $said"
[ "$said" = "bempd $version" ] || { echo "expected 'bempd $version'"; exit 1; }
mkdir -p "$work"
