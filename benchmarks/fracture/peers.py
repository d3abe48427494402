"""The same factors by finite elements: what they take beside bempd."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

TARGET = 1e-3
# Length of a triangle, and over that in the tip.
MESHES = ((0.5, 4), (0.3, 8), (0.25, 16), (0.2, 16), (0.16, 16), (0.14, 16), (0.12, 16), (0.08, 32))
NOTE = ("The finite element peer is left out: python3-dolfinx or python3-gmsh is not installed "
        "(`benchmarks/run.sh fracture --with-peers`).")


def installed() -> bool:
    return importlib.util.find_spec("dolfinx") is not None and importlib.util.find_spec("gmsh") is not None


def finite_elements(kind: str, part: str, crack: float, repeats: int) -> list[dict[str, Any]]:
    """Value, unknowns and seconds on every mesh; one core."""
    program = Path(__file__).resolve().parents[1] / "peers/dolfinx_crack.py"
    words = [str(number) for mesh in MESHES for number in mesh]
    done = subprocess.run([sys.executable, str(program), kind, part, str(crack), str(repeats), *words], check=True,
                          capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
