"""`python -m bempd`: which library is at work, what it was built with, which optional packages there are, and a first crack."""

from __future__ import annotations

import importlib
import platform
import sys
import time

import cffi
import numpy

import bempd

#: Optional packages, and what needs them.
OPTIONAL = {"matplotlib": "pictures", "PIL": "films", "ezdxf": "from_dxf()", "svgelements": "from_svg()", "meshio": "from_mesh()"}


def version_of(package: str) -> str:
    """The version of an optional package, or that it is not there."""
    try:
        module = importlib.import_module(package)
    except ImportError:
        return "not installed"
    return str(getattr(module, "__version__", "installed"))


def first_crack() -> bempd.StepReport:
    """An edge crack tears a strip of acrylic glass in two."""
    model = bempd.Model()
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    left = model.add_bem_region(acrylic, bempd.rectangle(0, 0, 0.02, 0.02), element_length=0.005)
    model.add_pd_region(acrylic, bempd.rectangle(0.02, 0, 0.04, 0.02), spacing=0.001, horizon_ratio=4)
    right = model.add_bem_region(acrylic, bempd.rectangle(0.04, 0, 0.06, 0.02), element_length=0.005)
    model.add_crack([(0.0295, 0), (0.0295, 0.0045)])
    model.fix_edge(left, 4)
    model.prescribe_edge(right, 2, "x", 1e-6)
    return model.run_to_separation(1e4)


def main() -> int:
    """Print it all; 1 if the crack does not what it should."""
    print(f"bempd        {bempd.version()}")
    print(f"library      {bempd.library_path}")
    print(f"built        {bempd.build_info()}")
    print(f"Python       {platform.python_version()}, numpy {numpy.__version__}, cffi {cffi.__version__}, {platform.machine()} "
          f"{platform.system()}")
    print("optional     " + ", ".join(f"{package} {version_of(package)} ({use})" for package, use in OPTIONAL.items()))
    began = time.perf_counter()
    try:
        report = first_crack()
    except bempd.Error as problem:
        print(f"first crack  FAILED: {problem}")
        return 1
    seconds = time.perf_counter() - began
    print(f"first crack  in two at {report.load_factor:.2f} micrometres: {report.total_broken_bonds} bonds in {report.total_events} "
          f"events, {report.released_energy:.4f} J released ({seconds:.1f} s)")
    if not report.separated or report.energy_balance_error > 1e-6:
        print("first crack  FAILED: the strip should be in two, and the energies in balance")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
