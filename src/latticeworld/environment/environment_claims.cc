#include "latticeworld/environment/environment_claims.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <string_view>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/ranges.h"

namespace latticeworld {
namespace {

template <typename Enum>
std::vector<std::string_view> NamesOf() {
  std::vector<std::string_view> names;
  for (const auto& entry : EnumNames(Enum{})) names.push_back(entry.name);
  return names;
}

std::vector<std::string_view> LegalValues(CoarseKey key) {
  switch (key) {
    case CoarseKey::kTerrainType:
      return NamesOf<TerrainType>();
    case CoarseKey::kSeason:
      return NamesOf<Season>();
    case CoarseKey::kArtisticStyle:
      return NamesOf<ArtisticStyle>();
    case CoarseKey::kWeather:
      return NamesOf<Weather>();
    case CoarseKey::kTimeOfDay:
      return NamesOf<TimeOfDay>();
  }
  return {};
}

std::string_view ValueOf(CoarseKey key, const CoarseAttributes& coarse) {
  switch (key) {
    case CoarseKey::kTerrainType:
      return NameOf(coarse.terrain_type);
    case CoarseKey::kSeason:
      return NameOf(coarse.season);
    case CoarseKey::kArtisticStyle:
      return NameOf(coarse.artistic_style);
    case CoarseKey::kWeather:
      return NameOf(coarse.weather);
    case CoarseKey::kTimeOfDay:
      return NameOf(coarse.time_of_day);
  }
  return "?";
}

bool HasParameter(AssetType asset, ParameterKey key) {
  const AssetTypeValues& values = ValuesOf(asset);
  switch (key) {
    case ParameterKey::kRotationYaw:
      return values.has_rotation;
    case ParameterKey::kScale:
      return values.has_scale;
    case ParameterKey::kHeight:
      return values.has_height;
    case ParameterKey::kWind:
      return values.has_wind;
    case ParameterKey::kSlope:
      return values.has_slope;
  }
  return false;
}

double ValueOf(ParameterKey key, const FineAttribute& fine) {
  switch (key) {
    case ParameterKey::kRotationYaw:
      return fine.rotation_deg[2];
    case ParameterKey::kScale:
      return fine.scale;
    case ParameterKey::kHeight:
      return fine.height_m;
    case ParameterKey::kWind:
      return fine.wind_mps;
    case ParameterKey::kSlope:
      return fine.slope_deg;
  }
  return 0.0;
}

const Range& LegalRange(const EnvironmentClaim& claim) {
  return claim.kind == EnvironmentClaimKind::kDensity ? kDensityRange
                                                      : RangeOf(claim.parameter_key);
}

template <typename Enum>
std::string NamesJoined(const std::vector<Enum>& values) {
  std::vector<std::string> names;
  for (const Enum value : values) names.emplace_back(NameOf(value));
  return Join(names, " or ");
}

bool IsYaw(const EnvironmentClaim& claim) {
  return claim.kind == EnvironmentClaimKind::kParameter &&
         claim.parameter_key == ParameterKey::kRotationYaw;
}

// ---------------------------------------------------------------------------- Validation

class ClaimValidator {
 public:
  explicit ClaimValidator(const EnvironmentClaim& claim) : claim_(claim) {}

  std::vector<Violation> Run() {
    switch (claim_.kind) {
      case EnvironmentClaimKind::kCoarse:
        CheckValues(LegalValues(claim_.coarse_key));
        break;
      case EnvironmentClaimKind::kVariant: {
        const AssetTypeValues& values = ValuesOf(claim_.asset);
        CheckValues(claim_.variant_key == VariantKey::kMaterial ? values.materials
                                                                : values.season_variants);
        break;
      }
      case EnvironmentClaimKind::kParameter:
        if (!HasParameter(claim_.asset, claim_.parameter_key)) {
          Add("unknown_value", "/key",
              std::string(NameOf(claim_.asset)) + " has no " +
                  std::string(NameOf(claim_.parameter_key)),
              std::string(NameOf(claim_.parameter_key)));
          break;
        }
        CheckBounds();
        break;
      case EnvironmentClaimKind::kDensity:
        CheckBounds();
        break;
      case EnvironmentClaimKind::kAgents:
        if (claim_.categories.empty()) Add("missing_key", "/category", "is missing", "");
        CheckQuantities(1);
        break;
      case EnvironmentClaimKind::kTotalAgents:
        CheckQuantities(0);
        break;
      case EnvironmentClaimKind::kNoAgents:
        break;
    }
    return std::move(violations_);
  }

 private:
  void Add(std::string code, std::string pointer, std::string message, std::string given) {
    violations_.push_back(
        {std::move(code), std::move(pointer), std::move(message), std::move(given)});
  }

  void CheckValues(const std::vector<std::string_view>& legal) {
    if (claim_.values.empty()) {
      Add("missing_value", "/values", "must name one value at least", "[]");
    }
    const std::vector<std::string> names(legal.begin(), legal.end());
    for (std::size_t i = 0; i < claim_.values.size(); ++i) {
      if (std::find(legal.begin(), legal.end(), claim_.values[i]) != legal.end()) continue;
      Add("unknown_value", "/values/" + std::to_string(i),
          Quote(claim_.values[i]) + " is not one of " + Join(names, ", "), Quote(claim_.values[i]));
    }
  }

  void CheckBounds() {
    const Range closed{LegalRange(claim_).low, LegalRange(claim_).high};
    const std::size_t before = violations_.size();
    CheckRange("/least", claim_.least, closed, "", &violations_);
    CheckRange("/most", claim_.most, closed, "", &violations_);
    if (violations_.size() > before || IsYaw(claim_) || claim_.least <= claim_.most) return;
    Add("out_of_range", "/most",
        "must not be below least, " + FormatDouble(claim_.least) + ", but is " +
            FormatDouble(claim_.most),
        FormatDouble(claim_.most));
  }

  void CheckQuantities(int lowest) {
    if (claim_.least_quantity < lowest || claim_.least_quantity > kMaxAgents) {
      Add("out_of_range", "/least_quantity",
          "must be from " + std::to_string(lowest) + " to " + std::to_string(kMaxAgents) +
              ", not " + std::to_string(claim_.least_quantity),
          std::to_string(claim_.least_quantity));
    } else if (claim_.most_quantity < claim_.least_quantity) {
      Add("out_of_range", "/most_quantity",
          "must not be below least_quantity, " + std::to_string(claim_.least_quantity) +
              ", but is " + std::to_string(claim_.most_quantity),
          std::to_string(claim_.most_quantity));
    }
  }

  const EnvironmentClaim& claim_;
  std::vector<Violation> violations_;
};

// ---------------------------------------------------------------------------- Measures

EnvironmentClaimMeasure MeasureOf(double distance, std::string explanation) {
  return {distance == 0.0, std::min(1.0, distance), std::move(explanation)};
}

EnvironmentClaimMeasure MeasureName(std::string_view what, std::string_view value,
                                    const std::vector<std::string>& values) {
  const bool holds = std::find(values.begin(), values.end(), value) != values.end();
  return MeasureOf(holds ? 0.0 : 1.0, std::string(what) + " is " + std::string(value) + "; " +
                                          Join(values, " or ") + " is asked");
}

// How far a value is outside of [least, most], in the unit of the value.
double Gap(double value, double least, double most) {
  return std::max({0.0, least - value, value - most});
}

double YawGap(double yaw_deg, double least_deg, double most_deg) {
  const bool inside = least_deg <= most_deg ? yaw_deg >= least_deg && yaw_deg <= most_deg
                                            : yaw_deg >= least_deg || yaw_deg <= most_deg;
  if (inside) return 0.0;
  const auto apart = [&](double bound_deg) {
    const double difference = std::abs(yaw_deg - bound_deg);
    return std::min(difference, 360.0 - difference);
  };
  return std::min(apart(least_deg), apart(most_deg));
}

EnvironmentClaimMeasure MeasureNumber(const EnvironmentClaim& claim, const FineAttribute& fine) {
  const bool density = claim.kind == EnvironmentClaimKind::kDensity;
  const double value = density ? fine.density : ValueOf(claim.parameter_key, fine);
  const Range& legal = LegalRange(claim);
  const double gap = IsYaw(claim) ? YawGap(value, claim.least, claim.most) / 180.0
                                  : Gap(value, claim.least, claim.most) / (legal.high - legal.low);
  return MeasureOf(gap, std::string(NameOf(claim.asset)) + " has " +
                            (density ? "density" : std::string(NameOf(claim.parameter_key))) + " " +
                            FormatDouble(value) + "; from " + FormatDouble(claim.least) + " to " +
                            FormatDouble(claim.most) + " is asked");
}

template <typename Value>
bool IsAmong(Value value, const std::vector<Value>& values) {
  return values.empty() || std::find(values.begin(), values.end(), value) != values.end();
}

std::string QuantityRange(const EnvironmentClaim& claim) {
  if (claim.least_quantity == claim.most_quantity) return std::to_string(claim.least_quantity);
  if (claim.most_quantity >= kMaxAgents) {
    return "at least " + std::to_string(claim.least_quantity);
  }
  return std::to_string(claim.least_quantity) + " to " + std::to_string(claim.most_quantity);
}

double QuantityGap(int quantity, const EnvironmentClaim& claim) {
  if (quantity < claim.least_quantity) {
    return static_cast<double>(claim.least_quantity - quantity) / claim.least_quantity;
  }
  if (quantity > claim.most_quantity) {
    return static_cast<double>(quantity - claim.most_quantity) / quantity;
  }
  return 0.0;
}

struct Sum {
  int quantity = 0;
  double gap = 1.0;
};

// The sum of some of the groups that comes nearest to the range, and all there are if none does
// better than none.
template <typename Matches>
Sum NearestSum(const EnvironmentClaim& claim, const EnvironmentConfig& config,
               const Matches& matches) {
  std::bitset<kMaxAgents + 1> reachable;
  reachable.set(0);
  for (const AgentGroup& group : config.agents) {
    if (!matches(group) || group.quantity < 0 || group.quantity > kMaxAgents) continue;
    reachable |= reachable << static_cast<std::size_t>(group.quantity);
  }
  Sum best;
  for (int quantity = 1; quantity <= kMaxAgents; ++quantity) {
    if (!reachable[static_cast<std::size_t>(quantity)]) continue;
    const double gap = QuantityGap(quantity, claim);
    if (gap < best.gap) best = {quantity, gap};
  }
  return best;
}

EnvironmentClaimMeasure MeasureAgents(const EnvironmentClaim& claim,
                                      const EnvironmentConfig& config) {
  // What it costs to overlook the state and the place; together they leave 0.2 for the quantity.
  constexpr double kWrongState = 0.4;
  constexpr double kWrongPlace = 0.4;
  double distance = 1.0;
  int matching = 0;
  for (const bool any_state : {false, true}) {
    for (const bool any_place : {false, true}) {
      const Sum sum = NearestSum(claim, config, [&](const AgentGroup& group) {
        return IsAmong(group.category, claim.categories) &&
               (any_state || IsAmong(group.state, claim.states)) &&
               (any_place || IsAmong(group.position, claim.positions));
      });
      if (!any_state && !any_place) matching = sum.quantity;
      if (sum.quantity == 0) continue;
      const double penalty = (any_state ? kWrongState : 0.0) + (any_place ? kWrongPlace : 0.0);
      distance = std::min(distance, penalty + (1.0 - penalty) * sum.gap);
    }
  }
  std::string asked = NamesJoined(claim.categories);
  if (!claim.states.empty()) asked += " " + NamesJoined(claim.states);
  if (!claim.positions.empty()) asked += " at " + NamesJoined(claim.positions);
  return MeasureOf(distance,
                   std::to_string(matching) + " " + asked + "; " + QuantityRange(claim) +
                       (claim.least_quantity == 1 && claim.most_quantity == 1 ? " is" : " are") +
                       " asked");
}

int CountAgents(const EnvironmentClaim& claim, const EnvironmentConfig& config) {
  int total = 0;
  for (const AgentGroup& group : config.agents) {
    if (IsAmong(group.category, claim.categories)) total += group.quantity;
  }
  return total;
}

}  // namespace

const Range& RangeOf(ParameterKey key) {
  switch (key) {
    case ParameterKey::kRotationYaw:
      return kRotationRange;
    case ParameterKey::kScale:
      return kScaleRange;
    case ParameterKey::kHeight:
      return kHeightRange;
    case ParameterKey::kWind:
      return kWindRange;
    case ParameterKey::kSlope:
      return kSlopeRange;
  }
  return kDensityRange;
}

std::vector<Violation> Validate(const EnvironmentClaim& claim) {
  return ClaimValidator(claim).Run();
}

EnvironmentClaimMeasure Measure(const EnvironmentClaim& claim, const EnvironmentConfig& config) {
  switch (claim.kind) {
    case EnvironmentClaimKind::kCoarse:
      return MeasureName(NameOf(claim.coarse_key), ValueOf(claim.coarse_key, config.coarse),
                         claim.values);
    case EnvironmentClaimKind::kVariant: {
      const FineAttribute& fine = config.fine_of(claim.asset);
      return MeasureName(
          std::string(NameOf(claim.variant_key)) + " of " + std::string(NameOf(claim.asset)),
          claim.variant_key == VariantKey::kMaterial ? fine.material : fine.season_variant,
          claim.values);
    }
    case EnvironmentClaimKind::kDensity:
    case EnvironmentClaimKind::kParameter:
      return MeasureNumber(claim, config.fine_of(claim.asset));
    case EnvironmentClaimKind::kAgents:
      return MeasureAgents(claim, config);
    case EnvironmentClaimKind::kNoAgents: {
      const int count = CountAgents(claim, config);
      return MeasureOf(count / (count + 1.0),
                       "there are " + std::to_string(count) + " " +
                           (claim.categories.empty() ? "agents" : NamesJoined(claim.categories)) +
                           "; none is asked");
    }
    case EnvironmentClaimKind::kTotalAgents: {
      const int total = CountAgents(claim, config);
      return MeasureOf(
          QuantityGap(total, claim),
          "there are " + std::to_string(total) + " agents; " + QuantityRange(claim) + " are asked");
    }
  }
  LW_CHECK(false, "every kind of claim has a measure");
  return {};
}

}  // namespace latticeworld
