#!/usr/bin/env bash
# Usage: check_abi_test.sh C_COMPILER
# check_abi.sh must tell additions, which old programs do not notice, from changes that need a new SONAME.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
compiler=$1
command -v abidw >/dev/null || { echo "skipped: abidw (package abigail-tools) is not installed"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# build NAME SONAME MEMBER_TYPE FUNCTIONS: a library whose struct has a member of that type
build() {
  mkdir -p "$work/$1"
  {
    echo "typedef struct toy { int size; $3 value; } toy;"
    for function in $4; do echo "int toy_$function(const toy* t);"; done
  } >"$work/$1/toy.h"
  {
    echo '#include "toy.h"'
    for function in $4; do echo "int toy_$function(const toy* t) { return t->size; }"; done
  } >"$work/$1/toy.c"
  "$compiler" -g -shared -fPIC "-Wl,-soname,$2" "$work/$1/toy.c" -o "$work/$1/libtoy.so"
}

# expect STATUS NAME
expect() {
  local status=0
  "$here/check_abi.sh" "$work/$2/libtoy.so" "$work/toy.abi" "$work/$2" >"$work/said" || status=$?
  if [ "$status" -ne "$1" ]; then
    cat "$work/said"
    echo "$2: expected status $1, got $status"
    exit 1
  fi
  echo "$2: status $status as expected"
}

build unchanged libtoy.so.0 double "get set"
abidw --drop-private-types --headers-dir "$work/unchanged" --out-file "$work/toy.abi" "$work/unchanged/libtoy.so"
build function_added libtoy.so.0 double "get set clear"
build function_removed libtoy.so.0 double "get"
build member_changed libtoy.so.0 float "get set"
build function_removed_and_new_soname libtoy.so.1 double "get"
build member_changed_and_new_soname libtoy.so.1 float "get set"
expect 0 unchanged
expect 1 function_added
expect 2 function_removed
expect 2 member_changed
expect 1 function_removed_and_new_soname
expect 1 member_changed_and_new_soname
