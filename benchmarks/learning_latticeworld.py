"""Our part of learning_peers.py: learning_latticeworld.py LAND SEED SECONDS [WORLDS [THREADS]].

The same land and robot, in WORLDS worlds side by side; what it says of decisions is of all together.
"""

import sys
import time

import numpy as np
from learning_world import EPISODE, RANGE_M, RAYS, STEP_S, STEPS, actions, report

import latticeworld as lw
from latticeworld import memory

folder, seed, seconds = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])
count = int(sys.argv[4]) if len(sys.argv) > 4 else 16
threads = int(sys.argv[5]) if len(sys.argv) > 5 else 1


def load(number):
    """Each has its own copy of the world: none is shared."""
    used.append(memory.used())
    return lw.World.load(f"{folder}/world")


used = []
env = lw.make_vec(count, worlds=load, sensors=lw.Scanner(beams=RAYS, max_range_m=RANGE_M),
                  sectors=RAYS, max_range_m=RANGE_M, steps_per_action=STEPS, max_actions=EPISODE,
                  settle_steps=10, threads=threads, autoreset_mode="SameStep", copy=False,
                  task=lambda robot: lw.GoalTask(goal=(1000.0, 0.0)),
                  simulation=dict(step_s=STEP_S))
env.reset(seed=seed)
wanted = [actions(seed + i) for i in range(count)]


def episode():
    speed_mps, seen = 0.0, 0.0
    for _ in range(EPISODE):
        scan = env.step(np.array([next(one) for one in wanted]))[0]["scan"]
        speed_mps += float(env.batch.rows()[:, 0, 4].mean()) / EPISODE
        seen += float((scan < RANGE_M).mean()) / EPISODE
    return speed_mps, seen


episode()
episodes, begin, cpu = [], time.perf_counter(), time.process_time()
while time.perf_counter() - begin < seconds:
    episodes.append(episode())
each = (memory.used() - used[2]) / (count - 2) if count > 3 else 0.0
speed_mps, seen = np.mean(episodes, axis=0)
report(count * EPISODE * len(episodes), time.perf_counter() - begin, time.process_time() - cpu,
       speed_mps, seen, mb_a_further_world=each / 1e6)
