#!/usr/bin/env bash
# Usage: rust_lines.sh ROOT INSTALLED LIBDIR WORK VERSION CARGO
# Does with Cargo what docs/linking.md and bindings/rust/README.md say, as it stands there: dependencies, build script, flags, and
# the ways in which the library is found when programs are built and when they run.
set -euo pipefail
root=$1 installed=$2 libdir=$3 work=$4 version=$5 cargo=$6

# Flags are separated by blanks, so the library lies in a place without.
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cp -r "$installed" "$place/prefix"
folder=$place/prefix/$libdir
mkdir -p "$place/host/src" "$work"
cd "$place/host"
ln -s "$root/bindings" bindings
cp "$root/tests/package/cargo_consumer/src/main.rs" src/main.rs
export CARGO_HOME=$work/home CARGO_TARGET_DIR=$work/target
unset LD_LIBRARY_PATH BEMPD_LIB_DIR PKG_CONFIG_PATH RUSTFLAGS
page=$root/bindings/rust/README.md

# The code block of a page in some language that has these words, without the blanks that it is indented by.
block() { awk -v kind="$2" -v words="$3" '$1 == "```" kind { on = 1; text = ""; next } $1 == "```" { if (on && index(text, words)) printf "%s", text; on = 0 }
  on { sub(/^  /, ""); text = text $0 "\n" }' "$1"; }

# Fills in the paths that a reader has to fill in.
filled() { sed -e "s|/path/to/bempd|$root|g" -e "s|/folder/of/the/library|$folder|g"; }

manifest() { printf '[package]\nname = "host"\nversion = "0.1.0"\nedition = "2021"\n\n%s\n' "$1" >Cargo.toml; }

runs() {
  local said libraries
  "$cargo" build --offline --quiet
  said=$(env "${@:2}" "$CARGO_TARGET_DIR/debug/host")
  echo "$1: $said"
  [ "$said" = "bempd $version" ] || { echo "expected 'bempd $version'"; exit 1; }
  libraries=$(env "${@:2}" ldd "$CARGO_TARGET_DIR/debug/host")
  [[ $libraries == *"$folder/libbempd"* ]] || { echo "it runs with another library: $libraries"; exit 1; }
}

line=$(grep -o '`bempd = { path = "bindings/rust/bempd" }`' "$root/docs/linking.md" | tr -d '`')
[ -n "$line" ] || { echo "docs/linking.md has no such line any more"; exit 1; }
manifest "[dependencies]
$line"
path=$(grep -o '`LD_LIBRARY_PATH=/folder/of/the/library`' "$page" | tr -d '`' | filled)
[ -n "$path" ] || { echo "bindings/rust/README.md has no LD_LIBRARY_PATH any more"; exit 1; }
BEMPD_LIB_DIR=$folder runs "docs/linking.md, BEMPD_LIB_DIR, LD_LIBRARY_PATH" "$path"

flags=$(grep -o '`RUSTFLAGS="[^`]*`' "$page" | tr -d '`' | filled)
[ -n "$flags" ] || { echo "bindings/rust/README.md has no RUSTFLAGS any more"; exit 1; }
export PKG_CONFIG_PATH=$folder/pkgconfig
(eval "export $flags"; runs "pkg-config, RUSTFLAGS")
mkdir .cargo
(eval "$flags"; printf '[build]\nrustflags = "%s"\n' "$RUSTFLAGS" >.cargo/config.toml)
runs "pkg-config, .cargo/config.toml"
rm -r .cargo

manifest "$(block "$page" toml 'bempd-sys = ' | filled)"
block "$page" rust 'DEP_BEMPD_LIB_DIR' >build.rs
[ -s build.rs ] || { echo "bindings/rust/README.md has no build script any more"; exit 1; }
runs "pkg-config, build.rs"
