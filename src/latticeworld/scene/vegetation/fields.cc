#include "latticeworld/scene/vegetation/fields.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/layout/class_letters.h"

namespace latticeworld {
namespace {

constexpr double kLong_m = 110.0, kAcross_m = 65.0;  // of a field, about
constexpr double kUneven = 0.25;                     // how far borders move, in sides
constexpr double kMargin_m = 1.2;                    // free along a field's border
constexpr double kLeastFieldWeight = 0.5;  // rows end where the field does, not in its blended hem
constexpr double kAcrossShare = 0.25;      // of the fields have their rows across
constexpr double kOrchardShare = 0.4;      // of the fields near settlements
constexpr double kUsualForest = 0.5;       // density from which orchards are not fewer
constexpr double kNearSettlement_m = 90.0;
constexpr double kUphillSlope_deg = 3.0;

// Returns where the k-th border between fields lies along an axis [m].
double BorderAt(std::uint64_t seed, int k, double side_m) {
  const double draw = HashToUnit(seed, k, 0);
  return (k - 0.5 + kUneven * (2.0 * draw - 1.0)) * side_m;
}

bool IsNearSettlement(const Terrain& terrain, WorldPoint point) {
  if (terrain.weights.vocabulary != Vocabulary::kSuburb) return false;
  const WeightGrid* weight = terrain.weights.Find(suburb_letter::kBuilding);
  if (weight == nullptr) return false;
  constexpr int kDirections = 12, kRings = 3;
  for (int ring = 1; ring <= kRings; ++ring) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle_rad = 2.0 * M_PI * i / kDirections;
      const double reach_m = kNearSettlement_m * ring / kRings;
      const WorldPoint there = {point.x_m + reach_m * std::cos(angle_rad),
                                point.y_m + reach_m * std::sin(angle_rad)};
      if (terrain.geometry().Contains(there) &&
          (*weight)[terrain.geometry().CellAt(there)] > 0.5f) {
        return true;
      }
    }
  }
  return false;
}

// Trees that stand on that letter and not in forests.
std::vector<std::uint8_t> OrchardModels(const Placement& placement, char letter) {
  std::vector<std::uint8_t> models;
  if (placement.terrain.weights.vocabulary != Vocabulary::kSuburb) return models;
  for (const std::uint8_t model : placement.catalogue.models_of(AssetKind::kTree)) {
    const std::string& letters = placement.catalogue.models()[model].letters_suburb;
    if (letters.find(letter) != std::string::npos &&
        letters.find(class_letter::kForest) == std::string::npos) {
      models.push_back(model);
    }
  }
  return models;
}

}  // namespace

FieldPlan::FieldPlan(const Placement& placement) {
  const Terrain& terrain = placement.terrain;
  const DensityField density(terrain.weights, placement.environment, placement.catalogue,
                             AssetKind::kCrop, 1.0);
  const std::uint64_t seed = StreamSeed(placement.seed, "scene/fields");
  const Vocabulary vocabulary = terrain.weights.vocabulary;
  const ModelMixture crops(placement.catalogue, placement.environment, AssetKind::kCrop, vocabulary,
                           StreamSeed(seed, "crops"));
  const ModelMixture trees(placement.catalogue, placement.environment, AssetKind::kTree, vocabulary,
                           StreamSeed(seed, "trees"));
  for (const DensityField::Term& term : density.terms()) {
    areas_.push_back(std::make_unique<ClassAreas>(terrain.geometry(), *term.weight));
    Divide(placement, term, *areas_.back(), crops, trees, OrchardModels(placement, term.letter));
  }
}

void FieldPlan::Divide(const Placement& placement, const DensityField::Term& term,
                       const ClassAreas& areas, const ModelMixture& crops,
                       const ModelMixture& trees, const std::vector<std::uint8_t>& orchard_models) {
  const Terrain& terrain = placement.terrain;
  const double turn_rad =
      placement.environment.fine_of(AssetType::kCrops).rotation_deg[2] * M_PI / 180.0;
  const double orchard_share =
      kOrchardShare *
      std::min(1.0, placement.environment.fine_of(AssetType::kForest).density / kUsualForest);
  for (std::size_t i = 0; i < areas.areas().size(); ++i) {
    const ClassAreas::Area& area = areas.areas()[i];
    const std::uint64_t seed =
        StreamSeed(placement.seed, "scene/fields/" + std::string(1, term.letter)) + 2 * i;
    const double cosine = std::cos(area.direction_rad), sine = std::sin(area.direction_rad);
    const int along_count = static_cast<int>(std::ceil(area.reach_m / kLong_m)) + 1;
    const int across_count = static_cast<int>(std::ceil(area.reach_m / kAcross_m)) + 1;
    for (int a = -along_count; a < along_count; ++a) {
      for (int b = -across_count; b < across_count; ++b) {
        PointRandom random(seed, static_cast<std::uint64_t>(a + along_count) << 32 |
                                     static_cast<std::uint32_t>(b + across_count));
        const double a_low = BorderAt(seed, a, kLong_m), a_high = BorderAt(seed, a + 1, kLong_m);
        // Columns of fields have borders of their own across.
        const std::uint64_t column =
            seed + 1 + MixBits(static_cast<std::uint64_t>(a + along_count));
        const double b_low = BorderAt(column, b, kAcross_m);
        const double b_high = BorderAt(column, b + 1, kAcross_m);
        const double along = 0.5 * (a_low + a_high), across = 0.5 * (b_low + b_high);
        Field field;
        field.centre = {area.centre.x_m + cosine * along - sine * across,
                        area.centre.y_m + sine * along + cosine * across};
        field.axis_rad = area.direction_rad;
        field.half_long_m = 0.5 * (a_high - a_low);
        field.half_across_m = 0.5 * (b_high - b_low);
        field.crop_per_m2 = term.per_m2;
        field.areas = &areas;
        field.area = static_cast<int>(i);
        field.weight = term.weight;
        // The middle stands for the field, moved into the world where it is outside.
        const double limit_m = terrain.geometry().half_size_m();
        const WorldPoint middle = {std::clamp(field.centre.x_m, -limit_m, limit_m),
                                   std::clamp(field.centre.y_m, -limit_m, limit_m)};
        const Site site = placement.sites.At(middle);
        field.row_rad =
            area.direction_rad + turn_rad + (random.Chance(kAcrossShare) ? 0.5 * M_PI : 0.0);
        const bool orchard = !orchard_models.empty() && random.Chance(orchard_share) &&
                             IsNearSettlement(terrain, middle);
        if (orchard) {
          field.kind = AssetKind::kTree;
          field.choice = trees.Dress(
              orchard_models[static_cast<std::size_t>(random.Uniform() * orchard_models.size())],
              &random);
        } else {
          const std::optional<ModelMixture::Choice> choice =
              crops.At(middle, site, 0.0, term.letter, &random);
          if (!choice) continue;  // too high or too steep for any crop
          field.choice = *choice;
          const Shape shape = placement.catalogue.models()[choice->model].shape;
          if (shape == Shape::kVine && site.slope_deg > kUphillSlope_deg) {
            const Eigen::Vector3d normal = terrain.ground.NormalAt(middle);
            field.row_rad = std::atan2(-normal.y(), -normal.x());
          }
        }
        fields_.push_back(field);
      }
    }
  }
}

double InnerShareOf(const Field& field) {
  return std::max(0.0, 1.0 - kMargin_m / field.half_long_m) *
         std::max(0.0, 1.0 - kMargin_m / field.half_across_m);
}

std::vector<WorldPoint> RowsOf(const Field& field, const GridGeometry& geometry, double rows_m,
                               double between_m, double jitter, PointRandom* random) {
  std::vector<WorldPoint> points;
  const double axis_cosine = std::cos(field.axis_rad), axis_sine = std::sin(field.axis_rad);
  const double cosine = std::cos(field.row_rad), sine = std::sin(field.row_rad);
  const double reach_m = std::hypot(field.half_long_m, field.half_across_m);
  const int rows = static_cast<int>(reach_m / rows_m) + 1;
  const int places = static_cast<int>(reach_m / between_m) + 1;
  for (int row = -rows; row <= rows; ++row) {
    for (int place = -places; place <= places; ++place) {
      const double along = (place + random->Uniform(-jitter, jitter)) * between_m;
      const double across = row * rows_m;
      const double dx_m = cosine * along - sine * across, dy_m = sine * along + cosine * across;
      if (std::abs(axis_cosine * dx_m + axis_sine * dy_m) > field.half_long_m - kMargin_m ||
          std::abs(axis_cosine * dy_m - axis_sine * dx_m) > field.half_across_m - kMargin_m) {
        continue;
      }
      const WorldPoint point = {field.centre.x_m + dx_m, field.centre.y_m + dy_m};
      if (geometry.Contains(point) && field.areas->AreaAt(point) == field.area &&
          (*field.weight)[geometry.CellAt(point)] >= kLeastFieldWeight) {
        points.push_back(point);
      }
    }
  }
  return points;
}

}  // namespace latticeworld
