#!/usr/bin/env bash
# Usage: check_symbols.sh LIBBEMPD LIBBEMPD_MPI INCLUDE_FOLDER suitesparse|eigen
# libbempd needs nothing of MPI or MUMPS; libbempd_mpi exports the functions of its header alone; one header includes mpi.h. With
# Eigen's factorization nothing of SuiteSparse, which is under the GPL, is needed.
set -euo pipefail
core=$1 mpi=$2 include=$3 linalg=$4
failed=0
fail() { echo "$1"; failed=1; }

of_mpi='[ _]P?MPI_|mumps|ompi_|opal_'
if nm -D "$core" | grep -Ei "$of_mpi"; then fail "libbempd has symbols of MPI or MUMPS"; fi
if readelf -d "$core" | grep NEEDED | grep -Ei 'mpi|mumps|scalapack'; then fail "libbempd needs libraries of MPI or MUMPS"; fi
if ldd "$core" | grep -Ei 'libmpi|mumps|scalapack'; then fail "what libbempd needs needs MPI or MUMPS"; fi

exported=$(nm -D --defined-only "$mpi" | awk '{ print $NF }' | LC_ALL=C sort -u)
declared=$(grep -E '^BEMPD_API' "$include/bempd_mpi.h" | grep -oE '\bbempd_mpi_[a-z_]+\(' | tr -d '(' | LC_ALL=C sort -u)
[ -n "$declared" ] || fail "bempd_mpi.h declares nothing"
[ "$exported" = "$declared" ] || { diff <(echo "$declared") <(echo "$exported") || true; fail "libbempd_mpi exports other functions (>) than its header declares (<)"; }
nm -D "$mpi" | grep ' U dmumps_c' >/dev/null || fail "libbempd_mpi does not call MUMPS: the test would see nothing"
if ldd "$mpi" | grep -E 'mumps_seq|mpiseq'; then fail "libbempd_mpi uses the sequential MUMPS"; fi

if [ "$linalg" = eigen ] && ldd "$mpi" | grep -E 'cholmod|umfpack'; then fail "libbempd_mpi needs SuiteSparse"; fi

with_mpi=$(grep -lE '# *include *<mpi' "$include"/*.h* || true)
[ "$with_mpi" = "$include/bempd_mpi.h" ] || fail "these headers include mpi.h: $with_mpi"
[ $failed = 0 ] && echo "libbempd is free of MPI and MUMPS; libbempd_mpi exports $(wc -w <<<"$declared") functions"
exit $failed
