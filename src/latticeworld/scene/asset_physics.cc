#include "latticeworld/scene/asset_physics.h"

#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kGravity_mps2 = 9.80665;

// Trees.
constexpr double kFormFactor = 0.45;         // stem volume over cylinder; West (2015), 0.4 to 0.5
constexpr double kBroadleafExpansion = 1.4;  // whole tree over stem
constexpr double kConiferExpansion = 1.3;
constexpr double kKnotFactor = 0.85;         // strength of a stem over that of clear wood
constexpr double kUprooting_nmpkg = 120.0;   // Byrne (2005): 77 to 146 for four conifers
constexpr double kUprootingAngle_rad = 0.1;  // lean of the root plate when it gives; estimate

// Others. Estimates.
constexpr double kStoneFill = 2.0 / 3.0;  // ellipsoid over cylinder
constexpr double kPlantFill = 0.003;      // stems and leaves: some kilograms a cubic metre
constexpr double kBranchFill = 0.35;      // taper and forks over cylinder
constexpr double kWallFill = 0.15;        // walls, floors and roof over outer volume
constexpr double kContents_kgpm3 = 40.0;  // of a building

Wood WoodOf(const AssetModel& model, const Material& material) {
  if (model.wood.density_kgpm3 > 0.0) return model.wood;
  return {material.density_kgpm3, material.elastic_modulus_pa, material.bending_strength_pa};
}

CollisionPrimitive CollisionOf(const AssetModel& model, const Asset& asset) {
  CollisionPrimitive collision;
  collision.form = model.collision;
  switch (model.collision) {
    case Collision::kNone:
      return collision;
    case Collision::kTrunk:
      collision.radius_m = asset.trunk_radius_m;
      break;
    case Collision::kCylinder:
      collision.radius_m = asset.half_length_m;
      break;
    case Collision::kBox:
      collision.half_length_m = asset.half_length_m;
      collision.half_width_m = asset.half_width_m;
      break;
  }
  collision.height_m = asset.height_m;
  return collision;
}

void SetTree(const AssetModel& model, const Wood& wood, const Asset& asset, AssetPhysics* physics) {
  const double radius_m = asset.trunk_radius_m, height_m = asset.height_m;
  const double stem_m3 = kFormFactor * M_PI * radius_m * radius_m * height_m;
  const double stem_kg = stem_m3 * wood.density_kgpm3;
  physics->mass_kg =
      stem_kg * (model.shape == Shape::kConiferTree ? kConiferExpansion : kBroadleafExpansion);
  const double section_modulus_m3 = M_PI / 4.0 * radius_m * radius_m * radius_m;
  physics->breaking_moment_nm = kKnotFactor * wood.bending_strength_pa * section_modulus_m3;
  physics->uprooting_moment_nm = kUprooting_nmpkg * stem_kg;
  if (physics->mass_kg <= 0.0) return;
  const double second_moment_m4 = section_modulus_m3 * radius_m;
  const double stem_nmprad = 3.0 * wood.elastic_modulus_pa * second_moment_m4 / height_m;
  const double roots_nmprad = physics->uprooting_moment_nm / kUprootingAngle_rad;
  physics->base_stiffness_nmprad = 1.0 / (1.0 / stem_nmprad + 1.0 / roots_nmprad);
}

}  // namespace

AssetPhysics PhysicsOf(const Catalogue& catalogue, const Asset& asset) {
  const AssetModel& model = catalogue.models()[asset.model];
  const Material& material = catalogue.materials(model.type)[asset.material];
  const Wood wood = WoodOf(model, material);
  const double length_m = asset.half_length_m, width_m = asset.half_width_m,
               height_m = asset.height_m;
  const double round_m3 =
      M_PI * length_m * width_m * height_m;  // of the upright cylinder around it
  AssetPhysics physics;
  physics.collision = CollisionOf(model, asset);
  switch (model.kind) {
    case AssetKind::kTree:
      SetTree(model, wood, asset, &physics);
      break;
    case AssetKind::kStone:
      physics.mass_kg = material.density_kgpm3 * kStoneFill * round_m3;
      physics.base_stiffness_nmprad = kInfinity;
      physics.breaking_moment_nm = kInfinity;
      physics.uprooting_moment_nm = physics.mass_kg * kGravity_mps2 * length_m;
      break;
    case AssetKind::kBuilding:
      physics.mass_kg = (kWallFill * material.density_kgpm3 + kContents_kgpm3) * 4.0 * length_m *
                        width_m * height_m;
      physics.base_stiffness_nmprad = kInfinity;
      physics.breaking_moment_nm = kInfinity;
      physics.uprooting_moment_nm = kInfinity;
      break;
    case AssetKind::kDeadBranch:  // lies: as thick as it is high
      physics.mass_kg =
          wood.density_kgpm3 * kBranchFill * M_PI / 4.0 * height_m * height_m * 2.0 * length_m;
      break;
    case AssetKind::kBush:
    case AssetKind::kGrassTuft:
    case AssetKind::kFlower:
    case AssetKind::kCrop:
      physics.mass_kg = wood.density_kgpm3 * kPlantFill * round_m3;
      break;
  }
  return physics;
}

}  // namespace latticeworld
