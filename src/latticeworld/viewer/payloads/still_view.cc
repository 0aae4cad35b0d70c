#include "latticeworld/viewer/payloads/still_view.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/generation/world.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {
namespace {

Eigen::Quaterniond Turned(double yaw_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
}

}  // namespace

void ShowStart(const World& world, const SpeciesCatalogue& species, ViewerFeed* feed) {
  const Scene& scene = *world.scene;
  std::vector<AgentSnapshot> agents;
  for (const AgentStart& start : scene.agents) {
    AgentSnapshot agent;
    agent.name = start.name;
    agent.species = species.Of(start.category).name;
    agent.team = start.team;
    agent.position_m = {
        start.position.x_m, start.position.y_m,
        scene.terrain->ground.HeightAt(start.position) + start.height_above_ground_m};
    agent.orientation = Turned(start.heading_rad);
    agents.push_back(std::move(agent));
  }
  std::sort(agents.begin(), agents.end(),
            [](const AgentSnapshot& a, const AgentSnapshot& b) { return a.name < b.name; });
  std::vector<PropSnapshot> props;
  for (const Prop& start : scene.props) {
    PropSnapshot prop;
    prop.name = start.name;
    prop.kind = start.kind;
    prop.position_m = {start.position.x_m, start.position.y_m, start.z_m};
    prop.orientation = Turned(start.yaw_rad);
    prop.size_m = start.size_m;
    props.push_back(std::move(prop));
  }
  feed->ShowAgents(0.0, 0.0, Streamed(agents));
  feed->ShowProps(0.0, 0.0, Streamed(props));
}

void StillBackend::Do(const ViewerRequest& request, Done done) {
  ViewerReply reply;
  if (request.type == RequestType::kListWorlds) {
    reply.worlds.emplace();
  } else {
    reply.status = FailedPrecondition(std::string(NameOf(request.type)) +
                                      " needs a running world_server; this is a saved world that "
                                      "stands still");
  }
  done(std::move(reply));
}

}  // namespace latticeworld
