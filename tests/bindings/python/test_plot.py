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


@pytest.mark.parametrize("quantity", _drawing.QUANTITIES)
@pytest.mark.parametrize("magnification", [0, "auto"])
def test_every_quantity_is_drawn_to_scale(strip, quantity, magnification, tmp_path):
    strip.model.step_to_next_event(1e4)
    axes = strip.model.plot(quantity, magnification=magnification)
    axes.figure.savefig(tmp_path / "picture.png")
    assert axes.get_aspect() == 1 and axes.get_xlabel() == "x [mm]" and quantity in axes.get_title().lower()
    left, right = axes.get_xlim()
    assert left < 0 and right > 60
    labels = [bar.get_ylabel() for bar in axes.child_axes]
    unit = {"damage": " [-]", "displacement": " [\u00b5m]", "stress": " [MPa]"}.get(quantity.split()[0])
    assert labels == ([quantity + unit] if unit else [])


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
    assert (segments[..., 0] == 4.5).all() and segments[..., 1].min() == 0 and 5 <= segments[..., 1].max() <= 6
    assert np.abs(segments[:, 1] - segments[:, 0]).sum() == pytest.approx(segments[..., 1].max())


def test_the_line_of_an_inclined_crack_is_near_it():
    segments = crack_of([(0.2, 0.4), (9.3, 9.5)])
    assert len(segments) > 8 and np.abs(segments[..., 1] - segments[..., 0] - 0.2).max() <= 1


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
