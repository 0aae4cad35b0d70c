"""PettingZoo checks the environments of several robots, some of which die, and its wrappers take
them."""
# module: latticeworld
# pypi: pettingzoo==1.27.0 gymnasium==1.4.0 numpy==2.4.6

import importlib.metadata

import numpy
from pettingzoo.test import api_test, parallel_api_test, parallel_seed_test
from pettingzoo.utils.conversions import parallel_to_aec

import latticeworld as lw
from meadow import meadow
from peer import Peer

SPAWN = {"scout": dict(position=(-6.0, 4.0))}
ROBOTS = ["robot", "scout"]


class Fragile(lw.GoalTask):
    """The robot is dead for its task after so many actions, as one that a goblin has struck."""

    def __init__(self, actions):
        super().__init__()
        self.left = self.actions = actions

    def begin(self, view, rng, server):
        self.left = self.actions
        super().begin(view, rng, server)

    def judge(self, before, after):
        reward, ends, info = super().judge(before, after)
        self.left -= 1
        return reward, ends or self.left == 0, info


def mortal(robot):
    return Fragile(3 if robot.endswith("scout") else 6)


def make(world, **options):
    return lw.make_parallel(world, ROBOTS, spawn=SPAWN, **{"max_actions": 12, **options})


def check_death(peer, env):
    """Who is in `agents` after every step, and whether only those are answered for."""
    env.reset(seed=1)
    course, whole = [], True
    while env.agents:
        acting = list(env.agents)
        answers = env.step({agent: env.action_space(agent).sample() for agent in acting})
        whole = whole and all(set(answer) == set(acting) for answer in answers)
        ended = {agent for agent in acting if answers[2][agent] or answers[3][agent]}
        whole = whole and set(env.agents) == set(acting) - ended
        course.append(len(env.agents))
    peer.check("death of agents", whole and course == [2, 2, 1, 1, 1, 0],
               f"agents left after each step: {course}; answers for those alone that acted")


def main():
    peer = Peer("PettingZoo", importlib.metadata.version("pettingzoo"),
                "`make_parallel`, `make_vec(interface=\"pettingzoo\")`")
    world = lw.World.load(str(meadow()))
    for name, env in (("make_parallel", make(world)), ("with a task that kills", make(world, task=mortal)),
                      ("make_vec", lw.make_vec(2, ROBOTS, interface="pettingzoo", worlds=[world],
                                               spawn=SPAWN, max_actions=12))):
        parallel_api_test(env, num_cycles=20)
        peer.check(f"parallel_api_test of {name}", True, "nothing wrong")
    parallel_seed_test(lambda: make(world), num_cycles=5)
    peer.check("parallel_seed_test", True, "nothing wrong")
    check_death(peer, make(world, task=mortal))
    turns = parallel_to_aec(make(world, task=mortal))
    api_test(turns, num_cycles=20)
    peer.check("api_test of parallel_to_aec", True, "nothing wrong")
    turns.reset(seed=1)
    steps = {}
    for agent in turns.agent_iter():
        *_, ended, cut, _ = turns.last()
        steps[agent] = steps.get(agent, 0) + (not (ended or cut))
        turns.step(None if ended or cut else numpy.zeros(2, "f4"))
    peer.check("turns until the dead have left", steps == {"robot": 6, "scout": 3}, str(steps))
    peer.finish()


main()
