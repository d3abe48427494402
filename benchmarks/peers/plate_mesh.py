"""The elastic plates of the benchmarks meshed by gmsh (Debian: python3-gmsh) for the finite element programs."""
import gmsh

LENGTH, HEIGHT, RADIUS = 1.0, 0.2, 0.05
YOUNG, POISSON = 100e9, 1 / 3


def load_of(problem):
    """Traction on the right end [Pa] and the component of the displacement that is compared."""
    return ([0.0, -0.5e6], 1) if problem == "shear" else ([5.25e6, 0.0], 0)


def mesh_plate(problem, size, refinement):
    """Leaves a mesh of quadratic triangles in gmsh, curved at the hole: SIZE long, SIZE / REFINEMENT in the clamped corners."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    shapes = gmsh.model.occ
    plate = shapes.addRectangle(0, 0, 0, LENGTH, HEIGHT)
    if problem == "hole":
        disk = shapes.addDisk(LENGTH / 2, HEIGHT / 2, 0, RADIUS, RADIUS)
        shapes.cut([(2, plate)], [(2, disk)])
    shapes.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 0)
    corners = [tag for _, tag in gmsh.model.getEntities(0) if gmsh.model.getValue(0, tag, [])[0] < 1e-9]
    field = gmsh.model.mesh.field
    field.add("Distance", 1)
    field.setNumbers(1, "PointsList", corners)
    field.add("Threshold", 2)
    field.setNumber(2, "InField", 1)
    field.setNumber(2, "SizeMin", size / refinement)
    field.setNumber(2, "SizeMax", size)
    field.setNumber(2, "DistMin", 0)
    field.setNumber(2, "DistMax", 0.5 * HEIGHT)
    field.setAsBackgroundMesh(2)
    gmsh.model.addPhysicalGroup(2, [tag for _, tag in gmsh.model.getEntities(2)], 1)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(2)  # curved triangles at the hole
