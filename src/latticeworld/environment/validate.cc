#include <algorithm>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/environment/ranges.h"
#include "latticeworld/environment/season_rules.h"

namespace latticeworld {
namespace {

class Validator {
 public:
  explicit Validator(const EnvironmentConfig& environment) : environment_(environment) {}

  std::vector<Violation> Run() {
    for (const auto& entry : EnumNames(AssetType{})) CheckFine(entry.value);
    CheckAgents();
    return std::move(violations_);
  }

 private:
  void Add(std::string code, std::string pointer, std::string message, std::string given) {
    violations_.push_back(
        {std::move(code), std::move(pointer), std::move(message), std::move(given)});
  }

  void CheckRange(std::string pointer, double value, const Range& range) {
    latticeworld::CheckRange(std::move(pointer), value, range, "", &violations_);
  }

  void CheckName(const std::string& pointer, const std::string& name,
                 const std::vector<std::string_view>& legal) {
    if (std::find(legal.begin(), legal.end(), name) != legal.end()) return;
    const std::vector<std::string> names(legal.begin(), legal.end());
    Add("unknown_value", pointer, Quote(name) + " is not one of " + Join(names, ", "), Quote(name));
  }

  void CheckFine(AssetType type) {
    const FineAttribute& fine = environment_.fine_of(type);
    const AssetTypeValues& values = ValuesOf(type);
    const std::string pointer = "/fine/" + std::string(NameOf(type));
    const std::size_t before = violations_.size();
    CheckName(pointer + "/season_variant", fine.season_variant, values.season_variants);
    if (violations_.size() == before &&
        !IsAllowed(type, fine.season_variant, environment_.coarse)) {
      Add("conflict", pointer + "/season_variant",
          Quote(fine.season_variant) + " does not go with season " +
              std::string(NameOf(environment_.coarse.season)) + " and weather " +
              std::string(NameOf(environment_.coarse.weather)),
          Quote(fine.season_variant));
    }
    CheckName(pointer + "/material", fine.material, values.materials);
    CheckRange(pointer + "/density", fine.density, kDensityRange);
    if (values.has_rotation) {
      for (int i = 0; i < 3; ++i) {
        CheckRange(pointer + "/rotation/" + std::to_string(i),
                   fine.rotation_deg[static_cast<std::size_t>(i)], kRotationRange);
      }
    }
    if (values.has_scale) CheckRange(pointer + "/scale", fine.scale, kScaleRange);
    if (values.has_height) CheckRange(pointer + "/height", fine.height_m, kHeightRange);
    if (values.has_wind) CheckRange(pointer + "/wind", fine.wind_mps, kWindRange);
    if (values.has_slope) CheckRange(pointer + "/slope", fine.slope_deg, kSlopeRange);
  }

  void CheckAgents() {
    int total = 0;
    for (std::size_t i = 0; i < environment_.agents.size(); ++i) {
      const AgentGroup& group = environment_.agents[i];
      const std::string pointer = "/agents/" + std::to_string(i);
      if (group.quantity < 1 || group.quantity > kMaxGroupQuantity) {
        Add("out_of_range", pointer + "/quantity",
            "must be from 1 to " + std::to_string(kMaxGroupQuantity) + ", not " +
                std::to_string(group.quantity),
            std::to_string(group.quantity));
      } else {
        total += group.quantity;
      }
      if (!CanBe(group.category, group.state)) {
        Add("conflict", pointer + "/state",
            "a " + std::string(NameOf(group.category)) + " cannot be " +
                std::string(NameOf(group.state)),
            std::string(NameOf(group.state)));
      }
    }
    if (total > kMaxAgents) {
      Add("out_of_range", "/agents",
          std::to_string(total) + " agents in all; at most " + std::to_string(kMaxAgents) +
              " are legal",
          std::to_string(total));
    }
  }

  const EnvironmentConfig& environment_;
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<Violation> Validate(const EnvironmentConfig& environment) {
  return Validator(environment).Run();
}

}  // namespace latticeworld
