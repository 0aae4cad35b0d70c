// Fights the battle of the determinism tests for so many steps and prints the state's hashes, one a
// line: for a test that compares two processes.
//   battle_run SEED STEPS

#include <cstdlib>
#include <iostream>

#include "simulation/battle/battle.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto simulator =
      latticeworld::BeginBattle(latticeworld::BattleScene(), std::strtoull(argv[1], nullptr, 10));
  std::vector<std::string> hashes;
  latticeworld::RunBattle(simulator.get(), std::strtoull(argv[2], nullptr, 10), &hashes);
  for (const std::string& hash : hashes) std::cout << hash << "\n";
  return 0;
}
