#ifndef LATTICEWORLD_SCENE_VEGETATION_FIELDS_H_
#define LATTICEWORLD_SCENE_VEGETATION_FIELDS_H_

#include <memory>
#include <vector>

#include "latticeworld/scene/class_areas.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/vegetation/model_mixture.h"

namespace latticeworld {

// A piece of farmland with one crop, or an orchard, in rows of one direction.
struct Field {
  AssetKind kind = AssetKind::kCrop;  // or kTree: an orchard
  ModelMixture::Choice choice;        // what grows
  WorldPoint centre;
  double axis_rad = 0.0;     // of its longer side
  double half_long_m = 0.0;  // half the sides, what is left free between fields included
  double half_across_m = 0.0;
  double row_rad = 0.0;               // along its rows
  double crop_per_m2 = 0.0;           // what the densities ask for on its land, before thinning
  const ClassAreas* areas = nullptr;  // its land is what is there
  int area = 0;                       //   of this area
  const WeightGrid* weight = nullptr;
};

// The farmland of a world cut into fields: each connected area along its main direction into pieces
// of about 110 by 65 metres, as far as it reaches. The environment's crop grows on most of them;
// others that suit grow on the rest, and near settlements some are orchards where the catalogue has
// a tree that stands on farmland and not in forests, the fewer the thinner the forests are, and
// none in a world without trees. Rows run along the field or across it; vines run up the slope.
class FieldPlan {
 public:
  explicit FieldPlan(const Placement& placement);

  const std::vector<Field>& fields() const { return fields_; }

 private:
  void Divide(const Placement& placement, const DensityField::Term& term, const ClassAreas& areas,
              const ModelMixture& crops, const ModelMixture& trees,
              const std::vector<std::uint8_t>& orchard_models);

  std::vector<std::unique_ptr<ClassAreas>> areas_;  // of the classes with crops
  std::vector<Field> fields_;
};

// The places of a field's rows: on its land, `between_m` apart along rows that are `rows_m` apart,
// each moved by up to jitter x between_m along its row. A margin is left free at its border.
std::vector<WorldPoint> RowsOf(const Field& field, const GridGeometry& geometry, double rows_m,
                               double between_m, double jitter, PointRandom* random);
// Share of the field inside its margin.
double InnerShareOf(const Field& field);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_VEGETATION_FIELDS_H_
