"""The library's own sparse factorization beside CHOLMOD's, into docs/research/tables.

    benchmarks/run.sh factorization
"""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

from stored_tables import FOLDER

POINTS = (35, 70, 150, 300)


def main() -> None:
    program = Path(os.environ["BEMPD_BENCHMARKS"]) / "bempd_factorization"
    text = subprocess.run([program, *map(str, POINTS)], check=True, capture_output=True, text=True,
                          env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}).stdout
    print(text, end="")
    (FOLDER / "factorization.csv").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
