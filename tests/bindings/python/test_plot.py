"""Pictures show what the model says; they are not compared dot by dot."""

import bempd
import matplotlib.pyplot as plt
import numpy as np
import pytest
from bempd import _bodies, _drawing, plot, rectangle
from conftest import make_plate


@pytest.fixture(autouse=True)
def closed_figures():
    yield
    plt.close("all")


def body(model, region, resolution=10):
    return _bodies.bodies(model, resolution)[region - 1]


def areas(found):
    corners = found.points[found.triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / 2


def test_quantities_are_known_by_what_users_write():
    for written in ("von_mises", "von Mises", "Stress_von_Mises", "stress von mises"):
        assert bempd.plot.chosen_quantity("draw", written) == "stress von Mises"
    with pytest.raises(bempd.ArgumentError, match="it must be one of"):
        bempd.plot.chosen_quantity("draw", "mises stress")


@pytest.mark.parametrize("quantity, magnification", [*((one, 0) for one in _drawing.QUANTITIES),
                                                     *((one, "auto") for one in ("outline", "lattice", "damage", "displacement"))])
def test_every_quantity_is_drawn_to_scale(strip, quantity, magnification, tmp_path):
    strip.model.step_to_next_event(1e4)
    axes = strip.model.plot(quantity, magnification=magnification)
    axes.figure.savefig(tmp_path / "picture.png")
    assert axes.get_aspect() == 1 and axes.get_xlabel() == "x [mm]" and quantity.lower() in axes.get_title().lower()
    left, right = axes.get_xlim()
    assert left < 0 and right > 60
    labels = [bar.get_ylabel() for bar in axes.child_axes]
    unit = {"damage": " [-]", "displacement": " [\u00b5m]", "stress": " [MPa]"}.get(quantity.split()[0])
    assert labels == ([quantity + unit] if unit else [])


@pytest.mark.parametrize("short, name", [("von Mises", "Stress von Mises"), ("xy", "Stress xy"), ("x", "Displacement x")])
def test_short_words_name_quantities(strip, short, name):
    assert strip.model.plot(short).get_title().startswith(name)


def test_triangles_fill_the_body_and_nothing_else():
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=0.3)
    region = model.add_bem_region(glass, [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)], 0.25)
    model.add_hole(region, [(0.25, 0.25), (0.25, 0.75), (0.75, 0.75), (0.75, 0.25)])
    model.fix_edge(region, 1)
    assert areas(body(model, region)).sum() == pytest.approx(5 - 0.25, rel=1e-9)


def test_values_inside_are_those_of_the_solution():
    scene = make_plate()
    scene.model.add_traction(scene.plate, 2, "x", 2e8)
    scene.model.step(1)
    found = body(scene.model, scene.plate)
    np.testing.assert_allclose(_bodies.quantity_values(found, "stress xx"), 2e8, rtol=1e-6)
    np.testing.assert_allclose(_bodies.quantity_values(found, "stress principal"), 2e8, rtol=1e-6)
    np.testing.assert_allclose(_bodies.quantity_values(found, "displacement x"), 1e-3 * found.points[:, 0], atol=1e-11)


def crack_of(points):
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3)
    plate = model.add_pd_region(glass, rectangle(0, 0, 10, 10), spacing=1, horizon_ratio=3)
    model.add_crack(points)
    model.fix_edge(plate, 2)
    model.fix_edge(plate, 4)
    return body(model, plate).crack


def test_the_crack_line_lies_on_the_crack():
    segments = crack_of([(4.5, 0), (4.5, 5.2)])
    assert (segments[..., 0] == 4.5).all() and segments[..., 1].min() == 0
    assert 4.5 <= segments[..., 1].max() <= 6  # the cut ends up to 0.6 spacings before the described tip
    assert np.abs(segments[:, 1] - segments[:, 0]).sum() == pytest.approx(segments[..., 1].max())


def test_the_line_of_an_inclined_crack_is_near_it():
    segments = crack_of([(0.2, 0.4), (9.3, 9.5)])
    assert len(segments) > 8 and np.abs(segments[..., 1] - segments[..., 0] - 0.2).max() <= 1


def cracked_plate(*cracks, cut=False):
    """A plate of boundary elements, 2 by 4, pulled upwards; its cracks stay as they are."""
    model = bempd.Model(log=None)
    glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2)
    plate = model.add_bem_region(glass, rectangle(-1, -2, 1, 2), element_length=0.5)
    for points in cracks:
        model.add_crack(points)
    model.fix_edge(plate, 1)
    if cut:
        model.prescribe_edge(plate, 3, "x", 0.0)
        model.prescribe_edge(plate, 3, "y", 1e-4)
    else:
        model.add_traction(plate, 3, "y", 1e6)
    model.step(1)
    return model, plate


CRACKED = {"inside": [[(-0.4, -0.1), (0.3, 0.1)]], "edge": [[(-1, 0), (-0.3, 0)]], "from the right": [[(1, 0), (0.5, 0.2), (0.2, 0.2)]],
           "branch": [[(-0.4, 0), (0.4, 0)], [(0, 0), (0.2, 0.4)]], "cut": [[(-1, 0), (1, 0.3)]]}


@pytest.mark.parametrize("kind", CRACKED)
def test_cracks_in_boundary_elements_part_the_picture(kind):
    model, plate = cracked_plate(*CRACKED[kind], cut=kind == "cut")
    found = body(model, plate)
    assert areas(found).sum() == pytest.approx(8, rel=1e-6), "triangles fill the body"
    lengths = np.hypot(*(found.crack[:, 1] - found.crack[:, 0]).T)
    assert lengths.sum() == pytest.approx(sum(np.hypot(*np.diff(np.array(points), axis=0).T).sum() for points in CRACKED[kind]))
    # No triangle joins the two faces: just above the first crack everything has moved further up than just below it.
    (a, b), centres = np.array(CRACKED[kind][0][:2]), found.points[found.triangles].mean(axis=1)
    along = (centres - a) @ (b - a) / np.dot(b - a, b - a)
    side = np.cross(b - a, centres - a) * np.sign(b[0] - a[0]) / np.hypot(*(b - a))
    near = (along > 0.35) & (along < 0.65) & (np.abs(side) < 0.12)
    moved = found.displacement[found.triangles][..., 1]
    assert (near & (side > 0)).any() and (near & (side < 0)).any()
    assert moved[near & (side > 0)].min() > moved[near & (side < 0)].max()
    assert len(model.plot("displacement", magnification="auto").collections) > 1


def test_faces_in_the_picture_open_as_the_crack_does():
    model, plate = cracked_plate(CRACKED["edge"][0])
    found = body(model, plate)
    left, right = found.faces
    at = (found.points[left][:, 0] + 1) / 0.7
    opening = model.crack_opening(1, at[1:-1]).normal
    jump = found.displacement[left][1:-1, 1] - found.displacement[right][1:-1, 1]
    np.testing.assert_allclose(jump, opening, rtol=1e-6, atol=1e-3 * opening.max())
    # The mouth is open: the outline begins on one of its lips and ends on the other, and no line closes it.
    (outline,) = found.outline
    lips = found.points[outline[[0, -1]]]
    np.testing.assert_allclose(lips, [(-1, 0), (-1, 0)], atol=1e-12)
    moved = found.displacement[outline[[0, -1]], 1]
    assert abs(moved[0] - moved[1]) > jump[0] and {int(left[0]), int(right[0])} == set(outline[[0, -1]].tolist())


def test_a_crack_that_grows_is_drawn_as_it_is():
    model = bempd.Model()
    glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2, fracture_energy=8)
    plate = model.add_bem_region(glass, rectangle(-1, -2, 1, 2), element_length=0.5)
    model.add_crack([(-1, 0), (-0.3, 0)])
    model.fix_edge(plate, 1)
    model.add_traction(plate, 3, "y", 1e6)
    for _ in range(2):
        model.grow_cracks(0.1)
    found = body(model, plate)
    assert np.hypot(*(found.crack[:, 1] - found.crack[:, 0]).T).sum() == pytest.approx(model.crack_length())
    assert areas(found).sum() == pytest.approx(8, rel=1e-6)


@pytest.mark.parametrize("plane, across", [("stress", 0), ("strain", 0.3)])
def test_principal_and_von_mises_stress(plane, across):
    model = bempd.Model()
    steel = model.add_material(young_modulus=2e11, poisson_ratio=0.3, plane=plane)
    plate = model.add_bem_region(steel, rectangle(0, 0, 2, 1), element_length=0.5)
    model.fix_edge(plate, 4, "x"), model.fix_point((0, 0), "y")
    model.add_traction(plate, 2, "x", 2e8)
    model.step(1)
    found = body(model, plate)
    expected = 2e8 * np.sqrt(1 - across + across**2)
    np.testing.assert_allclose(_bodies.quantity_values(found, "stress von Mises"), expected, rtol=1e-6)
    np.testing.assert_allclose(_bodies.quantity_values(found, "stress smallest principal"), 0, atol=200)
    hot = bempd.Model()
    region = hot.add_pd_region(hot.add_material(young_modulus=1, poisson_ratio=0.3, plane=plane, thermal_expansion=1), rectangle(0, 0, 4, 4), 1)
    hot.fix_edge(region, 4), hot.add_temperature(region, 1)
    if across:
        with pytest.raises(bempd.ArgumentError, match="von Mises stress of a heated region in plane strain"):
            hot.plot("stress von Mises")
    else:
        hot.plot("stress von Mises")


def test_limits_and_given_axes(strip):
    strip.model.step(50)
    _, axes = plt.subplots()
    assert strip.model.plot("stress xx", axes=axes, limits=(0, 1e7), colour_bar=False) is axes
    assert not axes.child_axes


def test_wrong_requests_are_explained(strip):
    with pytest.raises(bempd.ArgumentError, match="quantity is 'heat'.*'damage'"):
        strip.model.plot("heat")
    with pytest.raises(bempd.ArgumentError, match="magnification is 'big'"):
        strip.model.plot("damage", magnification="big")
    with pytest.raises(bempd.ArgumentError, match="resolution is 0"):
        strip.model.plot("damage", resolution=0)
    with pytest.raises(bempd.OrderError, match="no region"):
        bempd.Model().plot()
    with pytest.raises(bempd.OrderError, match="no history"):
        plot.load_displacement(strip.model, strip.pulled)
    with pytest.raises(bempd.ArgumentError, match="support is 9"):
        plot.load_displacement(strip.model, 9)


def test_the_load_curve_is_the_history(strip):
    strip.model.step(50)
    force = strip.model.reaction(strip.pulled)[0]
    report = strip.model.run_to_separation(1e4)
    axes = plot.load_displacement(strip.model, strip.pulled, displacement=1e-6)
    x, y = axes.lines[0].get_data()
    assert axes.get_xlabel() == "imposed displacement [\u00b5m]" and axes.get_ylabel() == "force [N]"
    assert x[1] == pytest.approx(50) and y[1] == pytest.approx(force)
    assert x[-1] == pytest.approx(report.load_factor) and abs(y[-1]) < 1e-6 * y.max()
    assert "first break" in axes.get_legend().get_texts()[0].get_text()


def test_the_load_curve_takes_what_the_support_prescribes(strip):
    strip.model.run_to_separation(1e4)
    axes = plot.load_displacement(strip.model, strip.pulled)
    x, y = axes.lines[0].get_data()
    assert axes.get_xlabel() == "imposed displacement [\u00b5m]" and x.max() == pytest.approx(strip.model.load_factor)
    assert y.max() > 100
    plt.close("all")


def test_a_support_moved_along_y_has_its_own_curve():
    model = bempd.Model()
    steel = model.add_material(young_modulus=2e11, poisson_ratio=0.3)
    plate = model.add_bem_region(steel, rectangle(0, 0, 2, 1), element_length=0.5)
    held = model.fix_edge(plate, 1)
    pressed = model.prescribe_edge(plate, 3, "y", -1e-3)
    model.step(1)
    axes = plot.load_displacement(model, pressed)
    x, y = axes.lines[0].get_data()
    assert axes.get_xlabel() == "imposed displacement [mm]" and x[-1] == pytest.approx(-1) and np.ptp(y) > 0
    # One that is held, not moved, has the force that it feels, over the load factor.
    axes = plot.load_displacement(model, held)
    x, force = axes.lines[0].get_data()
    assert axes.get_xlabel() == "load factor [-]" and x[-1] == 1 and force[-1] == pytest.approx(y[-1])
    plt.close("all")


def test_contours_stop_at_an_open_crack(strip):
    strip.model.step(100)
    _, axes = plt.subplots()
    strip.model.plot("displacement x", axes=axes)
    found = body(strip.model, strip.middle)
    cut = found.points[found.cells[found.cut]].mean(axis=1)
    assert len(cut)
    # No contour covers the middle of a cell that the crack cuts; its quarters do, each in the colour of its corner.
    scale = 1e3  # the axes are in millimetres
    contours = [path for filled in axes.collections if type(filled).__name__ == "PathCollection" for path in filled.get_paths()]
    assert contours and not any(path.contains_point(scale * middle) for path in contours for middle in cut)
    quarters = [paths for paths in axes.collections if type(paths).__name__ == "PolyCollection" and len(paths.get_paths()) == 4 * len(cut)]
    assert len(quarters) == 1 and np.ptp(quarters[0].get_array()) > 0
    plt.close("all")


def test_a_movie_keeps_what_moves_in_sight(strip, tmp_path):
    strip.model.step(100)
    found = plot.bodies(strip.model, 5)
    low, high = plot.view_of(found, 40)
    shown = np.concatenate([one.shown(40) for one in found])
    assert (shown.min(axis=0) >= low).all() and (shown.max(axis=0) <= high).all()
    assert high[0] > 0.06 + 40 * 100e-6
    low, high = plot.view_of(found, 1e6)
    assert high[0] < 0.06 + 0.06 * 0.6, "what flies away does not make the body small"


def test_a_movie_has_its_frames(strip, tmp_path):
    from PIL import Image

    before = plt.get_fignums()
    with plot.Movie(tmp_path / "crack.gif", strip.model, magnification=20) as movie:
        for _ in range(3):
            strip.model.step_to_next_event(1e4)
            movie.add_frame()
    assert plt.get_fignums() == before
    with Image.open(tmp_path / "crack.gif") as picture:
        assert picture.n_frames == 3
        lengths = []
        for frame in range(3):
            picture.seek(frame)
            lengths.append(picture.info["duration"])
        assert lengths[0] == lengths[1] == 100 and lengths[2] == 2000, "the last frame is held"
    with plot.Movie(tmp_path / "none.gif", strip.model):
        pass
    assert not (tmp_path / "none.gif").exists()


def test_a_movie_is_what_its_name_says(strip, tmp_path, monkeypatch):
    import shutil

    for name in ("crack.avi", "crack"):
        with pytest.raises(bempd.ArgumentError, match="a film is written as .gif or .mp4"):
            plot.Movie(tmp_path / name, strip.model)
    if shutil.which("ffmpeg"):
        with plot.Movie(tmp_path / "crack.mp4", strip.model, hold=0.5) as movie:
            for _ in range(2):
                strip.model.step_to_next_event(1e4)
                movie.add_frame()
        assert (tmp_path / "crack.mp4").read_bytes()[4:8] == b"ftyp"
        with pytest.raises(bempd.FileError, match="ffmpeg could not write"):
            with plot.Movie(tmp_path / "no folder" / "crack.mp4", strip.model) as movie:
                movie.add_frame()
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(bempd.ArgumentError, match="needs the program ffmpeg.*apt install ffmpeg.*or write a .gif"):
        plot.Movie(tmp_path / "crack.mp4", strip.model)
