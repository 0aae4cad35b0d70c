#include "latticeworld_ros/server/thing_query.h"

#include <string>
#include <vector>

#include "latticeworld/simulation/found_things.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"
#include "latticeworld_ros/conversion/status_conversion.h"

namespace latticeworld {
namespace {

latticeworld_msgs::NamedThing ToNamedThing(const FoundThing& thing) {
  latticeworld_msgs::NamedThing message;
  message.name = thing.name;
  message.kind = thing.kind;
  message.model = thing.model;
  message.pose.position = ToPoint(thing.position_m);
  message.pose.orientation = ToQuaternion(thing.orientation);
  message.size = ToVector3(thing.size_m);
  message.condition = std::string(NameOf(thing.condition));
  return message;
}

}  // namespace

void AnswerQuery(const Scene& scene, const WorldState& state,
                 const latticeworld_msgs::QueryThings::Request& request,
                 latticeworld_msgs::QueryThings::Response* response) {
  if (request.names.size() > kMostQueriedThings) {
    response->status = latticeworld::ToStatusMessage(
        ResourceExhausted(std::to_string(request.names.size()) + " names are given; at most " +
                          std::to_string(kMostQueriedThings) + " are legal in one call"));
    return;
  }
  const Result<std::vector<FoundThing>> things = FindThings(scene, &state, request.names);
  response->status = latticeworld::ToStatusMessage(things.status());
  if (!things.ok()) return;
  for (const FoundThing& thing : *things) response->things.push_back(ToNamedThing(thing));
}

}  // namespace latticeworld
