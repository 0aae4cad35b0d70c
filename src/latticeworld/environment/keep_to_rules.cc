#include "latticeworld/environment/keep_to_rules.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/rules.h"

namespace latticeworld {
namespace {

bool IsAngle(FineParameter parameter) {
  return parameter == FineParameter::kRoll || parameter == FineParameter::kPitch ||
         parameter == FineParameter::kYaw;
}

// The nearest legal value; of an angle the same but for whole turns, if it is legal.
double Kept(double value, const Range& range, bool angle) {
  if (range.Contains(value)) return value;
  if (angle) value -= 360.0 * std::floor(value / 360.0);
  const double nearest = std::clamp(value, range.low, range.high);
  return range.Contains(nearest) ? nearest : range.low;
}

class Keeper {
 public:
  Keeper(const Catalogue& catalogue, EnvironmentConfig* environment)
      : catalogue_(catalogue), environment_(*environment) {}

  std::vector<std::string> Run() {
    for (const auto& entry : EnumNames(AssetType{})) KeepFine(entry.value);
    KeepAgents();
    return std::move(changes_);
  }

 private:
  void Tell(const std::string& what, const std::string& was, const std::string& why,
            const std::string& is) {
    changes_.push_back(what + " cannot be " + was + ": " + why + "; it is " + is);
  }

  void KeepValue(const std::string& what, const std::vector<ValueBound>& bounds,
                 std::string* value) {
    const std::string breach = BreachOf(bounds, *value);
    if (breach.empty()) return;
    const ValueBound* usual = nullptr;
    for (const ValueBound& bound : bounds)
      if (bound.legal() && (usual == nullptr || bound.weight > usual->weight)) usual = &bound;
    if (usual == nullptr) return;
    Tell(what, Quote(*value), breach, Quote(usual->name));
    *value = std::string(usual->name);
  }

  void KeepFine(AssetType type) {
    FineAttribute& fine = environment_.fine_of(type);
    const FineBounds bounds = BoundsOf(environment_.coarse, type, catalogue_);
    const std::string name(NameOf(type));
    KeepValue(name + " season_variant", bounds.season_variants, &fine.season_variant);
    KeepValue(name + " material", bounds.materials, &fine.material);
    for (const auto& entry : EnumNames(FineParameter{})) {
      const auto& bound = bounds.number(entry.value);
      if (!bound) continue;
      const double value = ValueOf(fine, entry.value);
      const double kept = Kept(value, bound->range, IsAngle(entry.value));
      if (kept == value) continue;
      const std::string breach = BreachOf(*bound, value);
      Tell(name + " " + std::string(NameOf(entry.value)), FormatDouble(value),
           breach.empty() ? "it is out of its range" : breach, FormatDouble(kept));
      SetValue(entry.value, kept, &fine);
    }
  }

  void KeepAgents() {
    int total = 0;
    for (AgentGroup& group : environment_.agents) {
      const std::string name(NameOf(group.category));
      const int most = std::min(kMaxGroupQuantity, kMaxAgents - total);
      const int kept = std::clamp(group.quantity, std::min(1, most), most);
      if (kept != group.quantity) {
        Tell("the quantity of " + name, std::to_string(group.quantity),
             "a group has 1 to " + std::to_string(kMaxGroupQuantity) + " agents, all together " +
                 std::to_string(kMaxAgents),
             std::to_string(kept));
        group.quantity = kept;
      }
      total += kept;
      if (CanBe(group.category, group.state)) continue;
      Tell("a " + name, std::string(NameOf(group.state)), "its kind is never seen so", "idle");
      group.state = AgentState::kIdle;
    }
    auto& agents = environment_.agents;
    agents.erase(std::remove_if(agents.begin(), agents.end(),
                                [](const AgentGroup& group) { return group.quantity < 1; }),
                 agents.end());
  }

  const Catalogue& catalogue_;
  EnvironmentConfig& environment_;
  std::vector<std::string> changes_;
};

}  // namespace

std::vector<std::string> KeepToRules(const Catalogue& catalogue, EnvironmentConfig* environment) {
  return Keeper(catalogue, environment).Run();
}

}  // namespace latticeworld
