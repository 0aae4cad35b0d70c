#ifndef LATTICEWORLD_TESTS_SIMULATION_BATTLE_BATTLE_H_
#define LATTICEWORLD_TESTS_SIMULATION_BATTLE_BATTLE_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

// Hills of 128 m with thin and thick trees, a lake, a gate, a bridge, crates and stones.
std::shared_ptr<const Scene> BattleScene();

// Some 100 agents in it: goblins against warriors, each team with a policy of its own, dogs and
// vehicles in between, sheep that flee, and a tractor that is driven into the trees.
std::unique_ptr<Simulator> BeginBattle(std::shared_ptr<const Scene> scene, std::uint64_t seed,
                                       int physics_threads = 0);

// One step, before it whatever somebody outside does in that step of the episode: commands, joints,
// blows, gates, weather, agents that come and go.
void StepBattle(Simulator* simulator);
// Steps until that step of the episode and adds the state's hash every 500 steps.
void RunBattle(Simulator* simulator, std::uint64_t episode_step, std::vector<std::string>* hashes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SIMULATION_BATTLE_BATTLE_H_
