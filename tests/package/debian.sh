#!/usr/bin/env bash
# Usage: debian.sh BUILD_FOLDER WORK_FOLDER C_COMPILER CONSUMER_SOURCE EXPECTED
# Makes the Debian packages, installs them into a root of their own, uses them from there and removes them again.
set -euo pipefail
build=$1 work=$2 compiler=$3 consumer=$4 expected=$5
root=$work/root

rm -rf "$work"
mkdir -p "$work" "$root"/var/lib/dpkg/{info,updates,triggers}
touch "$root/var/lib/dpkg/status"
cd "$work"
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work" >cpack.log || { cat cpack.log; exit 1; }
ls -- *.deb
expected_packages=3
if [ -e "$build/src/mpi/libbempd_mpi.so" ]; then expected_packages=4; fi
[ "$(ls -- *.deb | wc -l)" -eq $expected_packages ] || { echo "expected $expected_packages packages"; exit 1; }
for package in *.deb; do dpkg-deb --field "$package" Package Depends; done

# MPI and MUMPS are needed by the package of libbempd_mpi alone.
for package in *.deb; do
  needs=$(dpkg-deb --field "$package" Depends)
  case $package in
    libbempd-mpi0_*)
      grep -q libmumps <<<"$needs" && grep -q libopenmpi <<<"$needs" && grep -q 'libbempd0 (=' <<<"$needs" ||
        { echo "$package needs: $needs"; exit 1; } ;;
    *) if grep -E 'mumps|mpi' <<<"$needs"; then echo "$package needs MPI or MUMPS"; exit 1; fi ;;
  esac
done

# The packages' scripts run outside of the root, where they must find a harmless ldconfig.
mkdir bin
printf '#!/bin/sh\necho ldconfig >>"%s/called"\n' "$work" >bin/ldconfig
chmod +x bin/ldconfig
export PATH="$work/bin:$PATH"
in_root=(dpkg "--root=$root" "--log=$work/dpkg.log" --force-not-root --force-depends --force-script-chrootless)
files() { (cd "$root" && find . -path ./var -prune -o -print | LC_ALL=C sort); }
files >before
"${in_root[@]}" --install ./*.deb >install.log 2>&1 || { cat install.log; exit 1; }

[ "$(wc -l <called)" -eq $((expected_packages - 2)) ] || { echo "the linker's cache is not told of the library"; exit 1; }

library=$(dirname "$(find "$root/usr" -name 'libbempd.so')")
export LD_LIBRARY_PATH=$library PKG_CONFIG_PATH=$library/pkgconfig PKG_CONFIG_SYSROOT_DIR=
# shellcheck disable=SC2046 # flags are words
"$compiler" -std=c99 "$consumer" $(pkg-config --cflags --libs bempd) -o consumer
for program in ./consumer "/usr/bin/python3 -c 'import bempd; print(\"bempd\", bempd.__version__)'"; do
  said=$(env -u BEMPD_LIBRARY PYTHONPATH="$root/usr/lib/python3/dist-packages" PYTHONDONTWRITEBYTECODE=1 sh -c "$program")
  echo "$program: $said"
  [ "$said" = "$expected" ] || { echo "expected '$expected'"; exit 1; }
done

# pip knows it, and its documents are there.
modules=$root/usr/lib/python3/dist-packages
listed=$(/usr/bin/python3 -m pip --disable-pip-version-check list --path "$modules" --format freeze | sed 's/==/ /')
echo "pip: $listed"
[ "$listed" = "$expected" ] || { echo "expected pip to list '$expected'"; exit 1; }
for document in README.md CHANGELOG.md copyright examples/first_crack/main.py; do
  [ -s "$root/usr/share/doc/python3-bempd/$document" ] || { echo "python3-bempd has no $document"; exit 1; }
done

"${in_root[@]}" --purge $(dpkg "--root=$root" --force-not-root --get-selections | awk '{ print $1 }') >remove.log 2>&1 ||
  { cat remove.log; exit 1; }
files >after
diff before after || { echo "removing the packages left these files behind"; exit 1; }
echo "installed and removed without a trace"
