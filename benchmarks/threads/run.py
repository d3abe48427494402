"""A model for each of eight threads: wall seconds with the environment as it is, with a thread of the BLAS for each core that
a larger machine would have, and with one.

    benchmarks/run.sh threads [models] [N]     N x N points each, torn apart bond by bond; 8 and 60"""

from __future__ import annotations

import json
import os
import pathlib
import subprocess
import sys
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
REPEATS = 3


def together(models: int, n: int) -> float:
    """Wall seconds until all models are torn apart, each in a thread of its own."""
    sys.path.insert(0, str(HERE.parent / "speed"))
    import bempd
    from scenes import SCENES

    def run() -> None:
        model = bempd.Model(options={"crack.rule": "bond"})
        SCENES["plate"](model, n)
        model.run_to_separation(1e9)

    threads = [threading.Thread(target=run) for _ in range(models)]
    start = time.perf_counter()
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return time.perf_counter() - start


def main() -> None:
    models, n = (int(word) for word in (sys.argv[1:] + ["8", "60"][len(sys.argv) - 1:])[:2])
    if os.environ.get("BEMPD_WORKER"):
        print(json.dumps(together(models, n)))
        return
    ways = {"OPENBLAS_NUM_THREADS=1": "1", "as the environment is": None, "OPENBLAS_NUM_THREADS=16": "16"}
    seconds: dict[str, list[float]] = {way: [] for way in ways}
    for _ in range(REPEATS):  # in turns, so that all meet the same machine
        for way, value in ways.items():
            environment = {name: word for name, word in os.environ.items() if name != "OPENBLAS_NUM_THREADS"}
            environment |= {"BEMPD_WORKER": "1"} | ({"OPENBLAS_NUM_THREADS": value} if value else {})
            done = subprocess.run([sys.executable, __file__, str(models), str(n)], env=environment, check=True,
                                  capture_output=True, text=True)
            seconds[way].append(json.loads(done.stdout))
    least = {way: min(values) for way, values in seconds.items()}
    print(f"\n{models} models of {n} x {n} points, {os.cpu_count()} cores, least of {REPEATS}\n\n| environment | seconds | over one thread |\n|---|---|---|")
    for way, value in least.items():
        print(f"| {way} | {value:.2f} | {value / least['OPENBLAS_NUM_THREADS=1']:.2f} |")


if __name__ == "__main__":
    main()
