#include "latticeworld/simulation/ode/body/body_solids.h"

#include <algorithm>

#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

void Include(const Eigen::Vector3d& center_m, double radius_m, Bounds* bounds) {
  const Eigen::Vector3d extent = Eigen::Vector3d::Constant(radius_m);
  bounds->Include({center_m - extent, center_m + extent});
}

// The ground samples of links, wherever their hinges turn them.
void IncludeLinks(const std::vector<LinkSpec>& links, Bounds* bounds) {
  std::vector<double> reach_m;  // from the first hinge of its chain to a link's own
  std::vector<std::size_t> root;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LinkSpec& link = links[i];
    const bool on_trunk = link.parent < 0;
    const auto parent = static_cast<std::size_t>(std::max(link.parent, 0));
    root.push_back(on_trunk ? i : root[parent]);
    reach_m.push_back(on_trunk ? 0.0
                               : reach_m[parent] + (link.anchor_m - links[parent].anchor_m).norm());
    for (const GroundSample& sample : link.ground_samples) {
      Include(links[root[i]].anchor_m,
              reach_m[i] + (sample.offset_m - link.anchor_m).norm() + sample.radius_m, bounds);
    }
  }
}

}  // namespace

BodySolids::BodySolids(const BodyParts& parts) : parts_(parts) {
  const BodySpec& spec = parts.spec();
  for (const BodyShape& shape : spec.shapes) {
    BodyShape of_trunk = shape;
    of_trunk.center_m.z() -= spec.center_height_m;
    solids_.push_back({Solid(of_trunk), 0});
  }
  for (std::size_t i = 0; i < spec.wheels.size(); ++i) {
    BodyShape ball;
    ball.radius_m = spec.wheels[i].radius_m;
    solids_.push_back({Solid(ball), 1 + i});
  }
  if (!solids_.empty()) MakeBall();
}

void BodySolids::MakeBall() {
  const BodySpec& spec = parts_.spec();
  Bounds bounds = Posed().front().solid.bounds();
  for (const BodySolid& one : Posed()) bounds.Include(one.solid.bounds());
  for (const GroundSample& sample : spec.ground_samples) {
    Include(sample.offset_m, sample.radius_m, &bounds);
  }
  IncludeLinks(spec.links, &bounds);
  ball_center_m_ = 0.5 * (bounds.low_m + bounds.high_m);
  ball_radius_m_ = 0.5 * (bounds.high_m - bounds.low_m).norm();
  double travel_m = 0.0;
  for (const WheelSpec& wheel : spec.wheels) {
    travel_m = std::max(travel_m, wheel.spring_npm > 0.0 ? 2.0 * wheel.travel_m : 0.0);
  }
  ball_radius_m_ += travel_m;
  Moved();
}

void BodySolids::Pose() {
  for (BodySolid& one : solids_) {
    const dBodyID part = parts_.part(one.part);
    one.solid.SetPose(PositionOf(part), dBodyGetRotation(part));
  }
  posed_ = true;
}

}  // namespace latticeworld
