#include "latticeworld/scene/settlements/plots.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/layout/class_letters.h"
#include "latticeworld/scene/settlements/settlement_rules.h"

namespace latticeworld {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kMostBend_rad = 35.0 * kDegree;  // of a front within a plot: no corners
constexpr double kIntoLand_m = 10.0;              // where a plot's surroundings are looked at
constexpr double kIntoRoad_m = 3.0;
constexpr double kSkip_m = 3.0;  // past what no plot fits on
constexpr int kFewestInTerrace = 3, kMostInTerrace = 7;
constexpr double kChurchSpacing_m = 8.0;
constexpr int kMostChurchPlaces = 40;

WorldPoint Moved(WorldPoint from, double heading_rad, double distance_m) {
  return {from.x_m + distance_m * std::cos(heading_rad),
          from.y_m + distance_m * std::sin(heading_rad)};
}

double DistanceBetween(WorldPoint a, WorldPoint b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

struct Range {
  double low, high;
};
// Returns the distances that a front wall may have from the street's edge [m].
Range SetbackOf(BuildingUse use) {
  switch (use) {
    case BuildingUse::kRowHouse:
      return {3.0, 4.0};
    case BuildingUse::kFarmhouse:
      return {4.0, 7.0};
    case BuildingUse::kApartmentBlock:
      return {5.0, 7.0};
    case BuildingUse::kTower:
    case BuildingUse::kChurch:
      return {5.5, 7.0};
    default:
      return {3.5, 7.0};
  }
}
// Returns the widths that the gap beside a building may have, on either side [m].
Range SideGapOf(BuildingUse use) {
  switch (use) {
    case BuildingUse::kRowHouse:
      return {2.5, 4.0};
    case BuildingUse::kFarmhouse:
      return {5.0, 10.0};
    case BuildingUse::kApartmentBlock:
      return {5.0, 8.0};
    case BuildingUse::kTower:
      return {8.0, 12.0};
    default:
      return {2.2, 4.5};
  }
}

class PlotLayout {
 public:
  PlotLayout(const Terrain& terrain, const SettlementMap& map, const BuildingModels& models,
             const PlotRule& rule, PointRandom* random)
      : terrain_(terrain),
        map_(map),
        models_(models),
        rule_(rule),
        random_(random),
        roads_(terrain.weights.Find(suburb_letter::kRoad)) {}

  void Divide(const StreetFront& front, std::vector<Plot>* plots) {
    double along_m = random_->Uniform(0.5, 4.0);
    while (along_m + kLeastFront_m < front.length_m) {
      // Where no settlement lies beside the front there is no plot.
      const StreetFront::Place begin = front.At(along_m);
      const int settlement = map_.At(Moved(begin.at, begin.heading_rad + 0.5 * M_PI, kIntoLand_m));
      if (settlement < 0) {
        along_m += kSkip_m;
        continue;
      }
      // The use says what is built; a terrace that does not fit becomes a detached house.
      BuildingUse use = UseAt(settlement, begin);
      BuildingSize size = models_.Draw(use, random_);
      int houses = 1;
      if (use == BuildingUse::kRowHouse) {
        houses = kFewestInTerrace +
                 static_cast<int>(random_->Uniform() * (kMostInTerrace - kFewestInTerrace + 1));
        const double room_m = front.length_m - along_m - 2.0 * SideGapOf(use).high;
        houses = std::min(houses, static_cast<int>(room_m / (2.0 * HalfFrontOf(size))));
        if (houses < kFewestInTerrace) {
          houses = 1;
          use = BuildingUse::kDetachedHouse;
          size = models_.Draw(use, random_);
        }
      }
      // The plot is as wide as its houses and their gaps; it must end on the front and hardly bend.
      const Range gap = SideGapOf(use);
      const double gaps_m = rule_.sparseness * 2.0 * random_->Uniform(gap.low, gap.high);
      const double half_front_m = HalfFrontOf(size);
      const double width_m = houses * 2.0 * half_front_m + gaps_m;
      const double bend_rad = std::remainder(
          front.At(along_m + width_m - 1.0).heading_rad - front.At(along_m + 1.0).heading_rad,
          2.0 * M_PI);
      if (along_m + width_m > front.length_m || std::abs(bend_rad) > kMostBend_rad) {
        along_m += kSkip_m;
        continue;
      }
      // Plots are built on in order: near the settlement's heart first, with some scatter.
      const StreetFront::Place middle = front.At(along_m + 0.5 * width_m);
      Plot plot;
      plot.settlement = settlement;
      const Settlement& of = map_.settlements()[settlement];
      plot.order = DistanceBetween(middle.at, of.heart) / std::max(of.reach_m, 1.0) +
                   kPlotScatter * random_->Uniform();
      plot.buildings = Plans(middle, use, size, houses);
      plots->push_back(std::move(plot));
      along_m += width_m;
    }
  }

  // The buildings of a plot side by side, turned to the street.
  std::vector<BuildingPlan> Plans(const StreetFront::Place& middle, BuildingUse use,
                                  const BuildingSize& size, int houses) {
    const double into_rad = middle.heading_rad + 0.5 * M_PI;
    const double turn_rad =
        houses > 1 ? 0.0 : random_->Uniform(-kMostTurn_deg, kMostTurn_deg) * kDegree;
    const Range setback = SetbackOf(use);
    const double off_m = random_->Uniform(setback.low, setback.high) + HalfDepthOf(size);
    const WorldPoint centre = Moved(middle.at, into_rad, off_m);
    std::vector<BuildingPlan> plans;
    const int terrace = houses > 1 ? next_terrace_++ : -1;
    for (int i = 0; i < houses; ++i) {
      BuildingPlan plan;
      plan.use = use;
      plan.footprint.centre =
          Moved(centre, middle.heading_rad, (i - 0.5 * (houses - 1)) * 2.0 * HalfFrontOf(size));
      plan.footprint.yaw_rad = into_rad + M_PI + rule_.rotation_rad + turn_rad;
      plan.footprint.half_length_m = size.half_length_m;
      plan.footprint.half_width_m = size.half_width_m;
      plan.height_m = size.height_m;
      plan.terrace = terrace;
      plans.push_back(plan);
    }
    return plans;
  }

 private:
  bool IsTurned() const { return std::abs(std::remainder(rule_.rotation_rad, M_PI)) > 0.02; }
  // Half the building's extent along the street, and away from it.
  double HalfFrontOf(const BuildingSize& size) const {
    return std::abs(std::cos(rule_.rotation_rad)) * size.half_width_m +
           std::abs(std::sin(rule_.rotation_rad)) * size.half_length_m;
  }
  double HalfDepthOf(const BuildingSize& size) const {
    return std::abs(std::cos(rule_.rotation_rad)) * size.half_length_m +
           std::abs(std::sin(rule_.rotation_rad)) * size.half_width_m;
  }

  BuildingUse UseAt(int settlement, const StreetFront::Place& place) {
    const Settlement& of = map_.settlements()[settlement];
    const double draw = random_->Uniform();
    const double into_rad = place.heading_rad + 0.5 * M_PI;
    const WorldPoint land = Moved(place.at, into_rad, kIntoLand_m);
    const WorldPoint road = Moved(place.at, into_rad, -kIntoRoad_m);
    const double inner_m = map_.ToBorder_m(land);
    const GridGeometry& geometry = terrain_.geometry();
    const bool main =
        roads_ != nullptr && geometry.Contains(road) && (*roads_)[geometry.CellAt(road)] >= 0.5f;
    // A terrace of houses that are turned against the street has no common wall.
    const bool terraces = models_.Has(BuildingUse::kRowHouse) && !IsTurned();
    if (of.area_m2 >= kCityFrom_m2 && inner_m >= kInner_m) {
      const bool middle = inner_m >= 0.6 * of.inner_m;
      if (middle && draw < 0.08 && models_.Has(BuildingUse::kTower)) return BuildingUse::kTower;
      if (draw < (middle ? 0.45 : 0.3) && models_.Has(BuildingUse::kApartmentBlock)) {
        return BuildingUse::kApartmentBlock;
      }
      if (draw < 0.85 && terraces) return BuildingUse::kRowHouse;
      return BuildingUse::kDetachedHouse;
    }
    if (of.area_m2 >= kTownFrom_m2 && inner_m >= 0.5 * kInner_m && terraces &&
        draw < (main ? 0.7 : 0.3)) {
      return BuildingUse::kRowHouse;
    }
    if (map_.ToField_m(land) <= kFarmReach_m && inner_m < kInner_m && draw < 0.3 &&
        models_.Has(BuildingUse::kFarmhouse)) {
      return BuildingUse::kFarmhouse;
    }
    return BuildingUse::kDetachedHouse;
  }

  const Terrain& terrain_;
  const SettlementMap& map_;
  const BuildingModels& models_;
  PlotRule rule_;
  PointRandom* random_;
  const WeightGrid* roads_;
  int next_terrace_ = 0;
};

}  // namespace

std::vector<Plot> PlotsAlong(const std::vector<StreetFront>& fronts, const Terrain& terrain,
                             const SettlementMap& map, const BuildingModels& models,
                             const PlotRule& rule, PointRandom* random) {
  std::vector<Plot> plots;
  PlotLayout layout(terrain, map, models, rule, random);
  for (const StreetFront& front : fronts) layout.Divide(front, &plots);
  return plots;
}

std::vector<BuildingPlan> ChurchPlans(const std::vector<StreetFront>& fronts,
                                      const Terrain& terrain, const SettlementMap& map,
                                      int settlement, const BuildingModels& models,
                                      const PlotRule& rule, PointRandom* random) {
  const WorldPoint heart = map.settlements()[settlement].heart;
  const double reach_m = map.settlements()[settlement].reach_m + 2.0 * kIntoLand_m + map.cell_m();
  std::vector<std::pair<double, StreetFront::Place>> places;
  for (const StreetFront& front : fronts) {
    if (DistanceBetween(front.line.front(), heart) > reach_m + front.length_m) continue;
    for (double along_m = kChurchSpacing_m; along_m + kChurchSpacing_m < front.length_m;
         along_m += kChurchSpacing_m) {
      const StreetFront::Place place = front.At(along_m);
      const WorldPoint land = Moved(place.at, place.heading_rad + 0.5 * M_PI, kIntoLand_m);
      if (map.At(land) == settlement) places.push_back({DistanceBetween(land, heart), place});
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (places.size() > kMostChurchPlaces) places.resize(kMostChurchPlaces);
  const BuildingSize size = models.Draw(BuildingUse::kChurch, random);
  PlotLayout layout(terrain, map, models, rule, random);
  std::vector<BuildingPlan> plans;
  for (const auto& [distance_m, place] : places) {
    plans.push_back(layout.Plans(place, BuildingUse::kChurch, size, 1).front());
  }
  return plans;
}

}  // namespace latticeworld
