"""Outlines from drawings and meshes, and edges by name and place."""

import csv
import math
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

import bempd
import numpy as np
import pytest
from bempd import outline
from bempd._loops import area
from conftest import make_plate

QUARTER = math.tan(math.pi / 8)


def areas(found):
    """Areas of the loops, of polygons with short sides along arcs."""
    return [area(loop.polygon()) for loop in found.loops]


def glass_model():
    model = bempd.Model()
    return model, model.add_material(young_modulus=70e9, poisson_ratio=0.2)


# DXF


def drawing(unit=4):
    ezdxf = pytest.importorskip("ezdxf")
    document = ezdxf.new()
    document.header["$INSUNITS"] = unit
    return document, document.modelspace()


def saved(document, tmp_path):
    document.saveas(tmp_path / "plate.dxf")
    return tmp_path / "plate.dxf"


def test_a_drawing_becomes_a_region_with_holes_names_and_arcs(tmp_path):
    document, space = drawing()
    on = {"layer": "sides"}
    space.add_line((0, 0), (100, 0), dxfattribs={"layer": "bottom"})
    space.add_line((100, 50), (100, 0), dxfattribs=on)  # drawn from its upper end
    space.add_arc((90, 50), 10, 0, 90, dxfattribs=on)
    space.add_lwpolyline([(90, 60), (0, 60), (0, 0)], dxfattribs=on)
    space.add_circle((50, 30), 10, dxfattribs={"layer": "hole"})
    space.add_text("texts are passed over")
    found = outline.from_dxf(saved(document, tmp_path))
    exact = [1e-6 * (6000 - 100 + 25 * math.pi), -1e-6 * 100 * math.pi]
    np.testing.assert_allclose(areas(found), exact, rtol=2e-3)
    assert found.deviation == 0 and sorted(found.bulges[found.bulges != 0]) == [pytest.approx(QUARTER)]
    assert found.names.count("hole") == 4 and found.names.count("bottom") == 1
    model, glass = glass_model()
    plate = model.add_bem_region(glass, found, element_length=0.01)
    assert model.edge_count(plate) == 9 and model.edge_names(plate)[model.edge_named(plate, "bottom")] == "bottom"
    assert model.edge_at(plate, (0.05, 0)) == model.edge_named(plate, "bottom")
    # The arc is the library's own: its middle lies on an edge to rounding.
    middle = (0.09 + 0.01 * math.sqrt(0.5), 0.05 + 0.01 * math.sqrt(0.5))
    assert model.edge_names(plate)[model.edge_at(plate, middle, tolerance=1e-15)] == "sides"
    with pytest.raises(bempd.ArgumentError, match="fix_edge: 'hole' is the name of 4 edges of region 1: 6, 7, 8, 9"):
        model.fix_edge(plate, "hole")


def test_imported_outlines_become_bodies(tmp_path):
    """Holes, arcs and names of edges come with the outline, and the library chooses the elements."""
    outlines = {}
    document, space = drawing()
    space.add_lwpolyline([(0, 0), (100, 0), (100, 60), (0, 60)], close=True, dxfattribs={"layer": "sides"})
    space.add_circle((50, 30), 10, dxfattribs={"layer": "hole"})
    outlines["sides", "hole"] = outline.from_dxf(saved(document, tmp_path))
    outlines["plate", "hole"] = outline.from_svg(svg(tmp_path, '<rect id="plate" width="40" height="20"/>'
                                                               '<circle id="hole" cx="10" cy="5" r="2"/>'))
    outlines["bottom", "left"] = outline.from_mesh(gmsh_file(tmp_path), part="ring")
    for names, found in outlines.items():
        model, glass = glass_model()
        body = model.add_body(glass, found)
        model.fix_edge(body, 1)
        assert model.plan().meets_wish
        assert model.plan().parts[0].reason == bempd.PartReason.BODY
        assert set(names) <= set(model.edge_names(body).values()) and model.edge_count(body) == len(found.names)


def test_ellipses_and_splines_become_arcs_within_the_tolerance(tmp_path):
    document, space = drawing(unit=6)
    space.add_ellipse((0, 0), major_axis=(2, 0), ratio=0.25)
    file = saved(document, tmp_path)
    errors = []
    for tolerance in (1e-2, 1e-4):
        found = outline.from_dxf(file, tolerance=tolerance)
        assert 0 < found.deviation <= tolerance
        x, y = np.array([place for one in found.outer.ways() for place in one]).T
        # Distances from the ellipse to first order.
        level = np.hypot(x / 2, y / 0.5) - 1
        errors.append(np.max(np.abs(level) / np.hypot(x / 4, y / 0.25)))
        assert errors[-1] <= 1.1 * tolerance
    assert errors[1] < errors[0]
    document, space = drawing(unit=6)
    space.add_spline([(0, 0), (1, 1), (2, 0)])
    space.add_line((0, 0), (2, 0))
    found = outline.from_dxf(saved(document, tmp_path), tolerance=1e-5)
    tangents = []
    for start, end in zip(found.outer.ways(), found.outer.ways()[1:]):
        a, b = np.subtract(start[-1], start[-2]), np.subtract(end[1], end[0])
        tangents.append(abs(math.atan2(a[0] * b[1] - a[1] * b[0], float(np.dot(a, b)))))
    # Two corners, where the line meets the spline; the arcs follow each other smoothly, to half the angle of a drawn side each.
    assert sum(angle > 0.15 for angle in tangents) <= 2


def test_a_circle_of_two_arcs_has_enough_vertices_for_a_region(tmp_path):
    document, space = drawing(unit=6)
    space.add_lwpolyline([(-1, 0, 1), (1, 0, 1)], format="xyb", close=True)
    found = outline.from_dxf(saved(document, tmp_path))
    np.testing.assert_allclose(np.hypot(*found.vertices.T), 1)
    assert areas(found) == [pytest.approx(math.pi, rel=2e-3)] and found.bulges == pytest.approx([QUARTER] * 4)
    model, glass = glass_model()
    assert model.add_bem_region(glass, found, element_length=0.5) == 1


def test_mirrored_entities_and_blocks_are_where_they_are_seen(tmp_path):
    document, space = drawing()
    block = document.blocks.new("half")
    block.add_lwpolyline([(0, 0), (4, 0), (4, 2, QUARTER), (3, 3), (0, 3)], format="xyb", dxfattribs={"layer": "right"})
    space.add_blockref("half", (0, 0))
    space.add_blockref("half", (0, 0), dxfattribs={"xscale": -1})
    found = outline.from_dxf(saved(document, tmp_path), unit=1.0)
    assert areas(found) == [pytest.approx(2 * (12 - 1 + math.pi / 4), rel=2e-3)]
    np.testing.assert_allclose(np.ptp(found.vertices, axis=0), (8, 3))


def test_bodies_are_counted_and_chosen(tmp_path):
    document, space = drawing()
    space.add_lwpolyline(bempd.rectangle(0, 0, 40, 20), close=True)
    space.add_circle((100, 0), 5)
    file = saved(document, tmp_path)
    with pytest.raises(bempd.ArgumentError, match=r"2 separate outlines \(1: x 0 .. 0.04, y 0 .. 0.02 .m.; 2: x 0.095 .. 0.105.*body=1 .. 2"):
        outline.from_dxf(file)
    assert len(outline.from_dxf(file, body=2).bulges) == 4
    with pytest.raises(bempd.ArgumentError, match="body is 3, but the drawing has 2"):
        outline.from_dxf(file, body=3)


@pytest.mark.parametrize("add, message", [
    (lambda space: space.add_lwpolyline([(0, 0), (4, 0), (4, 3), (0, 3)]),
     r"plate.dxf: the outline is open: LWPOLYLINE #\w+ on layer 0 ends at \(0, 0\)"),
    (lambda space: [space.add_line((0, 0), (4, 0)), space.add_line((4, 0.01), (0, 3)), space.add_line((0, 3), (0, 0))],
     r"is open: LINE #\w+ on layer 0 ends at \(4, 0\), where nothing goes on; the nearest open end, of LINE #\w+ on layer 0, is 0.01 away.*gap=0.011"),
    (lambda space: space.add_lwpolyline([(0, 0), (4, 0), (0, 3), (4, 3)], close=True, dxfattribs={"layer": "bow"}),
     r"crosses itself: LWPOLYLINE #\w+ on layer bow and LWPOLYLINE #\w+ on layer bow meet at \(2, 1.5\)"),
    (lambda space: [space.add_lwpolyline(bempd.rectangle(0, 0, 4, 3), close=True), space.add_circle((4, 1), 0.5)],
     r"crosses itself: LWPOLYLINE #\w+ on layer 0 and CIRCLE #\w+ on layer 0 meet at \(4, "),
    (lambda space: [space.add_line(*ends) for ends in (((0, 0), (4, 0)), ((4, 0), (0, 3)), ((0, 3), (0, 0)), ((4, 0), (9, 9)))],
     "the outline is open"),
    (lambda space: [space.add_line(*ends) for ends in (((0, 0), (4, 0)), ((4, 0), (0, 0)), ((4, 0), (0, 3)), ((0, 3), (0, 0)))],
     r"3 lines meet at \(0, 0\): LINE"),
    (lambda space: space.add_text("nothing else"), "has no line, arc or curve"),
])
def test_faults_of_a_drawing_name_the_entity(tmp_path, add, message):
    document, space = drawing(unit=6)
    add(space)
    with pytest.raises(bempd.ArgumentError, match=message):
        outline.from_dxf(saved(document, tmp_path))


def test_small_gaps_close_if_they_are_told_of(tmp_path):
    document, space = drawing(unit=6)
    for ends in (((0, 0), (4, 0)), ((4, 0.01), (0, 3)), ((0, 3), (0, 0))):
        space.add_line(*ends)
    found = outline.from_dxf(saved(document, tmp_path), gap=0.011)
    assert len(found.bulges) == 3 and found.deviation == pytest.approx(0.01)


def test_units_are_told_or_asked_for(tmp_path):
    document, space = drawing(unit=0)
    space.add_circle((0, 0), 5)
    file = saved(document, tmp_path)
    with pytest.raises(bempd.ArgumentError, match=r"does not say its unit \(\$INSUNITS is 0\); give unit='mm'"):
        outline.from_dxf(file)
    assert np.ptp(outline.from_dxf(file, unit="in").vertices[:, 0]) == pytest.approx(0.254)
    assert np.ptp(outline.from_dxf(file, unit="mm").scaled(1000).vertices[:, 0]) == pytest.approx(10)
    for wrong in ("mile", 0, -1, True, float("nan")):
        with pytest.raises(bempd.ArgumentError, match="unit is"):
            outline.from_dxf(file, unit=wrong)
    with pytest.raises(bempd.ArgumentError, match="no line, arc or curve on the layer 'x'; it has some on '0'"):
        outline.from_dxf(file, unit="mm", layer="x")
    with pytest.raises(bempd.FileError, match="there is no file"):
        outline.from_dxf(tmp_path / "nothing.dxf")
    (tmp_path / "text.dxf").write_text("no drawing")
    with pytest.raises(bempd.FileError, match="cannot be read as a DXF drawing"):
        outline.from_dxf(tmp_path / "text.dxf")


# SVG


def svg(tmp_path, shapes, page='width="40mm" height="20mm" viewBox="0 0 40 20"'):
    pytest.importorskip("svgelements")
    (tmp_path / "plate.svg").write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {page}>{shapes}</svg>')
    return tmp_path / "plate.svg"


def test_an_svg_drawing_stands_upright_in_metres(tmp_path):
    file = svg(tmp_path, '<path id="plate" d="M 0 20 L 40 20 L 40 5 A 5 5 0 0 0 35 0 L 0 0 Z"/>'
                         '<circle id="hole" cx="10" cy="5" r="2"/><text>words</text>')
    found = outline.from_svg(file)
    np.testing.assert_allclose(areas(found), [1e-6 * (800 - 25 + 25 * math.pi / 4), -1e-6 * 4 * math.pi], rtol=2e-3)
    assert found.deviation == 0 and set(found.names) == {"plate", "hole"}
    hole = found.holes[0].polygon()
    np.testing.assert_allclose((hole.min(axis=0) + hole.max(axis=0)) / 2, (0.01, 0.015), atol=1e-12)
    corner = found.bulges != 0
    assert found.bulges[corner] == [pytest.approx(QUARTER)] and found.vertices[corner][0] == pytest.approx((0.04, 0.015))


def test_transforms_ellipses_and_beziers_of_svg(tmp_path):
    file = svg(tmp_path, '<g transform="translate(20 10) scale(-1 1)"><ellipse rx="8" ry="4"/>'
                         '<path d="M -2 0 C -2 2 2 2 2 0 Z"/></g>')
    found = outline.from_svg(file, tolerance=1e-6)
    assert 0 < found.deviation <= 1e-6
    np.testing.assert_allclose(areas(found), [1e-6 * math.pi * 32, -1e-6 * 4.8], rtol=2e-3)
    # A sheared circle is an ellipse; a half of a circle that is mirrored stays a half circle.
    sheared = outline.from_svg(svg(tmp_path, '<circle transform="rotate(30) skewX(40) scale(1 -2)" cx="15" cy="-2" r="1"/>'))
    assert areas(sheared)[0] == pytest.approx(2e-6 * math.pi, rel=1e-3) and sheared.deviation > 0
    half = outline.from_svg(svg(tmp_path, '<path transform="scale(-1 1)" d="M 0 0 A 5 5 0 1 1 6 8 Z"/>'))
    assert areas(half)[0] == pytest.approx(12.5e-6 * math.pi, rel=1e-2) and half.deviation == 0


def test_svg_without_a_size_is_asked_for_its_unit(tmp_path):
    file = svg(tmp_path, '<rect width="40" height="20"/>', page='width="400" height="200" viewBox="0 0 40 20"')
    with pytest.raises(bempd.ArgumentError, match="does not say its unit: its width is 400; give unit='mm'"):
        outline.from_svg(file)
    assert np.ptp(outline.from_svg(file, unit="cm").vertices, axis=0) == pytest.approx((0.4, 0.2))
    with pytest.raises(bempd.ArgumentError, match='the outline is open: path id="way" ends at'):
        outline.from_svg(svg(tmp_path, '<path id="way" d="M 0 0 L 5 5 L 9 0"/>'))
    with pytest.raises(bempd.ArgumentError, match="has no shape with the id 'b'; it has 'a'"):
        outline.from_svg(svg(tmp_path, '<circle id="a" r="1"/>'), layer="b")


# Meshes


def gmsh_file(tmp_path):
    """A quarter of a ring of triangles in Gmsh's format 2.2, with physical lines."""
    pytest.importorskip("meshio")
    count = 9
    nodes = [(r * math.cos(a), r * math.sin(a)) for a in np.linspace(0, math.pi / 2, count) for r in (1.0, 1.5, 2.0)]
    nodes = [(0.0 if abs(x) < 1e-15 else x, y) for x, y in nodes]
    cells = [(3 * k + r + 1, 3 * k + r + 2, 3 * k + r + 5) for k in range(count - 1) for r in (0, 1)]
    cells += [(3 * k + r + 1, 3 * k + r + 5, 3 * k + r + 4) for k in range(count - 1) for r in (0, 1)]
    lines = [(1, 2, 1), (2, 3, 1), (25, 26, 2), (26, 27, 2)]
    text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3", '1 1 "bottom"', '1 2 "left"', '2 7 "ring"',
            "$EndPhysicalNames", "$Nodes", str(len(nodes))]
    text += [f"{k} {x!r} {y!r} 0" for k, (x, y) in enumerate(nodes, 1)]
    text += ["$EndNodes", "$Elements", str(len(lines) + len(cells))]
    text += [f"{k} 1 2 {tag} {tag} {a} {b}" for k, (a, b, tag) in enumerate(lines, 1)]
    text += [f"{k} 2 2 7 7 {a} {b} {c}" for k, (a, b, c) in enumerate(cells, 1 + len(lines))]
    (tmp_path / "ring.msh").write_text("\n".join([*text, "$EndElements", ""]))
    return tmp_path / "ring.msh"


def test_the_boundary_of_a_mesh_has_edges_arcs_and_physical_names(tmp_path):
    found = outline.from_mesh(gmsh_file(tmp_path), part="ring")
    assert len(found.bulges) == 4 and sorted(np.abs(found.bulges)) == pytest.approx([0, 0, QUARTER, QUARTER])
    assert areas(found) == [pytest.approx(math.pi / 4 * 3, rel=2e-3)] and found.deviation < 1e-9
    assert sorted(found.names) == ["", "", "bottom", "left"]
    model, glass = glass_model()
    ring = model.add_pd_region(glass, found, 0.2, 3)
    assert model.edge_at(ring, (1.5, 0)) == model.edge_named(ring, "bottom")
    assert model.edges_where(ring, x=0) == [model.edge_named(ring, "left")]
    with pytest.raises(bempd.ArgumentError, match="no physical surface or element set 'disc'; it has 'ring'"):
        outline.from_mesh(gmsh_file(tmp_path), part="disc")


def test_abaqus_sets_of_nodes_name_edges(tmp_path):
    pytest.importorskip("meshio")
    (tmp_path / "plate.inp").write_text(
        "*HEADING\n*NODE\n1, 0., 0.\n2, 2., 0.\n3, 4., 0.\n4, 0., 3.\n5, 2., 3.\n6, 4., 3.\n"
        "*ELEMENT, TYPE=CPS4, ELSET=PLATE\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n*NSET, NSET=LEFT\n1, 4\n*NSET, NSET=TOP\n4, 5, 6\n")
    found = outline.from_mesh(tmp_path / "plate.inp", unit="mm")
    assert len(found.bulges) == 4 and areas(found) == [pytest.approx(12e-6)]
    assert sorted(filter(None, found.names)) == ["LEFT", "TOP"]
    assert outline.from_mesh(tmp_path / "plate.inp", part="PLATE").names == found.names
    with pytest.raises(bempd.FileError, match="cannot be read as a mesh"):
        (tmp_path / "none.msh").write_text("no mesh")
        outline.from_mesh(tmp_path / "none.msh")


@pytest.mark.parametrize("read, package", [(outline.from_dxf, "ezdxf"), (outline.from_svg, "svgelements"),
                                           (outline.from_mesh, "meshio")])
def test_a_missing_package_is_named(monkeypatch, tmp_path, read, package):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ImportError, match=f"the package {package} is needed.*apt install python3-{package}"):
        read(tmp_path / "any")


# Edges by name and place


def test_edges_by_name_work_wherever_an_edge_is_asked_for():
    model, glass = glass_model()
    square = outline.Outline.of_vertices(bempd.rectangle(0, 0, 2, 1), names=["bottom", "right", "top", "left"])
    plate = model.add_bem_region(glass, square, 0.5)
    model.set_edge_mesh(plate, "right", 0.25)
    held = model.fix_edge(plate, "left")
    model.add_traction(plate, "right", "x", 1e6)
    model.step(1)
    np.testing.assert_allclose(model.edge_reaction(plate, "left").force, model.reaction(held))
    assert len(model.edge_nodes(plate, "right").nodes) == 9 and len(model.edge_elements(plate, "right")) == 4
    assert model.edge_forces(plate, "left").sum(axis=0)[0] == pytest.approx(-1e6)
    assert model.fractions_on_edge(plate, "left", [(0, 0.25)]).fractions == [pytest.approx(0.75)]
    with pytest.raises(bempd.ArgumentError, match="edge_nodes: no edge of region 1 has the name 'front'; its edges are named "
                                                  "'bottom', 'left', 'right', 'top'"):
        model.edge_nodes(plate, "front")
    with pytest.raises(bempd.ArgumentError, match=r'edge_forces: edge 1 \("bottom"\) of region 1 is neither held'):
        model.edge_forces(plate, 1)


def test_edges_by_place():
    plate = make_plate()
    model = plate.model
    assert model.edge_at(plate.plate, (0.7, 1)) == 3 and model.edges_where(plate.plate, y=1) == [3]
    assert model.edges_where(plate.plate, x=(1, 3)) == [2] and model.edges_where(plate.plate, x=(0, 2)) == [1, 2, 3, 4]
    with pytest.raises(bempd.ArgumentError, match=r"passes through \(0.7, 0.9\); the nearest, edge 3 of region 1, is 0.1 away"):
        model.edge_at(plate.plate, (0.7, 0.9))
    with pytest.raises(bempd.ArgumentError, match=r"edges 1 and 4 of region 1 meet at \(0, 0\)"):
        model.edge_at(plate.plate, (0, 0))
    with pytest.raises(bempd.ArgumentError, match="lies at x = 5; the region goes from x = 0 to 2 and y = 0 to 1"):
        model.edges_where(plate.plate, x=5)
    with pytest.raises(bempd.ArgumentError, match="neither x nor y"):
        model.edges_where(plate.plate)
    with pytest.raises(bempd.ArgumentError, match="region 7 does not exist"):
        model.edge_at(7, (0, 0))
    with pytest.raises(bempd.ArgumentError, match="its edges have no names; name_edge"):
        model.edge_named(plate.plate, "upper")
    with pytest.raises(bempd.ArgumentError, match="edge 5 does not exist; region 1 has edges 1 .. 4"):
        model.name_edge(plate.plate, 5, "fifth")


def test_a_refused_hole_takes_the_region_back():
    model, glass = glass_model()
    good = outline.Outline.of_vertices(bempd.rectangle(0, 0, 2, 1))
    bad = outline.Outline(good.outer, (outline.Outline.of_vertices(bempd.rectangle(1, 0.2, 5, 0.8)).outer.reversed(),))
    with pytest.raises(bempd.ArgumentError):
        model.add_bem_region(glass, bad, 0.5)
    assert model.region_ids == []
    with pytest.raises(bempd.ArgumentError, match="bulges are given beside an Outline"):
        model.add_bem_region(glass, good, 0.5, bulges=[0, 0, 0, 0])


def edges_part(file):
    """Arrays of a part "edges" as the library writes it: numbers and texts behind the headings, each with its size in bytes."""
    content = pathlib.Path(file).read_bytes()
    heading, block = content.split(b'<AppendedData encoding="raw">\n_', 1)
    found = {}
    for array in xml.fromstring(heading + b"</VTKFile>").iter("DataArray"):
        start = int(array.get("offset"))
        size = int(np.frombuffer(block, np.uint64, 1, start)[0])
        values = block[start + 8:start + 8 + size]
        kind = array.get("type")
        found[array.get("Name")] = (values.decode().split("\0")[:-1] if kind == "String"
                                    else np.frombuffer(values, np.dtype(kind.lower())).tolist())
    return found


def test_named_edges_are_written_in_snapshots(tmp_path):
    plate = make_plate()
    plate.model.name_edge(plate.plate, 2, "pulled < side")
    plate.model.step(1)
    plate.model.write_snapshot(tmp_path / "plate")
    arrays = edges_part(tmp_path / "plate_0000_edges.vtu")
    assert arrays["region"] == [1] * 4 + [0] and arrays["edge"] == [1, 2, 3, 4, 0]
    assert arrays["name"] == ["", "pulled < side", "", "", ""]  # the held point comes last


def test_regions_supports_and_loads_have_names(tmp_path):
    """In messages, in the picture and table of a notebook, and in the file of edges."""
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3)
    plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 4, 4), 1.0)
    model.name_region(plate, "pane")
    with pytest.raises(bempd.UnsolvableError, match=r'region 1 \("pane"\) can'):
        model.prepare()
    frame, wind = model.fix_edge(plate, 4), model.add_traction(plate, 2, "x", 1.0)
    model.name_support(frame, "frame")
    model.name_load(wind, "wind")
    page = model._repr_html_()
    assert all(f'{word} 1 (&quot;{name}&quot;)' in page for word, name in (("region", "pane"), ("support", "frame"), ("load", "wind")))
    with pytest.raises(bempd.ArgumentError, match=r'support 1 \("frame"\)'):
        model.set_support_values(frame, np.zeros(3))
    model.step(1)
    model.write_snapshot(tmp_path / "plate")
    assert edges_part(tmp_path / "plate_0000_edges.vtu")["supports and loads"][3] == 'support 1 ("frame")'
    assert b'Name="load 1 (&quot;wind&quot;)"' in (tmp_path / "plate_0000_boundary.vtu").read_bytes()
    with pytest.raises(bempd.ArgumentError, match="load 7 does not exist"):
        model.name_load(7, "none")
    with pytest.raises(bempd.ArgumentError, match="it must be a word"):
        model.name_region(plate, "")


def named_plate():
    """A plate whose region, supports and load have names, one support at a point."""
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=0.3)
    plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 4, 4), 1.0)
    rail, peg, wind = model.fix_edge(plate, 4, "x"), model.fix_point((0, 0), "y"), model.add_traction(plate, 2, "x", 1.0)
    model.name_region(plate, "pane")
    model.name_support(rail, 'rail, "left"')
    model.name_support(peg, "peg")
    model.name_load(wind, "wind")
    return model, rail, peg


def test_names_stand_in_tables(tmp_path):
    model, _, _ = named_plate()
    assert re.search(r'^support 2 \("peg"\) +point \(0, 0\) +y held +- +-$', str(bempd.table(model)), re.MULTILINE)
    model.step(1)
    table = str(bempd.table(model))
    assert re.search(r'^support 1 \("rail, "left""\) +edge 4 of region 1 \("pane"\) +x held +-4 ', table, re.MULTILINE)
    assert re.search(r'^load 1 \("wind"\) +edge 2 of region 1 \("pane"\) +traction along x +- +-$', table, re.MULTILINE)
    places = bempd.table(model.singularities(), ["kind", "region"])
    assert places.rows and all(row[1] == '1 ("pane")' for row in places.rows)
    assert bempd.table(list(model.singularities()), ["region"]).rows[0] == ["1"]  # a list of one's own knows no names


def test_a_history_has_the_names_of_supports(tmp_path):
    model, rail, peg = named_plate()
    model.step(1)
    model.write_history(tmp_path / "named.csv")
    with open(tmp_path / "named.csv", encoding="utf-8", newline="") as file:
        heading = next(csv.reader(file))
    assert 'reaction_x_1 (rail, "left")' in heading and "displacement_y_2 (peg)" in heading and "work" in heading
    history = bempd.read_history(tmp_path / "named.csv")
    assert history["reaction_x_1"][-1] == pytest.approx(model.reaction(rail)[0], rel=1e-12)
    assert len(history.dtype.names) == len(heading) and sorted(tmp_path.iterdir()) == [tmp_path / "named.csv"]
    # The file of a model without names is the library's own.
    plain = make_plate().model
    plain.step(1)
    plain.write_history(tmp_path / "plain.csv")
    assert "(" not in (tmp_path / "plain.csv").read_text().splitlines()[0]
    with pytest.raises(bempd.FileError):
        model.write_history(tmp_path / "no_folder" / "named.csv")


def test_points_and_cracks_are_in_the_file_of_edges(tmp_path):
    model, _, _ = named_plate()
    model.add_crack([(0, 2), (1, 2)])
    model.add_crack_pressure(1, 1.0)
    model.add_body_force(1, "y", 1.0)
    model.step(1)
    model.write_snapshot(tmp_path / "plate")
    arrays = edges_part(tmp_path / "plate_0000_edges.vtu")
    assert arrays["crack"] == [0] * 4 + [1, 0] and arrays["region"] == [1] * 4 + [0, 0] and arrays["types"] == [4] * 5 + [1]
    held = arrays["supports and loads"]
    assert held[3] == 'support 1 ("rail, "left""), load 3' and held[4] == "load 2" and held[5] == 'support 2 ("peg")'
