#!/usr/bin/env bash
# Usage: host_of_mpich.sh LIBBEMPD SOURCE_FOLDER WORK_FOLDER
# A program built with MPICH embeds the library, although MUMPS and libbempd_mpi are built for Open MPI: three ranks with
# models of their own print what one rank prints.
set -euo pipefail
library=$1 source=$2 work=$3/mpich
for program in mpicc.mpich mpirun.mpich; do
  command -v "$program" >/dev/null || { echo "skipped: $program is missing; it is in Debian's packages mpich and libmpich-dev"; exit 77; }
done
mkdir -p "$work"
folder=$(dirname "$library")
mpicc.mpich -std=c99 -O1 -I "$source/include" "$source/examples/mpi_study/study.c" -o "$work/study" -L "$folder" -lbempd -lm "-Wl,-rpath,$folder"
linked=$(ldd "$work/study")
grep -q libmpich <<<"$linked" || { echo "the program is not one of MPICH"; exit 1; }
if grep -E 'libmpi\.so|libopen-|mumps|libbempd_mpi' <<<"$linked"; then echo "Open MPI or MUMPS came along"; exit 1; fi
export OPENBLAS_NUM_THREADS=1
one=$(mpirun.mpich -np 1 "$work/study" 6)
three=$(mpirun.mpich -np 3 "$work/study" 6)
echo "$three"
[ "$(wc -l <<<"$three")" = 7 ] && grep -q 'of 6 plates' <<<"$three" && [ "$one" = "$three" ]
