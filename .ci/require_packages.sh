#!/usr/bin/env bash
# Usage: require_packages.sh PACKAGE...
# Installs the Debian packages that are missing. Says nothing when all are there.
set -euo pipefail

if ! command -v dpkg-query >/dev/null; then
  echo "note: this is not a Debian system; needed are the equivalents of: $*" >&2
  exit 0
fi

missing=()
for package in "$@"; do
  status=$(dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null || true)
  grep -qx installed <<<"$status" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
  as_root=(env)
elif command -v sudo >/dev/null; then
  as_root=(sudo env)
else
  echo "error: these packages are missing and neither root nor sudo is available: ${missing[*]}" >&2
  echo "install them with: apt-get install --no-install-recommends ${missing[*]}" >&2
  exit 1
fi

echo "installing ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
