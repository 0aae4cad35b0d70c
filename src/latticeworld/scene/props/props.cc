#include "latticeworld/scene/props/props.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// Mass over outer volume [kg/m^3]. Estimates.
double DensityOf(PropKind kind) {
  switch (kind) {
    case PropKind::kCrate:
      return 100.0;
    case PropKind::kLooseStone:
      return 2600.0;
    case PropKind::kGate:
      return 250.0;
    case PropKind::kBridge:
      return 500.0;
    case PropKind::kPost:
      return 600.0;
  }
  return 0.0;
}

double VolumeOf(PropKind kind, const Eigen::Vector3d& size_m) {
  return (kind == PropKind::kLooseStone ? M_PI / 6.0 : 1.0) * size_m.prod();
}

struct SizeLimits {
  Eigen::Vector3d low_m, high_m;
};

SizeLimits LimitsOf(PropKind kind) {
  switch (kind) {
    case PropKind::kCrate:
      return {{0.1, 0.1, 0.1}, {3.0, 3.0, 3.0}};
    case PropKind::kLooseStone:
      return {{0.05, 0.05, 0.05}, {2.0, 2.0, 2.0}};
    case PropKind::kGate:
      return {{0.3, 0.02, 0.3}, {8.0, 0.3, 3.0}};
    case PropKind::kBridge:
      return {{1.0, 0.3, 0.05}, {40.0, 8.0, 1.0}};
    case PropKind::kPost:
      return {{0.03, 0.03, 0.2}, {0.5, 0.5, 6.0}};
  }
  return {};
}

constexpr double kLeastMass_kg = 0.05, kLargestMass_kg = 1e5;
constexpr double kLargestStrength = 1e9;

}  // namespace

double UsualMass(PropKind kind, const Eigen::Vector3d& size_m) {
  return DensityOf(kind) * VolumeOf(kind, size_m);
}

double UsualStrength(PropKind kind, const Eigen::Vector3d& size_m) {
  constexpr double kBridgeLoad_kgpm2 = 100.0, kPostStrength_pa = 12e6;
  if (kind == PropKind::kBridge) return kBridgeLoad_kgpm2 * size_m.x() * size_m.y();
  if (kind != PropKind::kPost) return 0.0;
  const double thin_m = std::min(size_m.x(), size_m.y()), wide_m = std::max(size_m.x(), size_m.y());
  return kPostStrength_pa * wide_m * thin_m * thin_m / 6.0;
}

Prop UsualProp(PropKind kind) {
  Prop prop;
  prop.kind = kind;
  switch (kind) {
    case PropKind::kCrate:
      prop.size_m = {0.5, 0.5, 0.5};
      break;
    case PropKind::kLooseStone:
      prop.size_m = {0.3, 0.3, 0.3};
      break;
    case PropKind::kGate:
      prop.size_m = {1.2, 0.06, 1.1};
      break;
    case PropKind::kBridge:
      prop.size_m = {8.0, 2.0, 0.15};
      break;
    case PropKind::kPost:
      prop.size_m = {0.1, 0.1, 1.2};
      break;
  }
  prop.mass_kg = UsualMass(kind, prop.size_m);
  prop.strength = UsualStrength(kind, prop.size_m);
  return prop;
}

Prop PropOf(PropKind kind, const Eigen::Vector3d& size_m, double mass_kg, double strength) {
  Prop prop = UsualProp(kind);
  for (int i = 0; i < 3; ++i) {
    if (size_m[i] != 0.0) prop.size_m[i] = size_m[i];
  }
  if (kind == PropKind::kLooseStone) prop.size_m.setConstant(prop.size_m.x());
  const SizeLimits limits = LimitsOf(kind);
  const bool legal = (prop.size_m.array() >= limits.low_m.array()).all() &&
                     (prop.size_m.array() <= limits.high_m.array()).all();
  if (legal) {
    prop.mass_kg = UsualMass(kind, prop.size_m);
    prop.strength = UsualStrength(kind, prop.size_m);
  }
  if (mass_kg != 0.0) prop.mass_kg = mass_kg;
  if (strength != 0.0) prop.strength = strength;
  return prop;
}

std::vector<Violation> Validate(const Prop& prop) {
  std::vector<Violation> violations;
  const auto check = [&](const std::string& field, double value, const Range& legal,
                         const char* unit) {
    if (legal.Contains(value)) return;
    violations.push_back({"out_of_range", field,
                          "of a " + std::string(NameOf(prop.kind)) + " must be from " +
                              FormatDouble(legal.low) + " to " + FormatDouble(legal.high) + unit +
                              ", not " + FormatDouble(value),
                          FormatDouble(value)});
  };
  const auto check_finite = [&violations](const char* field, double value) {
    if (std::isfinite(value)) return;
    violations.push_back(
        {"not_finite", field, "must be finite, not " + FormatDouble(value), FormatDouble(value)});
  };
  const SizeLimits limits = LimitsOf(prop.kind);
  constexpr const char* kAxes[] = {"size.x", "size.y", "size.z"};
  const bool is_round = prop.size_m.y() == prop.size_m.x() && prop.size_m.z() == prop.size_m.x();
  // What is wrong with the diameter of a loose stone is said once.
  const int sides = prop.kind == PropKind::kLooseStone ? 1 : 3;
  for (int i = 0; i < sides; ++i) {
    check(kAxes[i], prop.size_m[i], {limits.low_m[i], limits.high_m[i]}, " m");
  }
  if (prop.kind == PropKind::kLooseStone && std::isfinite(prop.size_m.x()) && !is_round) {
    violations.push_back({"not_round", "size", "of a loose stone must be its diameter three times",
                          FormatDouble(prop.size_m.y())});
  }
  check("mass", prop.mass_kg, {kLeastMass_kg, kLargestMass_kg}, " kg");
  if (prop.kind == PropKind::kBridge || prop.kind == PropKind::kPost) {
    check("strength", prop.strength, {0.0, kLargestStrength}, "");
  } else {
    check_finite("strength", prop.strength);
  }
  check("heading", prop.yaw_rad, {-1000.0, 1000.0}, " rad");
  check_finite("position.x", prop.position.x_m);
  check_finite("position.y", prop.position.y_m);
  check_finite("position.z", prop.z_m);
  return violations;
}

Footprint FootprintOf(const Prop& prop) {
  Footprint footprint = {prop.position, prop.yaw_rad, 0.5 * prop.size_m.x(), 0.5 * prop.size_m.y()};
  if (prop.kind == PropKind::kGate) footprint.centre = footprint.At(footprint.half_length_m, 0);
  return footprint;
}

double GroundUnder(const Terrain& terrain, const Prop& prop) {
  const HeightField& ground = terrain.ground;
  const Footprint footprint = FootprintOf(prop);
  const double ends_m = std::max(ground.HeightAt(footprint.At(footprint.half_length_m, 0.0)),
                                 ground.HeightAt(footprint.At(-footprint.half_length_m, 0.0)));
  switch (prop.kind) {
    case PropKind::kBridge: {
      constexpr double kAbove_m = 0.01;  // of the deck over the bank
      return ends_m + kAbove_m - prop.size_m.z();
    }
    case PropKind::kGate:
      return std::max(ends_m, ground.HeightAt(footprint.centre));
    case PropKind::kCrate:
    case PropKind::kLooseStone:
    case PropKind::kPost:
      break;
  }
  return ground.HeightAt(prop.position);
}

}  // namespace latticeworld
