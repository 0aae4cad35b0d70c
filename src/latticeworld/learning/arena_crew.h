#ifndef LATTICEWORLD_LEARNING_ARENA_CREW_H_
#define LATTICEWORLD_LEARNING_ARENA_CREW_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/common/work_crew.h"
#include "latticeworld/learning/arena.h"
#include "latticeworld/learning/robot_view.h"

namespace latticeworld {

// What all arenas of a crew have in common.
struct CrewLayout {
  std::vector<std::string> robots;  // by name, in the order of rows
  int sectors = 0;                  // of an observed scan; 0: none
  float max_range_m = 0.0f;         // of it
};

// Says where a call reads and writes; rows of (arenas x robots), row-major. Borrowed for the call.
struct CrewArrays {
  const double* actions = nullptr;        // forward [m/s], yaw rate [rad/s]; finite
  const unsigned char* acting = nullptr;  // 0: a robot that is neither told nor observed
  RobotView* views = nullptr;
  float* scans = nullptr;       // `sectors` values each; not looked at where sectors is 0
  std::size_t scan_stride = 0;  // from one row's scan to the next [floats]
};

// Advances many arenas side by side. What each does is what it would do alone.
class ArenaCrew {
 public:
  // threads: with the one that calls; 0: as many as the machine has cores.
  ArenaCrew(CrewLayout layout, int threads) : layout_(std::move(layout)), crew_(threads) {}

  const CrewLayout& layout() const { return layout_; }
  int threads() const { return crew_.threads(); }

  // Advances each arena with an acting robot by its number of steps. A robot that has gone keeps
  // its row, with alive -1. The answers are by arena: an error is of that arena alone, whose rows
  // are not written then. An exception of the simulator is INTERNAL in its words.
  std::vector<Status> Advance(const std::vector<Arena*>& arenas, const std::vector<int>& steps,
                              const CrewArrays& arrays);
  // Resets each arena with its seed. The error is the first one's by order.
  Status Reset(const std::vector<Arena*>& arenas, const std::vector<std::uint64_t>& seeds);

 private:
  Status AdvanceOne(Arena* arena, std::size_t first_row, int steps, const CrewArrays& arrays) const;

  CrewLayout layout_;
  WorkCrew crew_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LEARNING_ARENA_CREW_H_
