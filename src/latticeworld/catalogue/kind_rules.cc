#include "latticeworld/catalogue/kind_rules.h"

#include <algorithm>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// Letters of the classes of the layout room, a floor above.
constexpr std::string_view kSuburbLetters = "ABDFGRW", kWildLetters = "BFRSW";

std::vector<Shape> ShapesOf(AssetKind kind) {
  switch (kind) {
    case AssetKind::kTree:
      return {Shape::kBroadleafTree, Shape::kConiferTree};
    case AssetKind::kBush:
      return {Shape::kBush};
    case AssetKind::kStone:
      return {Shape::kBoulder, Shape::kSlab};
    case AssetKind::kBuilding:
      return {Shape::kGabledHouse, Shape::kRowHouse, Shape::kBarn,
              Shape::kFlatBlock,   Shape::kTower,    Shape::kParts};
    case AssetKind::kDeadBranch:
      return {Shape::kBranch};
    case AssetKind::kGrassTuft:
      return {Shape::kGrassTuft, Shape::kReed};
    case AssetKind::kFlower:
      return {Shape::kFlower};
    case AssetKind::kCrop:
      return {Shape::kCereal, Shape::kMaize, Shape::kRapeseed, Shape::kVine};
  }
  return {};
}

Collision CollisionOf(AssetKind kind) {
  switch (kind) {
    case AssetKind::kTree:
      return Collision::kTrunk;
    case AssetKind::kStone:
      return Collision::kCylinder;
    case AssetKind::kBuilding:
      return Collision::kBox;
    default:
      return Collision::kNone;
  }
}

}  // namespace

std::string KindsOf(AssetType type) {
  std::vector<std::string> names;
  for (const auto& kind : EnumNames(AssetKind{})) {
    if (TypeOf(kind.value) == type) names.emplace_back(kind.name);
  }
  return names.empty() ? "none" : Join(names, ", ");
}

void CheckModelKind(const AssetModel& model, const std::string& pointer,
                    std::vector<Violation>* violations) {
  const std::string kind(NameOf(model.kind));
  if (TypeOf(model.kind) != model.type) {
    violations->push_back({"wrong_kind", pointer + "/kind",
                           Quote(kind) + " is not a kind of " + std::string(NameOf(model.type)) +
                               "; legal: " + KindsOf(model.type),
                           Quote(kind)});
  }
  const std::vector<Shape> shapes = ShapesOf(model.kind);
  if (std::find(shapes.begin(), shapes.end(), model.shape) == shapes.end()) {
    std::vector<std::string> legal;
    for (const Shape shape : shapes) legal.emplace_back(NameOf(shape));
    violations->push_back({"wrong_kind", pointer + "/shape",
                           Quote(NameOf(model.shape)) + " is not a shape of a " + kind +
                               "; legal: " + Join(legal, ", "),
                           Quote(NameOf(model.shape))});
  }
  if (model.collision != CollisionOf(model.kind)) {
    violations->push_back({"wrong_kind", pointer + "/collision",
                           "a " + kind + " has " + std::string(NameOf(CollisionOf(model.kind))) +
                               ", not " + Quote(NameOf(model.collision)),
                           Quote(NameOf(model.collision))});
  }
}

void CheckModelParts(const AssetModel& model, const std::string& pointer,
                     std::vector<Violation>* violations) {
  const bool needs = model.shape == Shape::kParts;
  if (needs == !model.parts.empty()) return;
  violations->push_back(
      {needs ? "missing_key" : "unknown_key", pointer + "/parts",
       needs ? "is missing; the shape parts needs it" : "only the shape parts has parts",
       needs ? "" : Quote("parts")});
}

void CheckModelKey(const ModelKey& key, AssetKind kind, bool is_given, const std::string& pointer,
                   std::vector<Violation>* violations) {
  const bool is_legal = key.is_for(kind);
  const std::string what = "a " + std::string(NameOf(kind));
  if (is_legal && key.is_required && !is_given) {
    violations->push_back(
        {"missing_key", pointer + "/" + key.name, "is missing; " + what + " needs it", ""});
  } else if (!is_legal && is_given) {
    violations->push_back(
        {"unknown_key", pointer + "/" + key.name, what + " has no " + key.name, Quote(key.name)});
  }
}

void CheckLetters(std::string_view letters, std::string_view vocabulary, const std::string& pointer,
                  std::vector<Violation>* violations) {
  const std::string_view legal = vocabulary == "suburb" ? kSuburbLetters : kWildLetters;
  if (letters == "-" || letters.find_first_not_of(legal) == std::string_view::npos) return;
  violations->push_back({"unknown_value", pointer,
                         Quote(letters) + " must be letters of " + std::string(legal) + ", or -",
                         Quote(letters)});
}

}  // namespace latticeworld
