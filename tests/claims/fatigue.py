"""Lives of cracks under cycles against closed forms, integrations and small steps: the claims of docs/fatigue.md."""

from __future__ import annotations

import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks" / "fatigue"))
import bodies  # noqa: E402
import lives  # noqa: E402
import resistance  # noqa: E402

CLAIMS = json.loads((ROOT / "tests/claims.json").read_text(encoding="utf-8"))["claims"]


def main() -> None:
    centre, hole = lives.centre_crack(), lives.cracks_from_a_hole()
    coarse = lives.cracks_from_a_hole(tolerance=0.01, largest_step=0.5)
    cases, sections = lives.two_load_cases(), [lives.net_section(kind) for kind in ("middle crack", "edge crack")]
    orders = [lives.blocks_in_order(order) for order in ([0, 1], [1, 0])]
    retarded = [lives.retarded(kind, program) for kind in ("wheeler", "willenborg")
                for program in ("an overload in each 5000 cycles", "one overload")]
    end = lives.SQUARES["centre crack"][1]
    turned = [lives.square_life(scene, 40) / lives.square_life(scene) for scene in ("two edge cracks", "slanted crack")]
    turned.append(lives.life_under_cases(40, 0.4).cycles_at(end) / lives.life_under_cases(0, 0.4).cycles_at(end))
    values = {
        "fatigue_centre": abs(100 * (centre.cycles / lives.CENTRE_CRACK_FINE - 1)),
        "fatigue_handbook": abs(100 * (centre.cycles / lives.centre_crack_by_handbook() - 1)),
        "fatigue_wide": abs(100 * (lives.wide_plate().cycles / lives.wide_plate_by_closed_form() - 1)),
        "fatigue_hole": abs(100 * (hole.cycles / lives.CRACKS_FROM_A_HOLE_FINE - 1)),
        "fatigue_blocks": max(abs(100 * (growth / exact - 1)) for growth, exact in orders),
        "fatigue_steps": max(centre.steps, hole.steps),
        "fatigue_cases": abs(100 * (cases[0] / cases[1] - 1)),
        "fatigue_section": max(abs(100 * (length / exact - 1)) for length, exact in sections),
        "fatigue_coarse_hole": abs(100 * (coarse.cycles / lives.CRACKS_FROM_A_HOLE_FINE - 1)),
        "fatigue_coarse_steps": coarse.steps,
        "fatigue_retarded": max(abs(100 * (growth / exact - 1)) for growth, exact in retarded),
        "fatigue_lattice": max(abs(100 * (lives.square_life(scene, 60) / lives.square_life(scene) - 1))
                               for scene in ("edge crack", "centre crack", "two edge cracks")),
        "fatigue_turned": max(abs(100 * (one - 1)) for one in turned),
        "fatigue_halves": max(abs(100 * (found / exact - 1)) for scene in lives.HALVES for halves in (("elements", "lattice"), ("lattice", "elements"))
                              for found, exact in zip(lives.life_in_halves(*halves, scene), lives.life_in_halves("elements", "elements", scene))),
        "specimen_energy": max(abs(100 * bodies.by_energy(kind, sizes)) for kind, sizes, _ in bodies.CASES),
        "resistance_peak": max(abs(100 * (resistance.peak(length) / resistance.PEAKS[length][0] - 1)) for length in resistance.PEAKS),
        "weak_plane": resistance.critical_ratio(),
    }
    failed = False
    for name, value in values.items():
        claim = CLAIMS[name]
        good = value <= claim["bound"] if "bound" in claim else abs(value - float(claim["claimed"])) <= claim["within"]
        failed |= not good
        print(f"{'' if good else 'FAILED '}{name}: {value:.4g}, claimed {claim['claimed']}")
    assert abs(orders[0][0] - orders[1][0]) > 0.01 * orders[0][0], "the order of blocks does not matter"
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
