#ifndef LATTICEWORLD_SCENE_SETTLEMENTS_PLOTS_H_
#define LATTICEWORLD_SCENE_SETTLEMENTS_PLOTS_H_

#include <vector>

#include "latticeworld/scene/builder.h"
#include "latticeworld/scene/settlements/street_fronts.h"

namespace latticeworld {

// A stretch of a street's edge that something is to be built on: one building, or a terrace.
struct Plot {
  int settlement = 0;
  double order = 0.0;  // plots of low order are built on first: those near the heart
  std::vector<BuildingPlan> buildings;
};

// What plots are laid out by.
struct PlotRule {
  double rotation_rad = 0.0;  // of every building against its street
  double sparseness = 1.0;    // factor on the gaps beside houses, >= 1
};

// Divides the street fronts into plots. What is built on each follows from its surroundings:
// detached houses on lanes, terraces in the denser parts of towns, above all along their roads,
// apartment blocks and towers in the inner parts of cities, farmhouses near fields.
std::vector<Plot> PlotsAlong(const std::vector<StreetFront>& fronts, const Terrain& terrain,
                             const SettlementMap& map, const BuildingModels& models,
                             const PlotRule& rule, PointRandom* random);

// The church of a settlement and where it may stand, best place first.
std::vector<BuildingPlan> ChurchPlans(const std::vector<StreetFront>& fronts,
                                      const Terrain& terrain, const SettlementMap& map,
                                      int settlement, const BuildingModels& models,
                                      const PlotRule& rule, PointRandom* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SETTLEMENTS_PLOTS_H_
