#!/usr/bin/env bash
# Builds the library and runs a benchmark; results go to out/<name>/. Installs missing Debian packages first.
#   benchmarks/run.sh accuracy_cost   what accuracy costs, by every knob; peers that are installed take part
#   benchmarks/run.sh speed [...]     what whole crack runs cost; options as in benchmarks/speed/README.md
#   benchmarks/run.sh fracture        stress intensity factors against references, into docs/research/tables
#   benchmarks/run.sh windows         what each number of the windows is worth, into docs/research/tables with --write
#   benchmarks/run.sh threads         a model for each of eight threads, with many threads of the BLAS and with one
#   benchmarks/run.sh directions      cracks in lattices against boundary elements and G0, into docs/research/tables
#   benchmarks/run.sh separation      where torn plates end, into docs/research/tables
#   benchmarks/run.sh compression     what breaks in bodies that are pressed, by criterion, into docs/research/tables
#   benchmarks/run.sh materials       lattices of any Poisson's ratio, into docs/research/tables
#   benchmarks/run.sh outlines        networks, accuracy and cost of any outline, into docs/research/tables with --write
#   benchmarks/run.sh mixed_cracks    cracks across borders of elements and lattices, into docs/mixed_cracks.md with --write
#   benchmarks/run.sh fatigue         lives of cracks under cycles against closed forms, into docs/fatigue.md with --write
#   benchmarks/run.sh line_loads      loads of lines against boundary elements on the same paths, into docs/cracks.md with --write
#   benchmarks/run.sh subdomains      large bodies of boundary elements, whole and cut, into docs/scaling.md with --write
#   benchmarks/run.sh bodies          bodies: errors wanted, told and true, promises, cost over size, into docs/bodies.md with --write
#   benchmarks/run.sh mpi             one body on several processes by MUMPS, and ensembles, into docs/scaling.md with --write
#   benchmarks/run.sh factorization   the library's own sparse factorization beside CHOLMOD's, into docs/research/tables
#   benchmarks/run.sh states          what saved states cost, in memory and as bytes, also beside other libraries
#   --with-peers, last, installs the peers first: FreeFem++, dolfinx and CalculiX; LAMMPS and dolfinx; or dolfinx (fracture, bodies)
set -euo pipefail
export BEMPD_TEST_HOOKS=1  # some compare with ways that the library does not choose by itself
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

name=${1:-}
case "$name" in
  accuracy_cost) programs=(bempd_kernel_rate) peers=(freefem++ python3-dolfinx calculix-ccx python3-gmsh) ;;
  speed) programs=(bempd_explicit_pd bempd_kernel_rate) peers=(lammps python3-dolfinx) ;;
  fracture) programs=() peers=(python3-dolfinx python3-gmsh) ;;
  threads) programs=() peers=() ;;
  windows) programs=() peers=() ;;
  directions) programs=() peers=() ;;
  separation) programs=() peers=() ;;
  compression) programs=(bempd_compression) peers=() ;;
  materials) programs=() peers=() ;;
  outlines) programs=(bempd_outlines) peers=() ;;
  mixed_cracks) programs=() peers=() ;;
  line_loads) programs=() peers=() ;;
  fatigue) programs=() peers=() ;;
  subdomains) programs=() peers=() ;;
  bodies) programs=() peers=(python3-dolfinx python3-gmsh) ;;
  mpi) programs=(bempd_mpi bempd_schur) peers=() ;;
  factorization) programs=(bempd_factorization) peers=() ;;
  states) programs=() peers=() ;;
  *) sed -n '2,21s/^# *//p' "$0" >&2; exit 2 ;;
esac
shift
if [ "${*: -1}" = --with-peers ]; then set -- "${@:1:$#-1}"; else peers=(); fi

# Debian's own tools before others of the same name: they see Debian's libraries and Python modules.
export PATH="/usr/bin:/bin:$PATH"
.ci/require_packages.sh cmake ninja-build gcc g++ libeigen3-dev libsuitesparse-dev libopenblas-dev libbenchmark-dev \
  python3 python3-cffi python3-numpy python3-matplotlib "${peers[@]}"
if [ "$name" = mpi ]; then .ci/require_packages.sh python3-mpi4py python3-distributed openmpi-bin libopenmpi-dev libmumps-dev; fi

if [ "$name" != windows ]; then  # which builds a library of its own
  cmake --preset release -Wno-dev -D BEMPD_BUILD_BENCHMARKS=ON -D BEMPD_COMPILE_TOGETHER=ON >/dev/null
  cmake --build --preset release -j "$(nproc)" --target bempd "${programs[@]}"
fi

export BEMPD_LIBRARY="$root/build/release/src/capi/libbempd.so"
export BEMPD_BENCHMARKS="$root/build/release/benchmarks"
export BEMPD_OUTPUT="$root/out/$name"
export PYTHONPATH="$root/bindings/python:$root/benchmarks" OMP_WAIT_POLICY=passive
/usr/bin/python3 "benchmarks/$name/run.py" "$@"
