#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/random.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/scene/builder.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/road_finder.h"
#include "latticeworld/scene/settlements/gardens.h"
#include "latticeworld/scene/settlements/plots.h"
#include "latticeworld/scene/settlements/settlement_map.h"
#include "latticeworld/scene/settlements/settlement_rules.h"
#include "latticeworld/scene/settlements/street_fronts.h"
#include "latticeworld/scene/vegetation/blue_noise.h"

namespace latticeworld {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kMoveBack_m = 2.5;
constexpr int kMostMovesBack = 2;            // within kMostSetback_m
constexpr double kShedChance = 0.4;          // of a house
constexpr double kInfillPerHectare = 200.0;  // places that are tried away from streets, at most
constexpr double kInfillPerBuilding = 8.0;   // places for each building that is missing
constexpr int kLeastPatience = 200;
constexpr double kPatience = 0.25;       // of the places of a settlement
constexpr double kInfillReach_m = 45.0;  // from them to a street or another building
constexpr double kInfillGap_m = 2.0;     // beyond kLeastWallGap_m
constexpr double kYardWidth_m = 9.0;     // of a farm

// The settlements of a world, built one after the other.
class Settler {
 public:
  Settler(Placement* placement, const std::vector<StreetFront>& fronts)
      : placement_(placement),
        map_(placement->terrain),
        builder_(placement, map_),
        fronts_(fronts),
        seed_(StreamSeed(placement->seed, "scene/buildings")) {
    const FineAttribute& fine = placement->environment.fine_of(AssetType::kArchitecture);
    rule_.rotation_rad = fine.rotation_deg[2] * kDegree;
    rule_.sparseness = 1.0 + 1.2 * (1.0 - std::clamp(fine.density, 0.0, 1.0));
  }

  // wanted: in the whole world.
  void Build(int wanted) {
    ShareOut(wanted);
    const int all = std::accumulate(quota_.begin(), quota_.end(), 0);
    placement_->tally.Of(AssetKind::kBuilding).wanted = std::max(wanted, all);
    for (std::size_t i = 0; i < quota_.size(); ++i) BuildChurch(static_cast<int>(i));
    PointRandom random(seed_, 0);
    std::vector<Plot> plots =
        PlotsAlong(fronts_, placement_->terrain, map_, builder_.models(), rule_, &random);
    std::stable_sort(plots.begin(), plots.end(),
                     [](const Plot& a, const Plot& b) { return a.order < b.order; });
    for (const Plot& plot : plots) {
      if (IsCancelled()) return;
      if (plot.buildings.size() > 1) {
        BuildTerrace(plot, &random);
        continue;
      }
      const std::optional<BuildingPlan> standing =
          PutOrMoveBack(plot.settlement, plot.buildings.front(), &random);
      if (!standing || standing->use != BuildingUse::kFarmhouse) continue;
      BuildFarmyard(plot.settlement, standing->footprint, &random);
    }
    BuildSheds();
    Fill();
    if (IsCancelled()) return;
    PlantGardens(builder_, placement_);
  }

 private:
  bool IsCancelled() const {
    return placement_->progress != nullptr && placement_->progress->cancelled();
  }

  // How many buildings each settlement gets, by its built-up land: one at least, so that no village
  // is lost for being small.
  void ShareOut(int wanted) {
    double land_m2 = 0.0;
    for (const Settlement& settlement : map_.settlements()) land_m2 += settlement.area_m2;
    double owed = 0.0;
    for (const Settlement& settlement : map_.settlements()) {
      owed += wanted * settlement.area_m2 / std::max(land_m2, 1.0);
      const int least = settlement.area_m2 >= kLeastSettlement_m2 ? 1 : 0;
      const int whole = std::max(least, static_cast<int>(std::lround(owed)));
      quota_.push_back(whole);
      owed -= whole;
    }
  }

  bool IsFull(int settlement) const { return settlement < 0 || quota_[settlement] <= 0; }

  bool Put(int settlement, const BuildingPlan& plan, PointRandom* random) {
    if (IsFull(settlement) || !builder_.Build(plan, random)) return false;
    --quota_[settlement];
    return true;
  }

  // A little farther from the street where it does not fit beside it: what stands there.
  std::optional<BuildingPlan> PutOrMoveBack(int settlement, BuildingPlan plan,
                                            PointRandom* random) {
    if (IsFull(settlement)) return std::nullopt;
    for (int moves = 0; moves <= kMostMovesBack; ++moves) {
      if (Put(settlement, plan, random)) return plan;
      plan.footprint.centre = plan.footprint.At(-kMoveBack_m, 0.0);
    }
    return std::nullopt;
  }

  // Builds as many houses side by side as fit, two at least.
  void BuildTerrace(const Plot& plot, PointRandom* random) {
    if (IsFull(plot.settlement)) return;
    std::size_t begin = 0, end = 0, first = 0;
    for (std::size_t i = 0; i <= plot.buildings.size(); ++i) {
      if (i < plot.buildings.size() && builder_.Fits(plot.buildings[i])) continue;
      if (i - first > end - begin) {
        begin = first;
        end = i;
      }
      first = i + 1;
    }
    if (end - begin < 2 || quota_[plot.settlement] < 2) return;
    for (std::size_t i = begin; i < end; ++i) Put(plot.settlement, plot.buildings[i], random);
  }

  void BuildChurch(int settlement) {
    if (map_.settlements()[settlement].area_m2 < kChurchFrom_m2 ||
        !builder_.models().Has(BuildingUse::kChurch)) {
      return;
    }
    PointRandom random(StreamSeed(seed_, "church"), static_cast<std::uint64_t>(settlement));
    for (const BuildingPlan& plan : ChurchPlans(fronts_, placement_->terrain, map_, settlement,
                                                builder_.models(), rule_, &random)) {
      if (Put(settlement, plan, &random)) return;
    }
  }

  // A building of its drawn size with its centre at a point.
  BuildingPlan PlanAt(BuildingUse use, WorldPoint centre, double yaw_rad,
                      PointRandom* random) const {
    const BuildingSize size = builder_.models().Draw(use, random);
    BuildingPlan plan;
    plan.use = use;
    plan.footprint = {centre, yaw_rad, size.half_length_m, size.half_width_m};
    plan.height_m = size.height_m;
    return plan;
  }

  // A barn across the yard behind the farmhouse or beside it, wherever there is room, and a shed.
  void BuildFarmyard(int settlement, const Footprint& house, PointRandom* random) {
    const BuildingPlan barn = PlanAt(BuildingUse::kBarn, house.centre, house.yaw_rad, random);
    const double side = random->Chance(0.5) ? 1.0 : -1.0;
    const double yard_m = kYardWidth_m * random->Uniform(0.8, 1.3);
    const double length_m = barn.footprint.half_length_m, width_m = barn.footprint.half_width_m;
    const double behind_m = house.half_length_m + kLeastWallGap_m + 0.5;
    struct Spot {
      double along_m, left_m, turn_rad;
    };
    const Spot spots[] = {
        {-(behind_m + width_m), side * (0.5 * yard_m + length_m), -0.5 * side * M_PI},
        {-(house.half_length_m + yard_m + length_m), 0.0, 0.0},
        {-(behind_m + width_m), -side * (0.5 * yard_m + length_m), 0.5 * side * M_PI},
        {0.0, side * (house.half_width_m + yard_m + length_m), -0.5 * side * M_PI},
        {0.0, -side * (house.half_width_m + yard_m + length_m), 0.5 * side * M_PI}};
    for (const Spot& spot : spots) {
      BuildingPlan plan = barn;
      plan.footprint.centre = house.At(spot.along_m, spot.left_m);
      plan.footprint.yaw_rad += spot.turn_rad;
      if (Put(settlement, plan, random)) break;
    }
    BuildingPlan shed = PlanAt(BuildingUse::kShed, house.centre, house.yaw_rad, random);
    shed.footprint.yaw_rad += 0.5 * side * M_PI;
    shed.footprint.centre = house.At(-(behind_m + shed.footprint.half_width_m),
                                     -side * (house.half_width_m - shed.footprint.half_length_m));
    Put(settlement, shed, random);
  }

  // A place away from streets where a building is tried.
  struct OpenPlace {
    double order;
    WorldPoint point;
    int settlement;
  };

  // Evenly spread over what is not full yet, more where more is missing; from the hearts outwards
  // as the plots are.
  std::vector<OpenPlace> OpenPlaces() const {
    constexpr double kPerM2 = kInfillPerHectare / 10000.0;
    std::vector<double> share(quota_.size(), 0.0);
    for (std::size_t i = 0; i < quota_.size(); ++i) {
      if (quota_[i] <= 0) continue;
      const double per_m2 = quota_[i] / std::max(map_.settlements()[i].area_m2, 1.0);
      share[i] = std::min(1.0, kInfillPerBuilding * per_m2 / kPerM2);
    }
    const double most = share.empty() ? 0.0 : *std::max_element(share.begin(), share.end());
    std::vector<OpenPlace> places;
    if (most <= 0.0) return places;
    const GridGeometry& geometry = placement_->terrain.geometry();
    const WeightGrid& weight = *placement_->terrain.weights.Find(suburb_letter::kBuilding);
    const std::uint64_t order_seed = StreamSeed(seed_, "infill/order");
    const RankedBlueNoise noise(
        geometry.size_m(), kPerM2, StreamSeed(seed_, "infill/noise"),
        [most](WorldPoint, WorldPoint) { return most; }, placement_->threads);
    for (int tile = 0; tile < noise.tiles(); ++tile) {
      noise.ForEachIn(tile, [&](const RankedBlueNoise::Point& at) {
        const WorldPoint point = {at.x_m, at.y_m};
        if (at.rank >= most || weight[geometry.CellAt(point)] < kLeastBuiltUp) return;
        const int settlement = map_.At(point);
        if (IsFull(settlement) || at.rank >= share[settlement]) return;
        const Settlement& of = map_.settlements()[settlement];
        const double from_heart_m = std::hypot(point.x_m - of.heart.x_m, point.y_m - of.heart.y_m);
        const double draw = PointRandom(order_seed, at.id).Uniform();
        places.push_back(
            {from_heart_m / std::max(of.reach_m, 1.0) + kPlotScatter * draw, point, settlement});
      });
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const OpenPlace& a, const OpenPlace& b) { return a.order < b.order; });
    return places;
  }

  // What no street has room for, over the rest of the land: facing a street within reach, else
  // along its settlement, near what is built already.
  void Fill() {
    const std::vector<OpenPlace> places = OpenPlaces();
    if (places.empty()) return;
    // How often in a row a settlement may refuse before it counts as full.
    std::vector<int> patience(quota_.size(), 0), refused(quota_.size(), 0);
    for (const OpenPlace& place : places) ++patience[place.settlement];
    for (int& most : patience) {
      most = std::max(kLeastPatience, static_cast<int>(kPatience * most));
    }
    const RoadFinder roads(placement_->terrain);
    PointRandom random(StreamSeed(seed_, "infill"), 0);
    std::vector<bool> begun(quota_.size(), false);
    for (const Built& built : builder_.built()) {
      if (built.settlement >= 0) begun[built.settlement] = true;
    }
    for (const OpenPlace& place : places) {
      if (IsCancelled()) return;
      if (IsFull(place.settlement) || refused[place.settlement] >= patience[place.settlement]) {
        continue;
      }
      ++refused[place.settlement];
      const std::optional<BuildingPlan> plan =
          PlanInside(place, roads, begun[place.settlement], &random);
      if (!plan || !Put(place.settlement, *plan, &random)) continue;
      refused[place.settlement] = 0;
      begun[place.settlement] = true;
      if (plan->use == BuildingUse::kFarmhouse) {
        BuildFarmyard(place.settlement, plan->footprint, &random);
      }
    }
  }

  // The building of a place; nullopt: others are too near, or, where the settlement has begun, none
  // is near and no street. What costs least is asked first.
  std::optional<BuildingPlan> PlanInside(const OpenPlace& place, const RoadFinder& roads,
                                         bool begun, PointRandom* random) const {
    constexpr double kGap_m = kLeastWallGap_m + kInfillGap_m;
    const Settlement& settlement = map_.settlements()[place.settlement];
    const BuildingUse use = UseInside(settlement, place.point, random);
    BuildingPlan plan = PlanAt(use, place.point, 0.0, random);
    const double half_m = std::min(plan.footprint.half_length_m, plan.footprint.half_width_m);
    if (!builder_.IsClear({place.point, 0.0, 0.0, 0.0}, kGap_m + half_m, -1)) return std::nullopt;
    const std::optional<RoadFinder::Road> road = roads.Nearest(place.point);
    const double turn_rad = random->Uniform(-2.0, 2.0) * kMostTurn_deg * kDegree;
    const int quarters = static_cast<int>(4.0 * random->Uniform());
    plan.footprint.yaw_rad =
        rule_.rotation_rad + (road ? road->heading_rad + 0.5 * turn_rad
                                   : settlement.axis_rad + quarters * 0.5 * M_PI + turn_rad);
    if (!builder_.IsClear(plan.footprint, kGap_m, -1)) return std::nullopt;
    const bool alone = !(road && road->distance_m < kInfillReach_m) &&
                       builder_.IsClear(plan.footprint, kInfillReach_m, -1);
    if (begun && alone) return std::nullopt;
    return plan;
  }

  // Hamlets near fields are farms.
  BuildingUse UseInside(const Settlement& settlement, WorldPoint point, PointRandom* random) const {
    const double draw = random->Uniform();
    const double inner_m = map_.ToBorder_m(point);
    const double farms = settlement.area_m2 < kHamletBelow_m2 ? 1.0 : 0.4;
    if (map_.ToField_m(point) <= kFarmReach_m && settlement.area_m2 < kTownFrom_m2 &&
        draw < farms && builder_.models().Has(BuildingUse::kFarmhouse)) {
      return BuildingUse::kFarmhouse;
    }
    if (settlement.area_m2 >= kCityFrom_m2 && inner_m >= kInner_m && draw < 0.3 &&
        builder_.models().Has(BuildingUse::kApartmentBlock)) {
      return BuildingUse::kApartmentBlock;
    }
    return BuildingUse::kDetachedHouse;
  }

  // Builds sheds behind houses, at one side of their gardens.
  void BuildSheds() {
    if (!builder_.models().Has(BuildingUse::kShed)) return;
    PointRandom random(StreamSeed(seed_, "sheds"), 0);
    const std::vector<Built> houses = builder_.built();
    for (const Built& house : houses) {
      const bool wanted = random.Chance(kShedChance);
      const double behind_m = random.Uniform(4.0, 8.0), side = random.Chance(0.5) ? 1.0 : -1.0;
      BuildingPlan shed = PlanAt(BuildingUse::kShed, house.plan.footprint.centre,
                                 house.plan.footprint.yaw_rad, &random);
      if (house.plan.use != BuildingUse::kDetachedHouse || !wanted) continue;
      const Footprint& of = house.plan.footprint;
      shed.footprint.centre = of.At(-(of.half_length_m + behind_m + shed.footprint.half_length_m),
                                    side * (of.half_width_m + 1.5 - shed.footprint.half_width_m));
      Put(house.settlement, shed, &random);
    }
  }

  Placement* placement_;
  SettlementMap map_;
  Builder builder_;
  const std::vector<StreetFront>& fronts_;
  std::uint64_t seed_;
  PlotRule rule_;
  std::vector<int> quota_;  // what each settlement may still get
};

}  // namespace

void PlaceBuildings(Placement* placement) {
  const Terrain& terrain = placement->terrain;
  const DensityField density = DensityFor(*placement, AssetKind::kBuilding);
  if (terrain.weights.vocabulary != Vocabulary::kSuburb ||
      terrain.weights.Find(suburb_letter::kBuilding) == nullptr ||
      density.largest_per_m2() <= 0.0) {
    return;
  }
  // Larger buildings leave room for fewer.
  const double scale = placement->environment.fine_of(AssetType::kArchitecture).scale;
  const double crowding = std::max(1.0, scale * scale);
  const int wanted = static_cast<int>(std::lround(density.Expected(terrain.geometry()) / crowding));
  const std::vector<StreetFront> fronts = StreetFrontsOf(terrain);
  Settler(placement, fronts).Build(wanted);
}

}  // namespace latticeworld
