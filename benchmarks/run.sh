#!/usr/bin/env bash
# Builds the library and runs a benchmark; results go to out/<name>/. Installs missing Debian packages first.
#   benchmarks/run.sh accuracy_cost                what accuracy costs, by every knob; peers that are installed take part
#   benchmarks/run.sh accuracy_cost --with-peers   installs FreeFem++, dolfinx and CalculiX first
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

name=${1:-}
if [ "$name" != accuracy_cost ] || { [ $# -gt 1 ] && [ "$2" != --with-peers ]; }; then
  sed -n '2,4s/^# *//p' benchmarks/run.sh >&2
  exit 2
fi
peers=()
[ $# -eq 1 ] || peers=(freefem++ python3-dolfinx calculix-ccx python3-gmsh)

# Debian's own tools before others of the same name: they see Debian's libraries and Python modules.
export PATH="/usr/bin:/bin:$PATH"
.ci/require_packages.sh cmake ninja-build gcc g++ libeigen3-dev libsuitesparse-dev libopenblas-dev libbenchmark-dev \
  python3 python3-cffi python3-numpy python3-matplotlib "${peers[@]}"

cmake --preset release -Wno-dev -D BEMPD_BUILD_BENCHMARKS=ON >/dev/null
cmake --build --preset release -j "$(nproc)" --target bempd bempd_kernel_rate

export BEMPD_LIBRARY="$root/build/release/src/capi/libbempd.so"
export BEMPD_KERNEL_RATE="$root/build/release/benchmarks/bempd_kernel_rate"
export BEMPD_OUTPUT="$root/out/$name"
export PYTHONPATH="$root/bindings/python" OMP_WAIT_POLICY=passive
/usr/bin/python3 "benchmarks/$name/run.py"
