// Drives a robot to a place in lockstep, without ROS: look, command, ten fixed steps, again.
//
// Usage: step_world EAST NORTH   (where to [m], from the middle of the world)

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "latticeworld/generation/world_generator.h"
#include "latticeworld/simulation/simulator.h"

namespace lw = latticeworld;

// The agent called "robot", as it is after the last step.
lw::AgentSnapshot Robot(const lw::Simulator& simulator) {
  const auto state = simulator.State();
  return *std::find_if(state->agents.begin(), state->agents.end(),
                       [](const lw::AgentSnapshot& agent) { return agent.name == "robot"; });
}

// Where the goal lies in the robot's own frame [m]: x forward, y left.
Eigen::Vector3d InRobotFrame(const lw::AgentSnapshot& robot, const Eigen::Vector2d& goal_m) {
  const Eigen::Vector3d there(goal_m.x(), goal_m.y(), robot.position_m.z());
  return robot.orientation.conjugate() * (there - robot.position_m);
}

// Drives until the robot is within half a metre of the goal, for a minute at the most.
lw::Status Drive(const Eigen::Vector2d& goal_m) {
  lw::GenerationRequest request;
  request.layout_instruction = "Flat grassland everywhere.";
  request.environment_instruction = "A sunny summer noon. A wheeled robot waits in the center.";
  request.seed = 3;
  request.size_m = 64.0;
  LW_ASSIGN_OR_RETURN(const auto world,
                      lw::MakeDefaultWorldGenerator().Generate(request, lw::Progress()));
  LW_ASSIGN_OR_RETURN(const auto simulator,
                      lw::Simulator::Create(world->scene, lw::SimulatorOptions(), /*seed=*/1));
  Eigen::Vector3d goal = InRobotFrame(Robot(*simulator), goal_m);
  while (goal.head<2>().norm() > 0.5 && simulator->State()->time_s < 60.0) {
    lw::VelocityCommand command;
    command.yaw_rate_radps = std::clamp(2.0 * std::atan2(goal.y(), goal.x()), -1.5, 1.5);
    command.linear_mps.x() = std::clamp(0.5 * goal.x(), 0.0, 1.5);
    LW_RETURN_IF_ERROR(simulator->Command("robot", command));
    for (int step = 0; step < 10; ++step) simulator->Step();
    goal = InRobotFrame(Robot(*simulator), goal_m);
  }
  const Eigen::Vector3d at = Robot(*simulator).position_m;
  std::cout << "after " << simulator->State()->time_s << " s the robot is at " << at.x() << ", "
            << at.y() << " m, " << goal.head<2>().norm() << " m from its goal\n"
            << "state " << simulator->StateHash() << "\n";  // The same in every run.
  return lw::Status();
}

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: step_world EAST NORTH\n";
    return 2;
  }
  const lw::Status status = Drive({std::atof(argv[1]), std::atof(argv[2])});
  if (!status.ok()) std::cerr << "step_world: " << status.ToString() << "\n";
  return status.ok() ? EXIT_SUCCESS : EXIT_FAILURE;
}
