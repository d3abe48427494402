#!/usr/bin/env bash
# Builds and installs the library; not tested with conda.
set -euo pipefail
cmake -S . -B build/conda -G Ninja ${CMAKE_ARGS:-} -D CMAKE_BUILD_TYPE=Release -D CMAKE_INSTALL_PREFIX="$PREFIX" \
  -D CMAKE_INSTALL_LIBDIR=lib -D BEMPD_LINALG="${linalg:-suitesparse}" -D BEMPD_SCHEME_PAPER=ON -D BEMPD_BUILD_TESTS=OFF \
  -D BEMPD_BUILD_EXAMPLES=OFF -D BEMPD_BUILD_BENCHMARKS=OFF -D BEMPD_BUILD_FORTRAN=OFF -D BEMPD_INSTALL=ON
cmake --build build/conda --target bempd --parallel "${CPU_COUNT:-2}"
cmake --install build/conda
