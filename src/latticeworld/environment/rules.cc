#include "latticeworld/environment/rules.h"

#include "latticeworld/common/text.h"
#include "latticeworld/environment/rule_book.h"

namespace latticeworld {
namespace {

std::string Named(const RuleLabel& label) { return "the rule " + label.id; }
std::string Reason(const RuleLabel& label) { return " (" + label.why + ")"; }

}  // namespace

FineBounds BoundsOf(const CoarseAttributes& coarse, AssetType type, const Catalogue& catalogue) {
  return RuleBook::BuiltIn().BoundsOf(coarse, type, catalogue);
}

FineBounds BoundsOf(const CoarseAttributes& coarse, AssetType type) {
  return BoundsOf(coarse, type, *Catalogue::BuiltIn());
}

std::string BreachOf(const std::vector<ValueBound>& values, std::string_view name) {
  const ValueBound* given = nullptr;
  std::vector<std::string> legal;
  for (const ValueBound& value : values) {
    if (value.name == name) given = &value;
    if (value.legal()) legal.emplace_back(value.name);
  }
  const std::string instead = "; legal are " + Join(legal, ", ");
  if (given == nullptr) return "there is no such value" + instead;
  if (given->legal()) return "";
  return Named(*given->excluded) + " excludes it" + Reason(*given->excluded) + instead;
}

std::string BreachOf(const NumberBound& bound, double value) {
  if (bound.lowest != nullptr && value < bound.range.low) {
    return Named(*bound.lowest) + " allows " + FormatDouble(bound.range.low) + " at least" +
           Reason(*bound.lowest);
  }
  if (bound.highest != nullptr && value > bound.range.high) {
    return Named(*bound.highest) + " allows " + FormatDouble(bound.range.high) + " at most" +
           Reason(*bound.highest);
  }
  return "";
}

}  // namespace latticeworld
