// Fine attributes chosen within their bounds: the typical ones, or drawn.

#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/random.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/environment/rules.h"

namespace latticeworld {
namespace {

const ValueBound& Typical(const std::vector<ValueBound>& values) {
  const ValueBound* typical = nullptr;
  for (const ValueBound& value : values) {
    if (value.legal() && (typical == nullptr || value.weight > typical->weight)) typical = &value;
  }
  LW_CHECK(typical != nullptr, "some value is always legal");
  return *typical;
}

const ValueBound& Draw(const std::vector<ValueBound>& values, RandomStream* random) {
  std::vector<double> weights;
  for (const ValueBound& value : values) weights.push_back(value.legal() ? value.weight : 0.0);
  return values[random->Weighted(weights)];
}

// The quantile u of a triangular distribution.
double Triangular(double low, double mode, double high, double u) {
  if (high <= low) return low;
  const double rising = (mode - low) / (high - low);
  if (u < rising) return low + std::sqrt(u * (high - low) * (mode - low));
  return high - std::sqrt((1.0 - u) * (high - low) * (high - mode));
}

double Draw(const NumberBound& bound, RandomStream* random) {
  const double u = random->Uniform();
  const double mode = std::max(bound.draw_low, std::min(bound.draw_high, bound.typical));
  const double value = bound.draw_evenly ? bound.draw_low + u * (bound.draw_high - bound.draw_low)
                                         : Triangular(bound.draw_low, mode, bound.draw_high, u);
  // The value is rounded down to hundredths, which keeps it below an open end.
  return std::max(bound.draw_low, std::floor(value * 100.0) / 100.0);
}

template <typename ChooseValue, typename ChooseNumber>
FineAttributes Choose(const CoarseAttributes& coarse, const Catalogue& catalogue,
                      const ChooseValue& choose_value, const ChooseNumber& choose_number) {
  FineAttributes attributes;
  for (const auto& entry : EnumNames(AssetType{})) {
    const FineBounds bounds = BoundsOf(coarse, entry.value, catalogue);
    FineAttribute& fine = attributes[static_cast<std::size_t>(entry.value)];
    fine.season_variant = choose_value(bounds.season_variants).name;
    fine.material = choose_value(bounds.materials).name;
    for (const auto& parameter : EnumNames(FineParameter{})) {
      const auto& bound = bounds.number(parameter.value);
      if (bound) SetValue(parameter.value, choose_number(*bound), &fine);
    }
  }
  return attributes;
}

}  // namespace

FineAttributes DeriveFineAttributes(const CoarseAttributes& coarse, const Catalogue& catalogue) {
  return Choose(
      coarse, catalogue, [](const std::vector<ValueBound>& values) { return Typical(values); },
      [](const NumberBound& bound) { return bound.typical; });
}

FineAttributes DeriveFineAttributes(const CoarseAttributes& coarse) {
  return DeriveFineAttributes(coarse, *Catalogue::BuiltIn());
}

FineAttributes SampleFineAttributes(const CoarseAttributes& coarse, const Catalogue& catalogue,
                                    RandomStream* random) {
  return Choose(
      coarse, catalogue,
      [&](const std::vector<ValueBound>& values) { return Draw(values, random); },
      [&](const NumberBound& bound) { return Draw(bound, random); });
}

}  // namespace latticeworld
