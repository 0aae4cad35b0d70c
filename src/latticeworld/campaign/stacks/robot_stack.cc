#include "latticeworld/campaign/stacks/robot_stack.h"

#include "latticeworld/campaign/stacks/program_stack.h"
#include "latticeworld/campaign/stacks/reference_stack.h"
#include "latticeworld/campaign/stacks/way_stack.h"

namespace latticeworld {

std::vector<std::string> StackNames() { return {"reference", "way"}; }

std::unique_ptr<RobotStack> MakeStack(const CampaignRobot& robot) {
  if (robot.program) return MakeProgramStack(*robot.program);
  return robot.stack == "way" ? MakeWayStack() : MakeReferenceStack();
}

}  // namespace latticeworld
