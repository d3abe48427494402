#!/usr/bin/env bash
# Builds the library and runs examples; results go to out/<name>/. Installs missing Debian packages first.
#   examples/run.sh            runs centre_crack
#   examples/run.sh NAME...    runs the examples named
#   examples/run.sh NAME... --full  with all cases, of examples that have more than they run otherwise
#   examples/run.sh paper-tables  runs the paper's six examples and prints one table of all cases
#   examples/run.sh --list     lists them
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

list_examples() {
  local folder
  for folder in $(dirname examples/*/main.{c,f90,py} | sort -u); do
    printf '%-24s %s\n' "$(basename "$folder")" "$(head -n 1 "$folder/README.md" 2>/dev/null | sed 's/^#* *//')"
  done
}

case "${1:-}" in
  --list) list_examples; exit 0 ;;
  -h | --help) sed -n '2,7s/^# *//p' "examples/run.sh"; exit 0 ;;
esac

extent=()
if [ "${!#}" = --full ] && [ $# -gt 1 ]; then
  extent=(--full)
  set -- "${@:1:$#-1}"
fi
[ $# -gt 0 ] || set -- centre_crack
tables=no
if [ "$1" = paper-tables ]; then
  tables=yes
  set -- tension shear stretching centre_crack mixed_mode_crack two_edge_cracks
fi
targets=()
packages=()
for name in "$@"; do
  if [[ ! $name =~ ^[a-z0-9_]+$ || ! ( -f examples/$name/main.c || -f examples/$name/main.f90 || -f examples/$name/main.py ) ]]; then
    echo "error: there is no example '$name'; there are:" >&2
    list_examples >&2
    exit 2
  fi
  if [ -f "examples/$name/main.c" ]; then
    targets+=("example_$name")
  elif [ -f "examples/$name/main.f90" ]; then
    targets+=("example_$name")
    packages+=(gfortran)
  else
    targets+=(bempd)
    packages+=(python3-cffi)
  fi
done

# Debian's own tools before others of the same name: they see Debian's libraries and Python modules.
export PATH="/usr/bin:/bin:$PATH"
.ci/require_packages.sh cmake ninja-build gcc g++ libeigen3-dev libsuitesparse-dev libopenblas-dev \
  python3 python3-numpy python3-matplotlib python3-meshio "${packages[@]}"

cmake --preset release -Wno-dev >/dev/null
cmake --build --preset release -j "$(nproc)" --target "${targets[@]}"

# The systems here are too small for threads of the BLAS, which take time from each other; the library's own loops use all
# cores.
export OPENBLAS_NUM_THREADS="${OPENBLAS_NUM_THREADS:-1}"
for name in "$@"; do
  mkdir -p "out/$name"
  if [ ! -f "examples/$name/main.c" ] && [ ! -f "examples/$name/main.f90" ]; then
    BEMPD_LIBRARY="$root/build/release/src/capi/libbempd.so" PYTHONPATH="$root/bindings/python" \
      /usr/bin/python3 "examples/$name/main.py" "${extent[@]}"
    continue
  fi
  "build/release/examples/example_$name" | tee "out/$name/printed.txt"
  if [ -f "examples/$name/plot.py" ]; then
    MPLBACKEND=Agg /usr/bin/python3 "examples/$name/plot.py"
  fi
done
if [ $tables = yes ]; then
  echo
  /usr/bin/python3 examples/paper_tables.py
fi
