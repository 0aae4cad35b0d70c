#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_SEARCH_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_SEARCH_H_

#include <cstdint>
#include <vector>

#include "latticeworld/simulation/agents/ways/path_layer.h"

namespace latticeworld {

struct CellPath {
  std::vector<CellIndex> cells;  // from start to end, both included; empty: the start is not free
  bool complete = false;         // ends at the goal; else at the cell nearest to it
  double cost = 0.0;             // lengths in cells, each times the mean hardship of its two cells
  int expanded = 0;
};

// Cheapest ways over a layer in steps to the eight neighbours, none across the corner of a cell
// that is not free: A* (Hart, Nilsson and Raphael 1968) with the octile distance. Among equals it
// prefers what is nearer to the goal, then the cell of lower number, so that an answer depends on
// the layer and the question alone. It counts in whole numbers, so that equals are equal. Keeps its
// memory from search to search.
class PathSearch {
 public:
  PathSearch();

  // max_nodes: expands no more than so many; the best way to the nearest cell that was reached is
  // the answer then, as it is where no way leads to the goal. greed_percent: what is left is taken
  // for so much of the octile distance (Pohl 1970, Heuristic search viewed as path finding in a
  // graph): 100 finds the cheapest way; more expands fewer cells, and the way costs at most so much
  // of the cheapest one.
  CellPath Find(PathLayer* layer, CellIndex from, CellIndex to, int max_nodes,
                int greed_percent = 100);

 private:
  using Cost = std::int64_t;  // a step of 1 on level open ground: kStep in path_search.cc
  struct Node {
    std::uint32_t cell;
    std::uint32_t parent;  // index into nodes_; of the first one: itself
    Cost cost;
    Cost to_goal;  // no more than what is left
    bool closed;
  };
  struct Slot {
    std::uint32_t search = 0;  // that it was used in last
    std::uint32_t node = 0;
  };
  struct Open {
    Cost total, to_goal;
    std::uint32_t cell, node;
  };
  static bool IsLater(const Open& a, const Open& b);
  std::uint32_t& SlotOf(std::uint32_t cell, bool* taken);
  void Grow();
  void Reach(std::uint32_t cell, std::uint32_t parent, Cost cost, Cost to_goal);

  std::vector<Node> nodes_;  // of this search, as they were found
  std::vector<Slot> slots_;  // hash table of nodes by cell; its size is a power of two
  std::vector<Open> open_;   // heap
  std::uint32_t search_ = 0;
  int greed_percent_ = 100;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_SEARCH_H_
