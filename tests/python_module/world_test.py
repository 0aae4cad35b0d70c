"""latticeworld.World: worlds and views of their grids."""

import gc
import json
import signal
import threading
import weakref

import numpy as np
import pytest
from conftest import ENVIRONMENT, LAYOUT

import latticeworld as lw


def test_the_same_request_gives_the_same_world(world):
    again = lw.World.generate(LAYOUT, ENVIRONMENT, seed=3, size_m=64.0)
    other = lw.World.generate(LAYOUT, ENVIRONMENT, seed=4, size_m=64.0)
    assert again.id == world.id and again.seed == 3
    assert np.array_equal(again.heights, world.heights)
    assert other.id != world.id


def test_grids_are_views_of_the_worlds_own_memory(world):
    for name, dtype in (("heights", np.float32), ("water_level", np.float32),
                        ("surface", np.uint8), ("occupancy", np.int8)):
        view = getattr(world, name)
        assert view.shape == (128, 128) and view.dtype == dtype
        assert np.shares_memory(view, getattr(world, name)), f"{name} was copied"
        with pytest.raises(ValueError, match="read-only"):
            view[0, 0] = 1
    assert 0 <= world.surface.max() < len(lw.SURFACES)


def test_the_occupancy_is_for_the_footprint_of_a_species(world):
    assert np.shares_memory(world.occupancy, world.occupancy_for("wheeled robot"))
    car = world.occupancy_for("ackermann car")
    assert np.shares_memory(car, world.occupancy_for("ackermann car"))
    closed, closed_for_car = world.occupancy == 100, car == 100
    assert (closed_for_car | ~closed).all() and closed_for_car.sum() > closed.sum()
    server = lw.LocalServer(world, robot_species="ackermann car")
    assert np.array_equal(np.reshape(server.occupancy().data, car.shape)[::-1], car)
    with pytest.raises(ValueError, match="flying carpet.*legal are.*ackermann car"):
        world.occupancy_for("flying carpet")


def test_a_view_keeps_its_world_alive():
    world = lw.World.generate(LAYOUT, ENVIRONMENT, seed=9, size_m=64.0)
    expected = world.heights.copy()
    heights = world.heights
    del world
    gc.collect()
    lw.World.generate(LAYOUT, ENVIRONMENT, seed=10, size_m=64.0)  # would take the memory
    assert np.array_equal(heights, expected)


def test_heights_are_those_of_the_ground(world):
    half_m, cell_m = 0.5 * world.size_m, world.resolution_m
    for row, column in ((0, 0), (5, 100), (127, 64)):
        x, y = -half_m + (column + 0.5) * cell_m, half_m - (row + 0.5) * cell_m
        assert world.height_at(x, y) == pytest.approx(world.heights[row, column], abs=1e-5)
    with pytest.raises(ValueError, match="no place of the world.*within half its size"):
        world.height_at(1000.0, 0.0)


def test_a_bundle_gives_the_same_world_back(world, tmp_path):
    world.save(tmp_path / "bundle")
    again = lw.World.load(tmp_path / "bundle")
    assert again.id == world.id
    assert np.array_equal(again.heights, world.heights)
    assert again.layout == world.layout and len(again.layout.split()) == 32
    assert json.loads(again.environment_json)["coarse"]["season"] == "summer"
    with pytest.raises(lw.LatticeWorldError, match="exist"):
        world.save(tmp_path / "bundle")


def test_a_bundle_that_is_not_there_is_said(tmp_path):
    with pytest.raises(lw.NotFound, match="nowhere"):
        lw.World.load(tmp_path / "nowhere")
    (tmp_path / "empty").mkdir()
    with pytest.raises(lw.LatticeWorldError):
        lw.World.load(tmp_path / "empty")


def test_worlds_that_cannot_be_made_say_all_that_is_wrong():
    with pytest.raises(ValueError, match="(?s)layout_instruction.*size"):
        lw.World.generate("", "", size_m=-3.0)
    with pytest.raises(ValueError, match="vocabulary"):
        lw.World.generate("Grass.", vocabulary="lunar")
    with pytest.raises(TypeError, match="incompatible function arguments"):
        lw.World.generate(42)
    with pytest.raises(lw.LatticeWorldError, match="missing.png"):
        lw.World.generate("Hills.", height_map="/nowhere/missing.png")


def survey(folder):
    """A file of 20 m x 20 m at (10, 20), cells of 5 cm, from 459 m in the west to 462 m."""
    file = folder / "survey.asc"
    row = " ".join(f"{459.0 + 3.0 * column / 399:.3f}" for column in range(400)) + "\n"
    file.write_text("ncols 400\nnrows 400\nxllcorner 10\nyllcorner 20\ncellsize 0.05\n" + 400 * row)
    return file


def test_elevation_is_read_as_it_is_said(tmp_path):
    def generate(**options):
        return lw.World.generate("Grassland.", elevation=survey(tmp_path), seed=1, size_m=16.0,
                                 resolution_m=0.5, **options)

    metres = generate(elevation_unit="metres")
    assert metres.place is None
    assert not any("taken for" in warning for warning in metres.warnings)
    # 2.4 m over its 16 m; no more than roughness as degrees, for 16 m are nothing of 20 degrees.
    rise_m = metres.heights[:, -1].mean() - metres.heights[:, 0].mean()
    assert rise_m == pytest.approx(2.4, abs=0.3)
    degrees = generate(elevation_unit="degrees")
    assert degrees.place == pytest.approx((30.0, 20.0, 460.5), abs=0.5)
    assert abs(degrees.heights[:, -1].mean() - degrees.heights[:, 0].mean()) < 0.3
    assert any("taken for metres" in warning for warning in generate().warnings)

    there = generate(elevation_unit="degrees", place=(31.5, 12.25), keep_altitude=True)
    assert there.place == pytest.approx((31.5, 12.25, 0.0))
    assert there.heights.mean() == pytest.approx(459.0 + 3.0 * 2.25 / 20.0, abs=0.2)
    with pytest.raises(ValueError, match='elevation_unit is "feet"; legal are degrees, metres'):
        generate(elevation_unit="feet")
    with pytest.raises(ValueError, match="latitude"):
        generate(elevation_unit="degrees", place=(91.0, 0.0))
    for options in (dict(place=(30.0, 20.0)), dict(keep_altitude=True), dict(elevation_unit="metres")):
        with pytest.raises(ValueError, match="of an elevation"):
            lw.World.generate("Grassland.", **options)


def test_what_a_listener_raises_ends_the_generation():
    class Enough(Exception):
        pass

    def listen(stage, fraction):
        heard.append((stage, fraction))
        if stage == "terrain":
            raise Enough

    heard = []
    with pytest.raises(Enough):
        lw.World.generate(LAYOUT, ENVIRONMENT, seed=1, size_m=64.0, progress=listen)
    assert heard and heard[-1][0] == "terrain"


def test_ctrl_c_ends_a_generation(world):
    def interrupt(stage, fraction):
        if stage == "terrain":
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        lw.World.generate(LAYOUT, ENVIRONMENT, seed=1, size_m=256.0, progress=interrupt)
    assert lw.World.generate(LAYOUT, ENVIRONMENT, seed=3, size_m=64.0).id == world.id


def test_pythons_other_threads_go_on_while_a_world_is_made():
    made = threading.Event()
    turns = 0

    def make():
        lw.World.generate(LAYOUT, ENVIRONMENT, seed=2, size_m=256.0)
        made.set()

    thread = threading.Thread(target=make)
    thread.start()
    while not made.is_set():
        turns += 1
    thread.join()
    assert turns > 1


def test_worlds_that_nobody_holds_are_gone():
    world = lw.World.generate(LAYOUT, ENVIRONMENT, seed=9, size_m=64.0)
    simulation = lw.Simulation(world)
    heights = world.heights
    watch = weakref.ref(simulation)
    del world, simulation, heights
    gc.collect()
    assert watch() is None
