#ifndef LATTICEWORLD_CATALOGUE_CATALOGUE_H_
#define LATTICEWORLD_CATALOGUE_CATALOGUE_H_

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/catalogue/asset_kind.h"
#include "latticeworld/catalogue/asset_type.h"
#include "latticeworld/catalogue/season.h"
#include "latticeworld/common/result.h"
#include "latticeworld/common/rgb.h"

namespace latticeworld {

// Individuals vary between the two.
struct ColorRange {
  Rgb from = {128, 128, 128}, to = {128, 128, 128};
};

struct Reflectivity {
  double lidar = 0.3;       // Lambertian reflectance at 905 nm, [0, 1]
  double radar_db = -10.0;  // normalised radar cross-section at 77 GHz [dB], [-60, 20]
};

// What a value does to the ground that its type makes (grass: meadows, forest: forest floor, road:
// roads, ...): factors on the surface's own properties.
struct GroundEffect {
  double friction = 1.0;            // (0, 2]
  double rolling_resistance = 1.0;  // (0, 20]
  double cone_index = 1.0;          // (0, 5]
};

// A seasonal value of an asset type.
struct SeasonVariant {
  std::string name;
  std::array<bool, kSeasonCount> seasons = {true, true, true, true};  // in which it can be seen
  std::vector<std::uint8_t> models;  // that may wear it, indices into Catalogue::models();
                                     // empty: every model of the type
  std::array<ColorRange, kSeasonCount> color;  // of leaves, blossom, cover or surface, by Season
  double foliage = 1.0;                        // share of the full leaves that it bears, [0, 1]
  double growth = 1.0;                         // share of the full height, (0, 1]
  double snow = 0.0;                           // share of what faces up that snow covers, [0, 1]
  Reflectivity reflectivity;
  GroundEffect ground;
};

// A material value of an asset type.
struct Material {
  std::string name;
  std::vector<std::uint8_t> models;  // that may be made of it; empty: every model of the type
  ColorRange color;                  // of bark, stone, walls, petals, grain or ground
  double density_kgpm3 = 800.0;      // (0, 20000]; wood: green
  double elastic_modulus_pa = 1e9;   // (0, 1e12]
  double bending_strength_pa = 1e7;  // modulus of rupture, (0, 1e10]
  Reflectivity reflectivity;
  GroundEffect ground;
};

// Procedural shapes that models are built by (meshes/).
enum class Shape : std::uint8_t {
  kBroadleafTree,
  kConiferTree,
  kBush,
  kGrassTuft,
  kReed,
  kFlower,
  kBranch,
  kBoulder,
  kSlab,
  kCereal,
  kMaize,
  kRapeseed,
  kVine,
  kGabledHouse,
  kRowHouse,
  kBarn,
  kFlatBlock,
  kTower,
  kParts  // put together from the model's parts
};
constexpr std::array<EnumName<Shape>, 19> EnumNames(Shape) {
  return {{{Shape::kBroadleafTree, "broadleaf_tree"},
           {Shape::kConiferTree, "conifer_tree"},
           {Shape::kBush, "bush"},
           {Shape::kGrassTuft, "grass_tuft"},
           {Shape::kReed, "reed"},
           {Shape::kFlower, "flower"},
           {Shape::kBranch, "branch"},
           {Shape::kBoulder, "boulder"},
           {Shape::kSlab, "slab"},
           {Shape::kCereal, "cereal"},
           {Shape::kMaize, "maize"},
           {Shape::kRapeseed, "rapeseed"},
           {Shape::kVine, "vine"},
           {Shape::kGabledHouse, "gabled_house"},
           {Shape::kRowHouse, "row_house"},
           {Shape::kBarn, "barn"},
           {Shape::kFlatBlock, "flat_block"},
           {Shape::kTower, "tower"},
           {Shape::kParts, "parts"}}};
}

// A simple body of a model of Shape::kParts.
enum class PartForm : std::uint8_t {
  kBox,
  kCylinder,  // upright
  kCone,      // upright, its point above
  kRoller,    // a cylinder that lies across the model's front
  kGable      // a roof whose ridge lies across the model's front
};
constexpr std::array<EnumName<PartForm>, 5> EnumNames(PartForm) {
  return {{{PartForm::kBox, "box"},
           {PartForm::kCylinder, "cylinder"},
           {PartForm::kCone, "cone"},
           {PartForm::kRoller, "roller"},
           {PartForm::kGable, "gable"}}};
}
enum class PartLook : std::uint8_t { kMaterial, kRoof, kWood, kStone, kLeaves, kGlass, kTrim };
constexpr std::array<EnumName<PartLook>, 7> EnumNames(PartLook) {
  return {{{PartLook::kMaterial, "material"},  // the colour of the model's material
           {PartLook::kRoof, "roof"},
           {PartLook::kWood, "wood"},
           {PartLook::kStone, "stone"},
           {PartLook::kLeaves, "leaves"},
           {PartLook::kGlass, "glass"},
           {PartLook::kTrim, "trim"}}};
}
struct ModelPart {
  PartForm form = PartForm::kBox;
  PartLook look = PartLook::kMaterial;
  std::array<double, 3> base_m{};  // middle of its base: towards the front, to the left, up
  std::array<double, 3> size_m{};  // its whole extents along these
};

// What bodies bump into.
enum class Collision : std::uint8_t {
  kNone,
  kTrunk,     // a vertical cylinder of the trunk's radius
  kCylinder,  // a vertical cylinder of the half length
  kBox        // half length x half width x height
};
constexpr std::array<EnumName<Collision>, 4> EnumNames(Collision) {
  return {{{Collision::kNone, "none"},
           {Collision::kTrunk, "trunk"},
           {Collision::kCylinder, "cylinder"},
           {Collision::kBox, "box"}}};
}

// Values drawn around a mean, within limits.
struct SizeRange {
  double mean = 1.0, deviation = 0.0, low = 1.0, high = 1.0;  // 0 < low <= mean <= high
};

// How well a site suits: 1 from low to high, falling evenly to 0 over `fade` on either side.
struct Preference {
  double low = -1e9, high = 1e9, fade = 1.0;
};
struct Habitat {
  Preference altitude;           // 0: the world's lowest ground .. 1: its highest
  Preference slope_deg;          // [0, 90]
  Preference wetness;            // 0: driest ridge .. 1: at the water's edge
  Preference northness;          // -1: steep sunny side .. 1: steep shady side, 0: level
  double shade_tolerance = 0.5;  // 0: needs open sky .. 1: grows below others
  double clumping = 0.0;         // 0: evenly spread .. 1: in groups
};

// The wood of living trees and bushes, green. 0: as the material says.
struct Wood {
  double density_kgpm3 = 0.0;        // [0, 20000]
  double elastic_modulus_pa = 0.0;   // [0, 1e12]
  double bending_strength_pa = 0.0;  // modulus of rupture, [0, 1e10]
};

// Something concrete that stands in worlds: a species, a form of building, a kind of stone.
struct AssetModel {
  std::string name;  // unique in the catalogue: "oak", "barn"
  AssetType type = AssetType::kGrass;
  AssetKind kind = AssetKind::kGrassTuft;
  Shape shape = Shape::kGrassTuft;
  Collision collision = Collision::kNone;
  SizeRange height_m;
  // Half the extents seen from above. Trees: half_length_m = crown_per_trunk x the trunk's radius
  // (crown and trunk diameter grow in proportion, Hemery, Savill and Pryor 2005); buildings: drawn;
  // others: spread x height, half_width_m the same.
  double crown_per_trunk = 0.0;  // trees only, > 1
  // Trees and bushes: the crown's form, for their meshes.
  double crown_base = 0.25;   // share of the height below the lowest branch, [0, 0.9]
  double crown_widest = 0.4;  // where it is widest, share of its length from its base, [0, 1]
  double droop = 0.0;         // -1: branches reach up .. 1: they hang
  SizeRange spread;           // [m/m]
  SizeRange half_length_m;    // buildings only, towards the front
  SizeRange half_width_m;     // buildings only, half the frontage
  double storey_m = 0.0;      // buildings only: heights are whole storeys and a roof; 0: any
  double share = 1.0;         // among the models of its kind where habitats suit alike, > 0
  Habitat habitat;
  // The letters on which it may stand, by vocabulary, as in densities; empty: wherever its kind
  // does, "-": nowhere.
  std::string letters_suburb, letters_wild;
  Wood wood;                     // trees and bushes only
  std::vector<ModelPart> parts;  // Shape::kParts only, at the model's mean size

  // A building that people live or work in: no well, bench or fence.
  bool is_house() const { return kind == AssetKind::kBuilding && shape != Shape::kParts; }
};

// How many of a kind stand on a hectare of a class at density 1.
struct KindDensity {
  AssetKind kind = AssetKind::kTree;
  std::string vocabulary;  // "suburb", "wild"
  char letter = 'G';
  double per_hectare = 0.0;
};

// The values of one asset type by name, as the environment configuration writes them.
struct AssetTypeValues {
  AssetType type = AssetType::kGrass;
  std::vector<std::string_view> season_variants;
  std::vector<std::string_view> materials;
  bool has_rotation = false;  // rotation_deg
  bool has_scale = false;     // scale
  bool has_height = false;    // height_m
  bool has_wind = false;      // wind_mps
  bool has_slope = false;     // slope_deg
};

struct CatalogueFile {
  std::string name;  // as errors say it
  std::string text;  // JSON
};

// Everything that a world can be furnished with: the method's eleven asset types with their 49
// seasonal and 37 material values, and the models that stand for them. Read from JSON files (data/,
// schema: CatalogueSchema()), to which a user may add; immutable.
class Catalogue {
 public:
  // The method's table and nothing else.
  static std::shared_ptr<const Catalogue> BuiltIn();
  // BuiltIn() and these files. A value or model of a name that BuiltIn has takes its place, others
  // are added. Errors: INVALID_ARGUMENT with every violation of every file at once, `pointer` being
  // "<file name>#<JSON pointer>".
  static Result<std::shared_ptr<const Catalogue>> Extended(std::vector<CatalogueFile> files);
  // The same with every *.json of the directories (sorted by name), or files. Errors: also, of all
  // unreadable paths at once, NOT_FOUND, PERMISSION_DENIED or RESOURCE_EXHAUSTED (see limits.h).
  static Result<std::shared_ptr<const Catalogue>> Load(
      const std::vector<std::filesystem::path>& paths);

  const std::vector<SeasonVariant>& season_variants(AssetType type) const;
  const std::vector<Material>& materials(AssetType type) const;
  const AssetTypeValues& ValuesOf(AssetType type) const;
  const std::vector<AssetModel>& models() const { return models_; }  // at most 255
  const std::vector<std::uint8_t>& models_of(AssetKind kind) const;  // in order, never empty
  // Whether a model may wear a seasonal variant, or be of a material.
  bool CanWear(std::uint8_t model, std::size_t season_variant) const;
  bool CanBeOf(std::uint8_t model, std::size_t material) const;
  // Returns how many stand per hectare of a class; 0: the kind does not stand there.
  double PerHectare(AssetKind kind, std::string_view vocabulary, char letter) const;
  // What was added to BuiltIn(), for bundles; empty: nothing.
  const std::vector<CatalogueFile>& added_files() const { return added_files_; }

  Catalogue(const Catalogue&) = delete;
  Catalogue& operator=(const Catalogue&) = delete;

 private:
  friend class CatalogueReader;
  struct TypeEntry {
    std::vector<SeasonVariant> season_variants;
    std::vector<Material> materials;
    AssetTypeValues values;  // views into the two
  };

  Catalogue() = default;

  std::array<TypeEntry, kAssetTypeCount> types_;
  std::vector<AssetModel> models_;
  std::array<std::vector<std::uint8_t>, kAssetKindCount> models_of_;
  std::vector<KindDensity> densities_;
  std::vector<CatalogueFile> added_files_;
};

// JSON Schema (draft 7) of one catalogue file.
std::string_view CatalogueSchema();

// Returns the values that BuiltIn() has for a type.
const AssetTypeValues& ValuesOf(AssetType type);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CATALOGUE_CATALOGUE_H_
