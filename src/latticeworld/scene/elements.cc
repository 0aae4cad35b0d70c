#include "latticeworld/scene/elements.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// Mass over outer volume [kg/m^3]. Estimates.
double DensityOf(ElementKind kind) {
  switch (kind) {
    case ElementKind::kCrate:
      return 100.0;
    case ElementKind::kLooseStone:
      return 2600.0;
    case ElementKind::kGate:
      return 250.0;
    case ElementKind::kBridge:
      return 500.0;
    case ElementKind::kPost:
      return 600.0;
  }
  return 0.0;
}

double VolumeOf(ElementKind kind, const Eigen::Vector3d& size_m) {
  return (kind == ElementKind::kLooseStone ? M_PI / 6.0 : 1.0) * size_m.prod();
}

struct SizeLimits {
  Eigen::Vector3d low_m, high_m;
};

SizeLimits LimitsOf(ElementKind kind) {
  switch (kind) {
    case ElementKind::kCrate:
      return {{0.1, 0.1, 0.1}, {3.0, 3.0, 3.0}};
    case ElementKind::kLooseStone:
      return {{0.05, 0.05, 0.05}, {2.0, 2.0, 2.0}};
    case ElementKind::kGate:
      return {{0.3, 0.02, 0.3}, {8.0, 0.3, 3.0}};
    case ElementKind::kBridge:
      return {{1.0, 0.3, 0.05}, {40.0, 8.0, 1.0}};
    case ElementKind::kPost:
      return {{0.03, 0.03, 0.2}, {0.5, 0.5, 6.0}};
  }
  return {};
}

constexpr double kLeastMass_kg = 0.05, kLargestMass_kg = 1e5;
constexpr double kLargestStrength = 1e9;

}  // namespace

double UsualMass(ElementKind kind, const Eigen::Vector3d& size_m) {
  return DensityOf(kind) * VolumeOf(kind, size_m);
}

double UsualStrength(ElementKind kind, const Eigen::Vector3d& size_m) {
  constexpr double kBridgeLoad_kgpm2 = 100.0, kPostStrength_pa = 12e6;
  if (kind == ElementKind::kBridge) return kBridgeLoad_kgpm2 * size_m.x() * size_m.y();
  if (kind != ElementKind::kPost) return 0.0;
  const double thin_m = std::min(size_m.x(), size_m.y()), wide_m = std::max(size_m.x(), size_m.y());
  return kPostStrength_pa * wide_m * thin_m * thin_m / 6.0;
}

Element UsualElement(ElementKind kind) {
  Element element;
  element.kind = kind;
  switch (kind) {
    case ElementKind::kCrate:
      element.size_m = {0.5, 0.5, 0.5};
      break;
    case ElementKind::kLooseStone:
      element.size_m = {0.3, 0.3, 0.3};
      break;
    case ElementKind::kGate:
      element.size_m = {1.2, 0.06, 1.1};
      break;
    case ElementKind::kBridge:
      element.size_m = {8.0, 2.0, 0.15};
      break;
    case ElementKind::kPost:
      element.size_m = {0.1, 0.1, 1.2};
      break;
  }
  element.mass_kg = UsualMass(kind, element.size_m);
  element.strength = UsualStrength(kind, element.size_m);
  return element;
}

std::vector<Violation> Validate(const Element& element) {
  std::vector<Violation> violations;
  const auto check = [&](const std::string& field, double value, double low, double high) {
    if (value >= low && value <= high) return;
    violations.push_back({"out_of_range", field,
                          field + " of a " + std::string(NameOf(element.kind)) + " must be in [" +
                              FormatDouble(low) + ", " + FormatDouble(high) + "], not " +
                              FormatDouble(value),
                          FormatDouble(value)});
  };
  const SizeLimits limits = LimitsOf(element.kind);
  constexpr const char* kAxes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    check(std::string("size_m/") + kAxes[i], element.size_m[i], limits.low_m[i], limits.high_m[i]);
  }
  if (element.kind == ElementKind::kLooseStone &&
      (element.size_m.y() != element.size_m.x() || element.size_m.z() != element.size_m.x())) {
    violations.push_back({"not_round", "size_m", "a loose stone has its diameter three times",
                          FormatDouble(element.size_m.y())});
  }
  check("mass_kg", element.mass_kg, kLeastMass_kg, kLargestMass_kg);
  if (element.kind == ElementKind::kBridge || element.kind == ElementKind::kPost) {
    check("strength", element.strength, 0.0, kLargestStrength);
  } else if (!std::isfinite(element.strength)) {
    violations.push_back(
        {"not_finite", "strength", "must be finite", FormatDouble(element.strength)});
  }
  check("yaw_rad", element.yaw_rad, -1000.0, 1000.0);
  for (const auto& [field, value] : {std::pair<const char*, double>{"x", element.position.x_m},
                                     {"y", element.position.y_m},
                                     {"z", element.z_m}}) {
    if (!std::isfinite(value)) {
      violations.push_back(
          {"not_finite", std::string("position/") + field, "must be finite", FormatDouble(value)});
    }
  }
  return violations;
}

Footprint FootprintOf(const Element& element) {
  Footprint footprint = {element.position, element.yaw_rad, 0.5 * element.size_m.x(),
                         0.5 * element.size_m.y()};
  if (element.kind == ElementKind::kGate)
    footprint.centre = footprint.At(footprint.half_length_m, 0);
  return footprint;
}

double GroundUnder(const Terrain& terrain, const Element& element) {
  const HeightField& ground = terrain.ground;
  const Footprint footprint = FootprintOf(element);
  const double ends_m = std::max(ground.HeightAt(footprint.At(footprint.half_length_m, 0.0)),
                                 ground.HeightAt(footprint.At(-footprint.half_length_m, 0.0)));
  switch (element.kind) {
    case ElementKind::kBridge: {
      constexpr double kAbove_m = 0.01;  // of the deck over the bank
      return ends_m + kAbove_m - element.size_m.z();
    }
    case ElementKind::kGate:
      return std::max(ends_m, ground.HeightAt(footprint.centre));
    case ElementKind::kCrate:
    case ElementKind::kLooseStone:
    case ElementKind::kPost:
      break;
  }
  return ground.HeightAt(element.position);
}

}  // namespace latticeworld
