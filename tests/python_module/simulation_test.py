"""latticeworld.Simulation: steps, commands, scans, snapshots."""

import math
import multiprocessing
import os
import signal
import threading

import numpy as np
import pytest

import latticeworld as lw


def drive(simulation, calls=10):
    hashes = []
    for call in range(calls):
        simulation.command("robot", 1.0, math.sin(call))
        simulation.step(10)
        hashes.append(simulation.hash())
    return hashes, simulation.scan("robot").tobytes()


def test_the_same_seed_and_calls_give_the_same_bits(world):
    first = drive(lw.Simulation(world, seed=5))
    assert first == drive(lw.Simulation(world, seed=5))
    assert first[0] != drive(lw.Simulation(world, seed=6))[0]
    simulation = lw.Simulation(world, seed=1)
    drive(simulation, 3)
    simulation.reset(5)
    assert first == drive(simulation)


def test_a_restored_snapshot_goes_on_as_it_did(world):
    simulation = lw.Simulation(world)
    drive(simulation, 3)
    snapshot = simulation.snapshot()
    hashes, _ = drive(simulation)
    for _ in range(2):
        simulation.restore(snapshot)
        assert hashes == drive(simulation)[0]


def test_a_snapshot_of_another_world_is_refused(worlds):
    snapshot = lw.Simulation(worlds[1]).snapshot()
    with pytest.raises(ValueError, match="another world"):
        lw.Simulation(worlds[0]).restore(snapshot)


def test_a_command_drives_the_robot_until_it_is_old(world):
    simulation = lw.Simulation(world)
    simulation.step(50)
    begin = simulation.agent("robot")["position_m"]
    simulation.command("robot", 1.0)
    simulation.step(300)
    agent = simulation.agent("robot")
    moved = math.dist(begin[:2], agent["position_m"][:2])
    assert 0.2 < moved < 1.0  # of half a second
    assert simulation.episode_step == 350
    assert agent["linear_velocity_mps"][0] == pytest.approx(0.0, abs=0.02)


def test_the_scan_sees_what_is_put_before_the_robot(world):
    simulation = lw.Simulation(world, sensors=lw.Scanner(beams=360, max_range_m=30.0))
    assert simulation.scan("robot") is None
    simulation.step(20)
    x, y, _, yaw, *_ = simulation.view("robot")
    before = simulation.sectors("robot", 36, 20.0)
    simulation.spawn_element("crate", x + 2.0 * math.cos(yaw), y + 2.0 * math.sin(yaw), yaw, "box")
    simulation.step(10)
    after = simulation.sectors("robot", 36, 20.0)
    assert simulation.scan("robot").shape == (360,)
    assert 1.0 < after[18] < 2.0 < before[18]
    assert simulation.scanner["beams"] == 360


def test_agents_come_and_go(world):
    simulation = lw.Simulation(world)
    name = simulation.spawn("scout", "wheeled robot", (-6.0, 4.0))
    assert name == "scout" and simulation.agents == ["robot", "scout"]
    simulation.remove("scout")
    assert simulation.agents == ["robot"]


@pytest.mark.parametrize("call, error, words", [
    (lambda s: s.command("nobody", 1.0), lw.NotFound, "nobody"),
    (lambda s: s.command("robot", math.nan), ValueError, "finite"),
    (lambda s: s.command("robot", "fast"), TypeError, "incompatible"),
    (lambda s: s.step(0), ValueError, "steps is 0; legal is at least 1"),
    (lambda s: s.step(10, ["nobody"]), lw.NotFound, "no agent \"nobody\"; there are: robot"),
    (lambda s: s.spawn("x", "unicorn"), ValueError, "species: \"unicorn\" is unknown; legal are"),
    (lambda s: s.spawn("robot", position_m=(1.0, 1.0)), ValueError, "robot"),
    (lambda s: s.spawn("x", place="the moon"), ValueError, "place: \"the moon\" is unknown"),
    (lambda s: s.spawn("a b", "unicorn", (math.nan, 0.0), "", math.inf, team=-7), ValueError,
     "5 violations.*name.*species.*position_m.*heading_rad.*-7.*1 .. 15"),
    (lambda s: s.spawn("a b", place="the moon"), ValueError, "the moon.*upper left.*name"),
    (lambda s: s.spawn_element("castle", 0, 0), ValueError, "\"castle\" is unknown; legal are"),
    (lambda s: s.spawn_element("castle", math.nan, 0, math.inf, "a b"), ValueError,
     "4 violations.*castle.*name.*heading_rad.*x_m"),
    (lambda s: s.remove("nobody"), lw.NotFound, "nobody"),
    (lambda s: s.agent("nobody"), lw.NotFound, "nobody"),
    (lambda s: s.sectors("robot", 0, 20.0), ValueError, "sectors"),
])
def test_what_is_wrong_is_said_and_changes_nothing(world, call, error, words):
    simulation = lw.Simulation(world)
    simulation.step(5)
    before = simulation.hash()
    with pytest.raises(error, match=words):
        call(simulation)
    assert simulation.hash() == before


def test_what_it_is_made_with_is_checked(world):
    for sensors, error, words in (("eyes", ValueError, "no sensor suite \"eyes\"; legal are"),
                                  ("none", ValueError, "no 2D lidar"), (7, TypeError, "Scanner"),
                                  (lw.Scanner(beams=0), ValueError, "columns")):
        with pytest.raises(error, match=words):
            lw.Simulation(world, sensors=sensors)
    with pytest.raises(ValueError, match="step_s"):
        lw.Simulation(world, step_s=7.0)
    with pytest.raises(lw.LatticeWorldError, match="without sensors"):
        lw.Simulation(world, sensors=None).scan("robot")


def interrupt_once_it_steps(simulation):
    """Ctrl-C, once another thread is refused because the simulation is in a call."""
    while True:
        try:
            simulation.agents
        except lw.LatticeWorldError:
            os.kill(os.getpid(), signal.SIGINT)
            return


def test_ctrl_c_ends_many_steps_between_two_of_them(world):
    simulation = lw.Simulation(world)
    thread = threading.Thread(target=interrupt_once_it_steps, args=(simulation,))
    with pytest.raises(KeyboardInterrupt):
        thread.start()
        while True:  # until they meet
            try:
                simulation.step(100_000_000)
            except lw.LatticeWorldError:
                pass
    thread.join()
    at = simulation.episode_step
    simulation.step(10)
    assert simulation.episode_step == at + 10


def test_two_threads_in_one_simulation_are_refused(world):
    simulation = lw.Simulation(world)
    refused = []
    ready, done = threading.Event(), threading.Event()

    def knock():
        ready.set()
        while not done.is_set():
            try:
                simulation.command("robot", 1.0)
            except lw.LatticeWorldError as error:
                refused.append(str(error))

    thread = threading.Thread(target=knock)
    thread.start()
    ready.wait()
    while not refused:
        try:
            simulation.step(200)
        except lw.LatticeWorldError as error:  # the other thread was in it
            refused.append(str(error))
    done.set()
    thread.join()
    assert "another thread" in refused[0]


def step_in_child(simulation, pipe):
    try:
        simulation.step(1)
        pipe.send("it stepped")
    except RuntimeError as error:
        pipe.send(str(error))


def test_after_a_fork_it_is_said_what_to_do(world):
    simulation = lw.Simulation(world)
    simulation.step(20)  # its rays' scene is made
    ours, theirs = multiprocessing.Pipe()
    process = multiprocessing.get_context("fork").Process(target=step_in_child,
                                                          args=(simulation, theirs))
    process.start()
    process.join(30)
    assert process.exitcode == 0
    assert "forked off" in ours.recv()
    simulation.step(1)


def test_events_are_told(world):
    simulation = lw.Simulation(world)
    x, y, _, yaw, *_ = simulation.view("robot")
    simulation.spawn_element("crate", x + 1.2 * math.cos(yaw), y + 1.2 * math.sin(yaw), yaw)
    kinds = []
    for _ in range(30):
        simulation.command("robot", 1.5)
        simulation.step(10)
        kinds += [event["kind"] for event in simulation.events if event["agent"] == "robot"]
    assert "collided" in kinds
    assert np.isfinite(simulation.view("robot")).all()
