#!/usr/bin/env bash
# Builds and tests everything; installs missing Debian packages first.
#   tests/run.sh        everything, also with the other sparse backend, and hosts under Valgrind: a quarter of an hour on two cores
#   tests/run.sh long   all of it, tests and cases that take long, the site of documents looked at in Chromium, the library
#                       without the scheme paper, then clang's sanitizers, in a host that fetches the library as well, threads,
#                       clang, the branches that tests take, and searches of an hour and more (BEMPD_FUZZ_SECONDS, 1800 for each fuzz target, BEMPD_SCENES, 20000,
#                       and BEMPD_ALLOCATIONS that fail in each call, 2000, 0 for all, shorten or lengthen them)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

case "${1:-all}" in
  all) stages=(ci) ;;
  long) stages=(ci cases site scenes backends memory ci-symmetric eigen fetch-sanitize sanitize tsan clang coverage fuzz) ;;
  *) echo "usage: tests/run.sh [long]" >&2; exit 2 ;;
esac

# Debian's own tools before others of the same name: they see Debian's libraries and Python modules.
export PATH="/usr/bin:/bin:$PATH"
.ci/require_packages.sh cmake ninja-build gcc g++ pkg-config libeigen3-dev libsuitesparse-dev libopenblas-dev \
  libgtest-dev libbenchmark-dev python3 python3-numpy python3-matplotlib python3-meshio python3-ezdxf python3-svgelements python3-yaml python3-jinja2 abigail-tools clang-format \
  clang libclang-rt-14-dev \
  python3-pycparser bindgen rustfmt cargo rustc gfortran valgrind dpkg-dev file \
  python3-mpi4py openmpi-bin libopenmpi-dev libmumps-dev python3-distributed python3-cffi python3-pytest python3-pil python3-vtk9 mypy python3-pip python3-setuptools python3-wheel python3-venv

# A program of MPICH embeds the library too; without MPICH that test says that it is skipped.
if [ "${1:-all}" = long ]; then .ci/require_packages.sh mpich libmpich-dev llvm; fi

# OpenBLAS 0.3.21 takes some new processors for a Prescott, whose routines are slow, and whose dsymv reads past the matrix:
# the address sanitizer ends the program there. Haswell's routines run on every processor with AVX2.
if [ -z "${OPENBLAS_CORETYPE:-}" ] && grep -q avx2 /proc/cpuinfo; then export OPENBLAS_CORETYPE=Haswell; fi

jobs=$(nproc)
fuzz_seconds=${BEMPD_FUZZ_SECONDS:-1800}
scenes=${BEMPD_SCENES:-20000}
allocations=${BEMPD_ALLOCATIONS:-2000}
summary=()
failed=0

# The presets in CMakePresets.json, here and in the host's folder, say what each stage is. The library's files are compiled
# together, but for the stage clang, which sees that each stands alone.
run_presets() {
  local settings=(-D BEMPD_COMPILE_TOGETHER=ON)
  case "$1" in
    clang) settings=(-D BEMPD_COMPILE_TOGETHER=OFF) ;;
    # GCC keeps what it no longer needs up to 1 GB: a ninth of the time for large files, and the same code.
    ci) settings+=(-D CMAKE_CXX_FLAGS="--param=ggc-min-heapsize=1000000") ;;
  esac
  cmake --preset "$1" "${settings[@]}" && cmake --build --preset "$1" -j "$jobs" && ctest --preset "$1" -j "$jobs"
}

# Python with the library of a build directory.
with_library() { PYTHONPATH="$root/bindings/python" BEMPD_LIBRARY="$root/build/$1/src/capi/libbempd.so" "${@:2}"; }

# Each from the corpus and from what earlier searches added to it; what they find stays in build/fuzz.
search_by_fuzzing() {
  local target work
  for target in calls state; do
    work=build/fuzz/$target
    mkdir -p "$work/corpus" "$work/findings"
    OPENBLAS_NUM_THREADS=1 build/sanitize/tests/fuzz/fuzz_$target -max_total_time="$fuzz_seconds" -timeout=120 \
      -rss_limit_mb=3000 -print_final_stats=1 -artifact_prefix="$work/findings/" "$work/corpus" \
      "tests/fuzz/corpus/$target" || return 1
  done
}

run_stage() {
  case "$1" in
    ci) run_presets ci && cmake --build --preset ci --target format-check ;;
    fetch-sanitize) (cd tests/package/consumer && run_presets fetch-sanitize) ;;
    cases) ctest --preset long -j "$jobs" ;;
    site) BEMPD_LIBRARY="$root/build/ci/src/capi/libbempd.so" docs/build.sh look ;;
    scenes) with_library ci python3 tests/differential/random_scenes.py --count "$scenes" &&
      with_library ci python3 tests/differential/random_scenes.py --lines --count "$((scenes / 10))" &&
      for contact in faces none; do
        with_library ci python3 tests/differential/pressed_plates.py --contact "$contact" --count "$((scenes / 10))" || return 1
      done &&
      with_library ci python3 tests/differential/properties.py --count "$((scenes / 20))" ;;
    backends) cmake --preset ci -B build/eigen -D BEMPD_LINALG=eigen && cmake --build build/eigen -j "$jobs" --target bempd &&
      python3 tests/differential/backends.py build/ci/src/capi/libbempd.so build/eigen/src/capi/libbempd.so \
        --count "$((scenes / 20))" ;;
    memory) OPENBLAS_NUM_THREADS=1 build/ci/tests/memory/failing_allocations --most "$allocations" &&
      OPENBLAS_NUM_THREADS=1 build/ci/tests/memory/address_limit all ;;
    coverage) python3 tests/coverage/coverage.py run ;;
    fuzz) search_by_fuzzing ;;
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
