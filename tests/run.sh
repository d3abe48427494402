#!/usr/bin/env bash
# Builds and tests everything; installs missing Debian packages first.
#   tests/run.sh        both sparse backends, then the sanitizers
#   tests/run.sh quick  the default backend only
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

case "${1:-all}" in
  all) stages=(ci ci-eigen sanitize) ;;
  quick) stages=(ci) ;;
  *) echo "usage: tests/run.sh [quick]" >&2; exit 2 ;;
esac

# Debian's own tools before others of the same name: they see Debian's libraries and Python modules.
export PATH="/usr/bin:/bin:$PATH"
.ci/require_packages.sh cmake ninja-build gcc g++ pkg-config libeigen3-dev libsuitesparse-dev libopenblas-dev \
  libgtest-dev libbenchmark-dev python3 python3-numpy python3-matplotlib python3-meshio abigail-tools clang-format \
  python3-pycparser bindgen rustfmt gfortran valgrind \
  python3-cffi python3-pil python3-pytest mypy python3-pip python3-venv python3-setuptools python3-wheel

jobs=$(nproc)
summary=()
failed=0

# The presets in CMakePresets.json say what each stage is.
run_stage() {
  cmake --preset "$1" && cmake --build --preset "$1" -j "$jobs" && ctest --preset "$1" -j "$jobs" || return 1
  [ "$1" != ci ] || cmake --build --preset ci --target format-check
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
