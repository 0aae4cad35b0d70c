#include "latticeworld/campaign/robot_stack.h"

#include "latticeworld/campaign/program_stack.h"
#include "latticeworld/campaign/reference_stack.h"
#include "latticeworld/campaign/way_stack.h"

namespace latticeworld {

std::vector<std::string> StackNames() { return {"reference", "way"}; }

std::unique_ptr<RobotStack> MakeStack(const CampaignRobot& robot) {
  if (robot.program) return MakeProgramStack(*robot.program);
  return robot.stack == "way" ? MakeWayStack() : MakeReferenceStack();
}

}  // namespace latticeworld
