"""Growth of cracks: energies against the integral of their rates, paths against the length of steps, and the time of an
increment against that of a body built from nothing."""

from __future__ import annotations

import math
import time

import bempd
import scenes

Place = tuple[float, float]


def slanted(element: float = 0.25, **options: float | str) -> bempd.Model:
    """A slanted edge crack in a strip 2 x 6 pulled along it."""
    model = scenes.plate(1, 3, element, [[(-1, -0.2), (-0.7, -0.1)]], energy=1)
    for name, value in options.items():
        model.options["crack." + name] = value
    return model


def grown(length: float, steps: int, **options: float | str) -> bempd.Model:
    model = slanted(**options)
    for _ in range(steps):
        model.grow_cracks(length)
    return model


def energies() -> list[str]:
    """Released energy of the history against the sum over extensions of the mean of the rates times their length."""
    lines = ["| steps of | steps | released | integral of G | difference | order |", "|---|---|---|---|---|---|"]
    before = None
    for steps in (7, 14, 28):
        model = grown(0.7 / steps, steps)
        released = float(model.history()["released_energy"][-1])
        integral = sum(e.released_energy for e in model.extensions())
        difference = integral / released - 1
        order = "" if before is None else f"{math.log2(abs(before / difference)):.1f}"
        lines.append(f"| {0.7 / steps:g} | {steps} | {released:.6f} | {integral:.6f} | {difference:+.1e} | {order} |")
        before = difference
    return lines


def steps() -> list[str]:
    """Height of the tip after a way of 0.64 against the length of steps, for both directions of an extension."""
    def height(count: int, direction: str) -> float:
        model = scenes.plate(1, 1, 0.25, [[(-1, -0.5), (-0.7, -0.2)]], energy=1)
        model.options["crack.direction"] = direction
        for _ in range(count):
            model.grow_cracks(0.64 / count)
        return model.tips()[0].y

    finest = height(256, "chord")
    lines = ["| steps | off, along the tip | off, by chords |", "|---|---|---|"]
    for count in (4, 8, 16, 32, 64):
        lines.append(f"| {count} | {height(count, 'tip') - finest:+.1e} | {height(count, 'chord') - finest:+.1e} |")
    return lines


def seconds(count: int = 100) -> list[str]:
    """Processor time of increments, and that of the same bodies from nothing."""
    lines = ["| elements of the boundary | with the crack, first and last | ms an increment | ms from nothing | "
             "kernels an increment | kernels from nothing |", "|---|---|---|---|---|---|"]
    for element in (0.25, 0.1, 0.05):
        model = slanted(element)
        model.step(1)
        first, path = model.statistics().boundary_elements, [(-1, -0.2), (-0.7, -0.1)]
        kernels = 0
        start = time.process_time()
        for _ in range(count):
            model.grow_cracks(1.4 / count)
            kernels += model.statistics().kernel_evaluations
        spent = time.process_time() - start
        last = model.statistics().boundary_elements
        path += [(e.x, e.y) for e in model.extensions()]
        fresh, fresh_kernels = 0.0, 0
        sampled = range(count // 10, count + 1, count // 10)
        for points in sampled:
            other = scenes.plate(1, 3, element, [path[:2 + points]], energy=1)
            start = time.process_time()
            other.step(1)
            other.tips()
            fresh += time.process_time() - start
            fresh_kernels += other.statistics().kernel_evaluations
        lines.append(f"| {element:g} W | {first}, {last} | {1e3 * spent / count:.1f} | {1e3 * fresh / len(sampled):.1f} | "
                     f"{kernels / count:,.0f} | {fresh_kernels / len(sampled):,.0f} |")
        print(lines[-1], flush=True)
    return lines


def section() -> str:
    parts = (
        "## Growth", "A slanted edge crack in a strip. Released energy of the history, of the body's potential energy alone, "
        "against the mean of the energy release rates at both ends of each extension times its length:", "\n".join(energies()),
        "A slanted edge crack in a square that has turned after a way of 0.64: height of its tip off that after 256 steps, in "
        "half widths (options `crack.direction` = tip and chord):", "\n".join(steps()),
        "100 increments of the slanted crack across the strip, each with its load factor, direction and energies; beside them the "
        "same bodies built from nothing, with the factors of their tips (mean of ten). *Kernels* counts their evaluations for the "
        "equations: what is kept is neither integrated nor factored again:", "\n".join(seconds()))
    return "\n\n".join(parts) + "\n"
