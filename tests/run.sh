#!/usr/bin/env bash
# Builds and tests everything; installs missing Debian packages first.
#   tests/run.sh        with and without the scheme paper, both sparse backends, then the sanitizers in a host that fetches
#                       the library
#   tests/run.sh quick  the default backend only
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

case "${1:-all}" in
  all) stages=(ci ci-symmetric ci-eigen fetch-sanitize) ;;
  quick) stages=(ci) ;;
  *) echo "usage: tests/run.sh [quick]" >&2; exit 2 ;;
esac

# Debian's own tools before others of the same name: they see Debian's libraries and Python modules.
export PATH="/usr/bin:/bin:$PATH"
.ci/require_packages.sh cmake ninja-build gcc g++ pkg-config libeigen3-dev libsuitesparse-dev libopenblas-dev \
  libgtest-dev libbenchmark-dev python3 python3-numpy python3-matplotlib python3-meshio abigail-tools clang-format \
  python3-pycparser bindgen rustfmt cargo rustc gfortran valgrind dpkg-dev file \
  python3-cffi python3-pytest python3-pil mypy python3-pip python3-setuptools python3-wheel python3-venv

jobs=$(nproc)
summary=()
failed=0

# The presets in CMakePresets.json, here and in the host's folder, say what each stage is.
run_presets() { cmake --preset "$1" && cmake --build --preset "$1" -j "$jobs" && ctest --preset "$1" -j "$jobs"; }
run_stage() {
  case "$1" in
    ci) run_presets ci && cmake --build --preset ci --target format-check ;;
    fetch-sanitize) (cd tests/package/consumer && run_presets fetch-sanitize) ;;
    *) run_presets "$1" ;;
  esac
}

for stage in "${stages[@]}"; do
  printf '\n=== %s ===\n' "$stage"
  start=$SECONDS
  if run_stage "$stage"; then result=passed; else result=FAILED failed=1; fi
  summary+=("$stage $result ($((SECONDS - start)) s)")
done

printf '\n=== summary ===\n'
printf '%s\n' "${summary[@]}"
if [ "$failed" -ne 0 ]; then echo "tests FAILED"; else echo "all tests passed"; fi
exit "$failed"
