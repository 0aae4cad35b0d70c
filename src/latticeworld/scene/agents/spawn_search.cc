#include "latticeworld/scene/agents/spawn_search.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/geometry/region.h"
#include "latticeworld/scene/agents/spawn_rules.h"

namespace latticeworld {
namespace {

constexpr int kSuitedTries = 100;  // on ground that the category prefers
constexpr int kRandomTries = 200;  // in all
constexpr int kNearTries = 40;
constexpr int kScanSide = 256;  // places a side that a scan looks at, at most

std::string_view WordsFor(SpawnFlaw flaw) {
  switch (flaw) {
    case SpawnFlaw::kSolid:
      return "trees, stones or buildings stand in the way";
    case SpawnFlaw::kTooDeep:
      return "the water is deeper than it can ford";
    case SpawnFlaw::kTooShallow:
      return "there is no water deep enough";
    case SpawnFlaw::kTooSteep:
      return "the ground is too steep";
    case SpawnFlaw::kOutsideWorld:
    case SpawnFlaw::kIllegalRadius:
      return "the body does not fit into the world";
    case SpawnFlaw::kNone:
      break;
  }
  return "";
}

// Robots on the ground, whose planners take the outermost cells of a map for closed.
bool DrivesByMaps(AgentCategory category) {
  return category == AgentCategory::kWheeledRobot || category == AgentCategory::kRoboticDog ||
         category == AgentCategory::kHumanoidRobot;
}

std::string LimitFor(SpawnFlaw flaw, Locomotion locomotion) {
  switch (flaw) {
    case SpawnFlaw::kTooDeep:
      return " (at most " + FormatDouble(kFordingDepth_m) + " m)";
    case SpawnFlaw::kTooShallow:
      return " (at least " + FormatDouble(kSwimmingDepth_m) + " m)";
    case SpawnFlaw::kTooSteep:
      return " (at most " +
             FormatDouble(locomotion == Locomotion::kWheels ? kSteepestForWheels_deg
                                                            : kSteepestForLegs_deg) +
             " degrees)";
    default:
      return "";
  }
}

}  // namespace

double SpawnClearance(double body_radius_m) { return std::max(2.0, 2.0 * body_radius_m); }

SpawnSearch::SpawnSearch(const Scene& scene, const Atmosphere& atmosphere, AgentCategory category,
                         double body_radius_m, Region region, const SceneChanges* changes,
                         Slopes slopes)
    : scene_(scene),
      atmosphere_(atmosphere),
      changes_(changes),
      category_(category),
      body_radius_m_(body_radius_m),
      region_(region),
      slopes_(slopes),
      surfaces_(scene, atmosphere.ground()) {
  const GridGeometry& geometry = scene.geometry();
  const double size_m = geometry.size_m(), half_m = geometry.half_size_m();
  const UnitBox unit = BoxOf(region);
  const double edge_m = DrivesByMaps(category) ? geometry.resolution_m() : 0.0;
  const double inner_m = std::max(0.0, half_m - body_radius_m - edge_m);
  box_ = {std::max(unit.u_min * size_m - half_m, -inner_m),
          std::min(unit.u_max * size_m - half_m, inner_m),
          std::max(half_m - unit.v_max * size_m, -inner_m),
          std::min(half_m - unit.v_min * size_m, inner_m)};
  const double width_m = box_.x_max_m - box_.x_min_m, height_m = box_.y_max_m - box_.y_min_m;
  if (!(width_m >= 0.0 && height_m >= 0.0)) return;  // nothing to scan
  step_m_ = std::max({kScanStep_m, body_radius_m, std::max(width_m, height_m) / kScanSide});
  scan_cols_ = static_cast<int>(width_m / step_m_) + 1;
  scan_rows_ = static_cast<int>(height_m / step_m_) + 1;
}

bool SpawnSearch::Suits(WorldPoint position) const {
  const SurfaceClass surface = scene_.terrain->SurfaceAt(position);
  switch (category_) {
    case AgentCategory::kSheep:
    case AgentCategory::kHorse:
      return surface == SurfaceClass::kGrass;
    case AgentCategory::kWheeledRobot:
      return surface == SurfaceClass::kRoad || surface == SurfaceClass::kGrass ||
             surface == SurfaceClass::kBarren;
    case AgentCategory::kGoblin:
      return surface == SurfaceClass::kForestFloor || surface == SurfaceClass::kRock;
    default:
      return true;
  }
}

bool SpawnSearch::Holds(WorldPoint position, const SpawnSite& site) const {
  const double friction = surfaces_.Of(scene_.terrain->SurfaceAt(position)).friction;
  return site.slope_deg <= HoldingSlope_deg(category_, friction);
}

bool SpawnSearch::Try(WorldPoint position, const std::vector<WorldPoint>& taken) {
  const SpawnSite site =
      ExamineSpawn(scene_, atmosphere_, category_, body_radius_m_, position, changes_);
  const bool slides =
      slopes_ == Slopes::kHeld && site.flaw == SpawnFlaw::kNone && !Holds(position, site);
  const SpawnFlaw flaw = slides ? SpawnFlaw::kTooSteep : site.flaw;
  if (flaw != SpawnFlaw::kNone) {
    ++flaws_[static_cast<int>(flaw)];
    return false;
  }
  const double clearance_m = SpawnClearance(body_radius_m_);
  for (const WorldPoint& other : taken) {
    const double dx = other.x_m - position.x_m, dy = other.y_m - position.y_m;
    if (dx * dx + dy * dy < clearance_m * clearance_m) {
      ++taken_;
      return false;
    }
  }
  return true;
}

double SpawnSearch::Draw(double low_m, double high_m, RandomStream* random) const {
  if (region_ == Region::kAnywhere) return random->Uniform(low_m, high_m);
  const double first_m = random->Uniform(low_m, high_m);
  return 0.5 * (first_m + random->Uniform(low_m, high_m));
}

Result<WorldPoint> SpawnSearch::Find(const std::vector<WorldPoint>& taken, RandomStream* random) {
  if (scan_cols_ > 0 && random_tries_help_) {
    for (int i = 0; i < kRandomTries; ++i) {
      const double x_m = Draw(box_.x_min_m, box_.x_max_m, random);
      const WorldPoint position = {x_m, Draw(box_.y_min_m, box_.y_max_m, random)};
      if (i < kSuitedTries && !Suits(position)) continue;
      if (Try(position, taken)) return position;
    }
    random_tries_help_ = false;
  }
  for (; scan_next_ < scan_cols_ * scan_rows_; ++scan_next_) {
    const WorldPoint position = {box_.x_min_m + (scan_next_ % scan_cols_) * step_m_,
                                 box_.y_max_m - (scan_next_ / scan_cols_) * step_m_};
    if (Try(position, taken)) return position;
  }
  return Failure();
}

Result<WorldPoint> SpawnSearch::FindNear(WorldPoint centre, double spread_m,
                                         const std::vector<WorldPoint>& taken,
                                         RandomStream* random) {
  for (int i = 0; i < kNearTries; ++i) {
    const double x_m = random->Normal(centre.x_m, spread_m);
    const WorldPoint position = {x_m, random->Normal(centre.y_m, spread_m)};
    if (position.x_m < box_.x_min_m || position.x_m > box_.x_max_m || position.y_m < box_.y_min_m ||
        position.y_m > box_.y_max_m) {
      continue;
    }
    if (i < kNearTries / 2 && !Suits(position)) continue;
    if (Try(position, taken)) return position;
  }
  return Find(taken, random);
}

Status SpawnSearch::Failure() const {
  std::string message = "no place for a " + std::string(NameOf(category_)) + " of radius " +
                        FormatDouble(body_radius_m_) + " m, region " + std::string(NameOf(region_));
  long tried = taken_;
  for (const long count : flaws_) tried += count;
  if (tried == 0) return NotFound(message + ": the body does not fit into the world");
  message += ": of " + std::to_string(tried) + " places tried";
  std::string_view separator = " ";
  for (int i = 1; i < kSpawnFlawCount; ++i) {
    if (flaws_[i] == 0) continue;
    const SpawnFlaw flaw = static_cast<SpawnFlaw>(i);
    message += std::string(separator) + "at " + std::to_string(flaws_[i]) + " " +
               std::string(WordsFor(flaw)) + LimitFor(flaw, LocomotionOf(category_));
    separator = ", ";
  }
  if (taken_ > 0) {
    message += std::string(separator) + "at " + std::to_string(taken_) +
               " another agent is nearer than " + FormatDouble(SpawnClearance(body_radius_m_)) +
               " m";
  }
  return NotFound(message);
}

Result<WorldPoint> FindSpawn(const Scene& scene, const Atmosphere& atmosphere,
                             AgentCategory category, double body_radius_m, Region region,
                             const std::vector<WorldPoint>& taken, RandomStream* random,
                             const SceneChanges* changes) {
  using Slopes = SpawnSearch::Slopes;
  Result<WorldPoint> place =
      SpawnSearch(scene, atmosphere, category, body_radius_m, region, changes, Slopes::kHeld)
          .Find(taken, random);
  if (place.ok()) return place;
  return SpawnSearch(scene, atmosphere, category, body_radius_m, region, changes, Slopes::kLegal)
      .Find(taken, random);
}

Result<WorldPoint> FindSpawn(const Scene& scene, AgentCategory category, double body_radius_m,
                             Region region, const std::vector<WorldPoint>& taken,
                             RandomStream* random) {
  return FindSpawn(scene, scene.atmosphere, category, body_radius_m, region, taken, random);
}

}  // namespace latticeworld
