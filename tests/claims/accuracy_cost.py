"""README's table "What accuracy costs": errors of the scenes of benchmarks/accuracy_cost, to the bounds of claims.json.

Needs benchmarks/accuracy_cost and the Python package on PYTHONPATH and the library as BEMPD_LIBRARY.
"""

import json
import pathlib
import sys

import bempd
from cracks import CRACKS
from scenes import SCENES

CLAIMS = json.loads((pathlib.Path(__file__).resolve().parents[1] / "claims.json").read_text(encoding="utf-8"))["claims"]


def solved(scene, settings):
    """The scene's model with these knobs and options, solved, and its knobs."""
    knobs = {**scene.knobs, **{key: value for key, value in settings.items() if key in scene.knobs}}
    model = bempd.Model(options={key: value for key, value in settings.items() if key not in scene.knobs})
    scene.build(model, knobs)
    scene.solve(model)
    return model, knobs


def error(name, **settings):
    return SCENES[name].error(*solved(SCENES[name], settings))


def energy_change(name):
    """Energy released with bonds breaking together within 0.1 % against that with bonds one by one, in percent."""
    scene = CRACKS[name]
    standard, one_by_one = (scene.outcome(solved(scene, {"crack.tie_share": share})[0])["released_energy"]
                            for share in (0.001, 0.0))
    return 100 * abs(standard / one_by_one - 1)


def main():
    found = {
        "cost_plate": error("plate", element_length=0.2),
        "cost_shear": error("shear", element_length=0.05),
        "cost_hole": error("hole", element_length=0.05),
        "cost_cantilever_20": error("coupled_cantilever", spacing=0.05),
        "cost_cantilever_80": error("coupled_cantilever", spacing=0.0125),
        "cost_tie_band": energy_change("centre_crack"),
    }
    failed = False
    for name, value in found.items():
        claim = CLAIMS[name]
        good = value <= claim["bound"]
        print(f"{'ok    ' if good else 'FAILED'} {name}: {claim['quantity']}: {value:.3g}, claimed {claim['claimed']}, "
              f"must be <= {claim['bound']:g}")
        failed = failed or not good
    sys.exit(failed)


main()
