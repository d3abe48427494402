#!/usr/bin/env bash
# Packs the installed library into the Python package; not tested with conda.
set -euo pipefail
BEMPD_LIBRARY="$PREFIX/lib/libbempd.so" "$PYTHON" -m pip install --no-build-isolation --no-deps --no-index bindings/python
