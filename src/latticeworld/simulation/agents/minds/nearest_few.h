#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_NEAREST_FEW_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_NEAREST_FEW_H_

#include <array>
#include <cstddef>

#include "latticeworld/simulation/agents/agent.h"

namespace latticeworld {

// The nearest kMost of all agents that it is offered, nearest first; equally near ones stay in the
// order in which they came.
template <std::size_t kMost>
class NearestFew {
 public:
  struct Entry {
    double distance_m = 0.0;
    const Agent* agent = nullptr;
  };

  void Offer(const Agent& agent, double distance_m) {
    if (size_ == kMost && distance_m >= entries_[size_ - 1].distance_m) return;
    std::size_t at = size_ < kMost ? size_++ : size_ - 1;
    for (; at > 0 && entries_[at - 1].distance_m > distance_m; --at)
      entries_[at] = entries_[at - 1];
    entries_[at] = {distance_m, &agent};
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Entry& operator[](std::size_t i) const { return entries_[i]; }
  const Entry* begin() const { return entries_.data(); }
  const Entry* end() const { return entries_.data() + size_; }

 private:
  std::array<Entry, kMost> entries_;
  std::size_t size_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_NEAREST_FEW_H_
