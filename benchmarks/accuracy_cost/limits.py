"""What the machine could do at best, and what assembly and factorization make of it, on one core."""

from __future__ import annotations

import json
import os
import subprocess
import sys

from measure import Row, bempd_command, measure

SCENE, ELEMENT_LENGTH = "shear", 0.004  # 600 elements and a few more at the corners
ROUNDS = 3


def kernel_rates() -> dict[str, float]:
    """Pairs of points per second: in bare loops, and in the integrals over pairs of elements (kernel_rate.cpp)."""
    program = os.path.join(os.environ["BEMPD_BENCHMARKS"], "bempd_kernel_rate")
    output = subprocess.run([program, "--benchmark_format=json"], check=True, capture_output=True, text=True).stdout
    return {entry["name"].split("/")[0]: entry["items_per_second"] for entry in json.loads(output)["benchmarks"]}


def product_rate() -> float:
    """Floating point operations per second of a matrix product (DGEMM) on one core, in a process of its own."""
    program = ("import numpy, time\na = numpy.random.rand(1500, 1500)\na @ a\nbest = 1e9\n"
               "for _ in range(3):\n  t = time.perf_counter(); a @ a; best = min(best, time.perf_counter() - t)\n"
               "print(2 * 1500**3 / best)")
    output = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True,
                            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}).stdout
    return float(output)


def limits() -> list[Row]:
    """Rates of the library beside those of the machine, the best of each in rounds that take turns."""
    bare = lanes = pairs = products = 0.0
    seconds_boundary = seconds_assembly = float("inf")
    model: Row = {}
    for _ in range(ROUNDS):
        rates = kernel_rates()
        bare, pairs = max(bare, rates["kernels"]), max(pairs, rates["pair_integrals"])
        lanes = max(lanes, rates["kernels_in_lanes"])
        products = max(products, product_rate())
        model = measure([bempd_command(SCENE, {"element_length": ELEMENT_LENGTH, "threads": 1}, 0)], 1)[0]
        seconds_boundary = min(seconds_boundary, model["seconds_boundary"])
        seconds_assembly = min(seconds_assembly, model["seconds_assembly"])
    cube = model["unknowns"] ** 3
    # Traction unknowns are about as many as displacements: one factorization, one triangular solve with as many right
    # sides, one symmetric product; then the factorization of the stiffness.
    algebra, factorization = (1 / 3 + 1 + 1) * cube, cube / 3
    at_best = model["kernel_evaluations"] / bare + algebra / products
    return [
        {"stage": "integrals of pairs of elements", "rate": f"{pairs / 1e6:.0f} million pairs of points/s",
         "limit": f"{bare / 1e6:.0f}, kernels alone, with Eigen's logarithm", "factor": bare / pairs},
        {"stage": "the same", "rate": f"{pairs / 1e6:.0f} million pairs of points/s",
         "limit": f"{lanes / 1e6:.0f}, kernels alone, with the library's own logarithm", "factor": lanes / pairs},
        {"stage": "factorization of the stiffness", "rate": f"{factorization / seconds_assembly / 1e9:.1f} GFlop/s",
         "limit": f"{products / 1e9:.1f}, matrix product", "factor": products * seconds_assembly / factorization},
        {"stage": f"boundary operators, {model['elements']} elements", "rate": f"{seconds_boundary:.2f} s",
         "limit": f"{at_best:.2f} s, both limits", "factor": seconds_boundary / at_best},
    ]
