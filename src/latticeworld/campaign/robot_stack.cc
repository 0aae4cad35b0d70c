#include "latticeworld/campaign/robot_stack.h"

#include "latticeworld/campaign/reference_stack.h"
#include "latticeworld/campaign/way_stack.h"

namespace latticeworld {

std::vector<std::string> StackNames() { return {"reference", "way"}; }

std::unique_ptr<RobotStack> MakeStack(const std::string& name) {
  return name == "way" ? MakeWayStack() : MakeReferenceStack();
}

}  // namespace latticeworld
