#include <algorithm>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/environment/rules.h"

namespace latticeworld {
namespace {

class Validator {
 public:
  Validator(const EnvironmentConfig& environment, const Catalogue& catalogue)
      : environment_(environment), catalogue_(catalogue) {}

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

  // Whether it is one of the values.
  bool CheckName(const std::string& pointer, const std::string& name,
                 const std::vector<std::string_view>& legal) {
    if (std::find(legal.begin(), legal.end(), name) != legal.end()) return true;
    const std::vector<std::string> names(legal.begin(), legal.end());
    Add("unknown_value", pointer, Quote(name) + " is not one of " + Join(names, ", "), Quote(name));
    return false;
  }

  void CheckValue(const std::string& pointer, const std::string& name,
                  const std::vector<std::string_view>& known,
                  const std::vector<ValueBound>& bounds) {
    if (!CheckName(pointer, name, known)) return;
    const std::string breach = BreachOf(bounds, name);
    if (!breach.empty()) AddConflict(pointer, Quote(name), breach);
  }

  void CheckNumber(const std::string& pointer, double value, const Range& range,
                   const NumberBound& bound) {
    const std::size_t before = violations_.size();
    CheckRange(pointer, value, range, "", &violations_);
    if (violations_.size() > before) return;
    const std::string breach = BreachOf(bound, value);
    if (!breach.empty()) AddConflict(pointer, FormatDouble(value), breach);
  }

  void AddConflict(const std::string& pointer, const std::string& given,
                   const std::string& breach) {
    const CoarseAttributes& coarse = environment_.coarse;
    Add("conflict", pointer,
        given + " does not go with terrain type " + std::string(NameOf(coarse.terrain_type)) +
            ", season " + std::string(NameOf(coarse.season)) + ", weather " +
            std::string(NameOf(coarse.weather)) + " and time of day " +
            std::string(NameOf(coarse.time_of_day)) + ": " + breach,
        given);
  }

  void CheckFine(AssetType type) {
    const FineAttribute& fine = environment_.fine_of(type);
    const AssetTypeValues& values = catalogue_.ValuesOf(type);
    const FineBounds bounds = BoundsOf(environment_.coarse, type, catalogue_);
    const std::string pointer = "/fine/" + std::string(NameOf(type));
    CheckValue(pointer + "/season_variant", fine.season_variant, values.season_variants,
               bounds.season_variants);
    CheckValue(pointer + "/material", fine.material, values.materials, bounds.materials);
    for (const auto& entry : EnumNames(FineParameter{})) {
      const auto& bound = bounds.number(entry.value);
      if (!bound) continue;
      CheckNumber(pointer + PointerOf(entry.value), ValueOf(fine, entry.value),
                  RangeOf(entry.value), *bound);
    }
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
  const Catalogue& catalogue_;
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<Violation> Validate(const EnvironmentConfig& environment, const Catalogue& catalogue) {
  return Validator(environment, catalogue).Run();
}

std::vector<Violation> Validate(const EnvironmentConfig& environment) {
  return Validate(environment, *Catalogue::BuiltIn());
}

}  // namespace latticeworld
