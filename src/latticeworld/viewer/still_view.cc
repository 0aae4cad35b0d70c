#include "latticeworld/viewer/still_view.h"

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
  std::vector<ElementSnapshot> elements;
  for (const Element& start : scene.elements) {
    ElementSnapshot element;
    element.name = start.name;
    element.kind = start.kind;
    element.position_m = {start.position.x_m, start.position.y_m, start.z_m};
    element.orientation = Turned(start.yaw_rad);
    element.size_m = start.size_m;
    elements.push_back(std::move(element));
  }
  feed->ShowAgents(0.0, 0.0, Streamed(agents));
  feed->ShowElements(0.0, 0.0, Streamed(elements));
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
