"""A host in Python over two ranks: rank 0 has the model, the other serves. Run by mpirun -np 2."""

from mpi4py import MPI

import bempd
import bempd.mpi

COMM = MPI.COMM_WORLD


def strip() -> bempd.Model:
    model = bempd.Model(options={"crack.rule": "bond"})
    solid = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=300)
    region = model.add_pd_region(solid, bempd.rectangle(0, 0, 0.03, 0.02), 0.001, 4)
    model.add_crack([(0.0145, 0), (0.0145, 0.006)])
    model.fix_edge(region, 4)
    model.prescribe_edge(region, 2, "x", 1e-6)
    return model


def torn(model: bempd.Model) -> list[tuple[int, bytes]]:
    """Bonds broken by each of thirty events."""
    return [(model.step_to_next_event(1e6).broken_bonds, model.bonds(1).states.tobytes()) for _ in range(30)]


def must_fail(kind: type, words: str, call, *arguments) -> None:  # type: ignore[no-untyped-def]
    try:
        call(*arguments)
    except kind as error:
        assert words in str(error), error
        return
    raise AssertionError(f"{call} did not fail")


def main() -> None:
    assert COMM.size == 2 and "MUMPS" in bempd.mpi.build_info()
    if COMM.rank == 1:
        must_fail(bempd.ArgumentError, "serve", bempd.mpi.attach, strip(), COMM)
        for _ in range(4):
            bempd.mpi.serve(COMM)
        return
    must_fail(bempd.ArgumentError, "attach", bempd.mpi.serve, COMM)
    alone, model = strip(), strip()
    with bempd.mpi.attached(model, COMM):
        must_fail(bempd.OrderError, "another model", bempd.mpi.attach, strip(), COMM)
        assert torn(model) == torn(alone)
    assert torn(model) == torn(alone)  # without MPI
    must_fail(bempd.OrderError, "before the first step", bempd.mpi.attach, model, COMM)  # lets the other rank go as well
    with bempd.mpi.attached(strip(), COMM) as closed:
        closed.step(1)
        closed.close()
    freed = strip()
    bempd.mpi.attach(freed, COMM)
    freed.step(1)
    del freed
    print("the same bonds break")


main()
