#include "latticeworld/terrain/ways/street_growth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace latticeworld::internal {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kMostTurn_rad_per_m = 1.0 / 14.0;  // tightest curve: a radius of 14 m
constexpr double kLeastLength_m = 32.0;             // of a street
constexpr double kLongest_m = 900.0;
constexpr double kJoinReach_m = 42.0;
constexpr double kJoinAngle_rad = 55.0 * kDegree;
constexpr double kStub_m = 26.0;    // beyond a crossing that is cut off
constexpr double kForget_m = 20.0;  // along a street after a crossing, before it may cross again
constexpr double kEndMargin_m =
    9.0;                           // a dead end keeps off its area's border: a house stands there
constexpr double kCrowded = 0.62;  // of the spacing: a street ends
constexpr double kRoomy = 0.78;    // of the spacing: a street may begin
// The same to roads of the layout, from whose edge distances are measured.
constexpr double kCrowdedToRoad = 0.45;
constexpr double kRoomyToRoad = 0.6;
constexpr int kSmoothingRounds = 4;    // of streets, so that what joins others has no kink
constexpr double kCrossChance = 0.55;  // that a street runs on over another
constexpr double kCrossing_rad = 40.0 * kDegree;
constexpr double kSharedJunction_m = 26.0;

WorldPoint Ahead(WorldPoint from, double heading_rad, double distance_m) {
  return {from.x_m + distance_m * std::cos(heading_rad),
          from.y_m + distance_m * std::sin(heading_rad)};
}

double HeadingTo(WorldPoint from, WorldPoint to) {
  return std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
}

double LengthOf(const std::vector<WorldPoint>& line) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length_m += DistanceBetween(line[i - 1], line[i]);
  return length_m;
}

}  // namespace

StreetGrower::StreetGrower(const StreetField& field, const StreetRule& rule, RandomStream* random,
                           StreetNetwork* network)
    : field_(field),
      rule_(rule),
      random_(random),
      network_(network),
      step_m_(std::max(4.0, 0.5 * field.lattice().resolution_m())) {}

double StreetGrower::SpacingOf(const BuiltUpArea& area, double heading_rad) const {
  return AngleBetweenLines(heading_rad, area.axis_rad) < 45.0 * kDegree ? rule_.block_depth_m
                                                                        : rule_.block_length_m;
}

bool StreetGrower::HasRoom(WorldPoint start, double heading_rad, double spacing_m) const {
  for (const double ahead_m : {12.0, 26.0}) {
    if (!field_.IsOpen(Ahead(start, heading_rad, ahead_m))) return false;
  }
  const WorldPoint place = Ahead(start, heading_rad, 6.0);
  return !network_->HasParallel(place, heading_rad, kRoomy * spacing_m) &&
         !field_.HasRoadAlong(place, heading_rad, kRoomyToRoad * spacing_m);
}

std::optional<StreetNetwork::Node> StreetGrower::Crossed(WorldPoint place,
                                                         double heading_rad) const {
  std::optional<StreetNetwork::Node> crossed;
  double nearest_m = 1.1 * step_m_;
  network_->ForEachNear(place, nearest_m, [&](const StreetNetwork::Node& node, double distance_m) {
    if (distance_m > nearest_m ||
        AngleBetweenLines(node.heading_rad, heading_rad) < kCrossing_rad) {
      return;
    }
    nearest_m = distance_m;
    crossed = node;
  });
  return crossed;
}

bool StreetGrower::IsOpenWay(WorldPoint from, WorldPoint to) const {
  const int steps = std::max(1, static_cast<int>(DistanceBetween(from, to) / 2.0));
  for (int i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const WorldPoint place = {from.x_m + t * (to.x_m - from.x_m),
                              from.y_m + t * (to.y_m - from.y_m)};
    if (!field_.IsOpen(place) && !field_.IsRoad(place)) return false;
  }
  return true;
}

bool StreetGrower::JoinAhead(double spacing_m, int parent, Trace* trace) const {
  const WorldPoint from = trace->line.back();
  const double heading_rad = HeadingTo(trace->line[trace->line.size() - 2], from);
  const double reach_m = std::min(kJoinReach_m, 0.7 * spacing_m);
  std::optional<WorldPoint> best;
  double least = reach_m;
  network_->ForEachNear(from, reach_m, [&](const StreetNetwork::Node& node, double distance_m) {
    if (node.street == parent && trace->length_m < 1.5 * kJoinReach_m) return;
    const double turn_rad =
        std::abs(std::remainder(HeadingTo(from, node.at) - heading_rad, 2.0 * M_PI));
    if (distance_m < 1.0 || turn_rad > kJoinAngle_rad) return;
    const double score = distance_m * (1.0 + turn_rad);
    if (score >= least || !IsOpenWay(from, node.at)) return;
    least = score;
    best = node.at;
  });
  // A road of the layout straight ahead.
  for (double ahead_m = step_m_; ahead_m <= 0.6 * reach_m && ahead_m < least; ahead_m += step_m_) {
    const WorldPoint place = Ahead(from, heading_rad, ahead_m);
    if (field_.IsRoad(place)) {
      best = place;
      break;
    }
    if (!field_.IsOpen(place)) break;
  }
  if (!best) return false;
  const int pieces = std::max(1, static_cast<int>(DistanceBetween(from, *best) / step_m_));
  for (int i = 1; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    trace->line.push_back(
        {from.x_m + t * (best->x_m - from.x_m), from.y_m + t * (best->y_m - from.y_m)});
  }
  trace->end = End::kJoined;
  return true;
}

StreetGrower::Trace StreetGrower::Follow(WorldPoint start, double heading_rad, double spacing_m,
                                         int parent) {
  Trace trace;
  trace.line.push_back(start);
  std::size_t last_crossing = 0;  // index into the line; 0: none
  double since_crossing_m = 0.0;
  int crossed_street = parent;
  WorldPoint place = start;
  bool at_border_of_area = false;
  while (trace.length_m < kLongest_m) {
    const double wanted_rad =
        field_.DirectionAt(Ahead(place, heading_rad, 0.5 * step_m_), heading_rad);
    const double most_rad = kMostTurn_rad_per_m * step_m_;
    heading_rad += std::clamp(wanted_rad - heading_rad, -most_rad, most_rad);
    WorldPoint next = Ahead(place, heading_rad, step_m_);
    if (!field_.lattice().Contains(next)) {
      // The street goes on over the edge of the world, so that no gap is left there.
      trace.line.push_back(next);
      trace.end = End::kAtBorder;
      return trace;
    }
    if (field_.IsRoad(next) && trace.length_m > step_m_) {
      const double into_m = std::max(4.0, 2.0 * field_.lattice().resolution_m());
      trace.line.push_back(next);
      trace.line.push_back(Ahead(next, heading_rad, into_m));
      trace.end = End::kJoined;
      return trace;
    }
    if (!field_.IsOpen(next)) {
      at_border_of_area = !field_.IsRoad(next);
      break;
    }
    if (trace.length_m > 8.0 &&
        (network_->HasParallel(next, heading_rad, kCrowded * spacing_m) ||
         field_.HasRoadAlong(next, heading_rad, kCrowdedToRoad * spacing_m))) {
      break;
    }
    trace.length_m += step_m_;
    since_crossing_m += step_m_;
    const std::optional<StreetNetwork::Node> crossed = Crossed(next, heading_rad);
    if (crossed && (crossed->street != crossed_street || since_crossing_m > kForget_m)) {
      trace.line.push_back(crossed->at);
      if (!random_->Chance(kCrossChance)) {
        trace.end = End::kJoined;
        return trace;
      }
      last_crossing = trace.line.size() - 1;
      since_crossing_m = 0.0;
      crossed_street = crossed->street;
      place = crossed->at;
      continue;
    }
    trace.line.push_back(next);
    place = next;
  }
  if (trace.line.size() < 2) return trace;
  if (JoinAhead(spacing_m, parent, &trace)) return trace;
  if (last_crossing > 0 && since_crossing_m < kStub_m) {
    trace.line.resize(last_crossing + 1);
    trace.end = End::kJoined;
    return trace;
  }
  const int margin = at_border_of_area ? static_cast<int>(kEndMargin_m / step_m_) : 0;
  const std::size_t keep = std::max<std::size_t>(last_crossing + 1, 2);
  for (int i = 0; i < margin && trace.line.size() > keep; ++i) trace.line.pop_back();
  return trace;
}

void StreetGrower::Add(std::vector<WorldPoint> line, double width_m) {
  for (int round = 0; round < kSmoothingRounds; ++round) {
    WorldPoint before = line.front();
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const WorldPoint here = line[i];
      line[i] = {0.25 * (before.x_m + 2.0 * here.x_m + line[i + 1].x_m),
                 0.25 * (before.y_m + 2.0 * here.y_m + line[i + 1].y_m)};
      before = here;
    }
  }
  added_.push_back(network_->Add({std::move(line), width_m}));
}

void StreetGrower::BeginAtRoad(const BuiltUpArea& area, WorldPoint edge, double heading_rad) {
  const double spacing_m = SpacingOf(area, heading_rad);
  if (!HasRoom(edge, heading_rad, spacing_m)) return;
  Trace trace = Follow(edge, heading_rad, spacing_m, -1);
  if (LengthOf(trace.line) < kLeastLength_m) return;
  // The street begins within the road.
  const WorldPoint centre = field_.RoadCentreAt(edge);
  const double cell_m = field_.lattice().resolution_m();
  double into_m = std::max(4.0, 3.0 * cell_m);
  if (const double to_centre_m = DistanceBetween(edge, centre); to_centre_m > cell_m) {
    into_m = std::min(into_m, to_centre_m);
  }
  trace.line.insert(trace.line.begin(), Ahead(edge, heading_rad + M_PI, into_m));
  Add(std::move(trace.line), rule_.main_width_m);
}

void StreetGrower::BeginWithLane(const BuiltUpArea& area, std::vector<WorldPoint> lane) {
  const double heading_rad = HeadingTo(lane[lane.size() - 2], lane.back());
  const Trace onward = Follow(lane.back(), heading_rad, SpacingOf(area, heading_rad), -1);
  lane.insert(lane.end(), onward.line.begin() + 1, onward.line.end());
  Add(std::move(lane), rule_.main_width_m);
}

void StreetGrower::BeginAtHeart(const BuiltUpArea& area) {
  const double heading_rad = field_.DirectionAt(area.heart, area.axis_rad);
  const double spacing_m = SpacingOf(area, heading_rad);
  Trace back = Follow(area.heart, heading_rad + M_PI, spacing_m, -1);
  const Trace forth = Follow(area.heart, heading_rad, spacing_m, -1);
  std::vector<WorldPoint> line(back.line.rbegin(), back.line.rend());
  line.insert(line.end(), forth.line.begin() + 1, forth.line.end());
  if (line.size() < 2 || LengthOf(line) < kLeastLength_m) return;
  Add(std::move(line), rule_.main_width_m);
}

void StreetGrower::AddBranch(std::vector<WorldPoint> way) {
  Add(std::move(way), rule_.lane_width_m);
}

void StreetGrower::BranchOff(const BuiltUpArea& area) {
  while (!added_.empty()) {
    const int street = added_.front();
    added_.pop_front();
    BranchOffStreet(area, street);
  }
}

void StreetGrower::BranchOffStreet(const BuiltUpArea& area, int street) {
  const std::vector<WorldPoint> line = network_->streets()[street].line;
  std::vector<double> places_m;  // of the first side's branches
  for (const double side_rad : {0.5 * M_PI, -0.5 * M_PI}) {
    double along_m = 0.0;
    const double heading_rad = HeadingTo(line.front(), line.back());
    const double spacing_m = SpacingOf(area, heading_rad + side_rad);
    double next_m = spacing_m * random_->Uniform(0.3, 0.6);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      along_m += DistanceBetween(line[i - 1], line[i]);
      // Two branches that nearly face each other share a crossing.
      const bool shared =
          side_rad < 0.0 && std::any_of(places_m.begin(), places_m.end(), [&](double place_m) {
            return std::abs(place_m - along_m) < 0.5 * step_m_ &&
                   std::abs(place_m - next_m) < kSharedJunction_m;
          });
      if (along_m < next_m && !shared) continue;
      const double branch_rad = HeadingTo(line[i - 1], line[i + 1]) + side_rad;
      const double wanted_m = SpacingOf(area, branch_rad);
      if (!HasRoom(line[i], branch_rad, wanted_m)) continue;
      const Trace trace = Follow(line[i], branch_rad, wanted_m, street);
      if (LengthOf(trace.line) < kLeastLength_m) continue;
      Add(trace.line, rule_.lane_width_m);
      if (side_rad > 0.0) places_m.push_back(along_m);
      next_m = along_m + wanted_m * random_->Uniform(0.85, 1.2);
    }
  }
}

}  // namespace latticeworld::internal
