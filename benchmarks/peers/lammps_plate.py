"""The plate of the speed table torn in LAMMPS (Debian: lammps, package PERI, pair style peri/pmb), two-dimensional.

    /usr/bin/python3 lammps_plate.py N OPENING TRANSITS

OPENING is that of each end at the first break, which sets the speed: it is reached after TRANSITS wave transits.
LAMMPS has one bond stiffness for all lengths and no initial cracks: the stiffness gives the plate E = 1, and pairs that
face each other across the crack are excluded before bonds are made. Prints one line of JSON; seconds are processor time
for the steps until the pull of an end has fallen to 2 % of its peak."""
import json
import math
import re
import resource
import subprocess
import sys
import tempfile

HORIZON, EVERY = 4.01, 20

SCRIPT = """
units lj
dimension 2
boundary s s p
atom_style peri
atom_modify map array
neighbor 0.2 bin
lattice sq 1.0
region plate block -0.1 {end} -0.1 {end} -0.5 0.5 units box
create_box 1 plate
create_atoms 1 region plate
pair_style peri/pmb
pair_coeff * * {stiffness} {horizon} 0.001 0.0
set group all density 1.0
set group all volume 1.0
region a block {left0} {middle} {low} {high} INF INF units box
region b block {middle} {right0} {low} {high} INF INF units box
group a region a
group b region b
neigh_modify exclude group a b
region ends_left block INF 0.5 INF INF INF INF units box
region ends_right block {last} INF INF INF INF INF units box
group left region ends_left
group right region ends_right
group inner subtract all left right
velocity all ramp vx -{rate} {rate} x 0 {side} units box
fix integrate all nve
fix hold_left left setforce 0 0 0
fix hold_right right setforce 0 0 0
fix damp inner viscous {damping}
fix flat all enforce2d
timestep {step}
variable pull equal f_hold_left[1]
thermo_style custom step v_pull
thermo {every}
run {steps}
"""


def main() -> None:
    n, opening, transits = int(sys.argv[1]), float(sys.argv[2]), float(sys.argv[3])
    offsets = [(x, y) for x in range(-4, 5) for y in range(-4, 5) if 0 < math.hypot(x, y) <= 4]
    # LAMMPS halves the volume of points at the horizon linearly between the horizon minus and plus half a spacing.
    volume = {o: min(1.0, (HORIZON - math.hypot(*o)) / 1.0 + 0.5) for o in offsets}
    stiffness = 9 / 8 / sum(0.5 * volume[o] * math.hypot(*o) * (o[0] / math.hypot(*o)) ** 4 for o in offsets)
    largest = sum(stiffness * volume[o] / math.hypot(*o) for o in offsets)
    step = 0.9 * 2 / math.sqrt(2 * largest)
    rows, middle = math.floor(0.2 * n), 0.5 * (n - 1)
    low = math.ceil(middle - 0.5 * rows) - 0.5
    crack = math.floor(middle) + 0.5
    time = transits * n / 1.06
    script = SCRIPT.format(
        end=n - 0.9, stiffness=stiffness, horizon=HORIZON, left0=crack - 4.2, middle=crack, right0=crack + 4.2, low=low,
        high=low + rows, last=n - 1.5, rate=opening / time, side=n - 1, damping=2 * math.pi / n * 0.3, step=step,
        every=EVERY, steps=int(1.6 * time / step))
    with tempfile.NamedTemporaryFile("w", suffix=".in") as file:
        file.write(script)
        file.flush()
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        output = subprocess.run(["/usr/bin/lmp", "-in", file.name, "-log", "none"], capture_output=True, text=True,
                                check=True).stdout
    lines = [line.split() for line in output.splitlines() if re.fullmatch(r"\s*\d+\s+\S+\s*", line)]
    table = [(int(step), abs(float(pull))) for step, pull in lines]
    peak = max(pull for _, pull in table)
    after = [row for row in table[[pull for _, pull in table].index(peak):] if row[1] < 0.02 * peak]
    last = after[0] if after else table[-1]
    # Processor time, for the share of the steps that the tearing took.
    seconds = (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before) * last[0] / table[-1][0]
    print(json.dumps({"seconds": seconds, "steps": last[0], "peak_force": peak, "finished": bool(after)}))


main()
