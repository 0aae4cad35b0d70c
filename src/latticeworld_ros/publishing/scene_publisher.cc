#include "latticeworld_ros/publishing/scene_publisher.h"

#include <algorithm>
#include <utility>

#include "latticeworld_ros/conversion/scene_conversion.h"

namespace latticeworld {
namespace {

bool Same(const PropSnapshot& a, const PropSnapshot& b) {
  return a.name == b.name && a.kind == b.kind && a.position_m == b.position_m &&
         a.orientation.coeffs() == b.orientation.coeffs() && a.size_m == b.size_m &&
         a.opening_rad == b.opening_rad && a.broken == b.broken;
}

}  // namespace

ScenePublisher::ScenePublisher(ros::NodeHandle node, MapFollower* maps)
    : maps_(maps),
      props_(node.advertise<latticeworld_msgs::ElementStates>("elements", 10, /*latch=*/true)),
      changes_(
          node.advertise<latticeworld_msgs::SceneChanges>("world/changes", 10, /*latch=*/true)) {}

void ScenePublisher::OnJump() { jumped_ = true; }

ScenePublisher::Standing ScenePublisher::StandingOf(const WorldState& state) {
  Standing standing;
  for (const FelledTree& felled : state.felled) {
    (felled.at_rest ? standing.at_rest : standing.falling).push_back(felled.tree.asset);
  }
  for (const PropSnapshot& prop : state.props) {
    if (prop.broken) standing.broken.push_back(prop.name);
  }
  standing.map_version = state.map_version;
  return standing;
}

void ScenePublisher::Publish(const Tick& tick, const WorldState& state) {
  if (jumped_ || !std::equal(state.props.begin(), state.props.end(), told_props_.begin(),
                             told_props_.end(), Same)) {
    props_.publish(ToElementStates(state, tick.now, tick.world_id()));
    told_props_ = state.props;
  }
  Standing standing = StandingOf(state);
  if (jumped_ || standing.falling != told_.falling || standing.at_rest != told_.at_rest ||
      standing.broken != told_.broken || standing.map_version != told_.map_version) {
    changes_.publish(ToSceneChangesMessage(state, tick.now, tick.world_id()));
  }
  if (jumped_ || standing.map_version != told_.map_version) {
    maps_->Follow(tick.world, ChangesOf(state), tick.now);
  }
  told_ = std::move(standing);
  jumped_ = false;
}

}  // namespace latticeworld
