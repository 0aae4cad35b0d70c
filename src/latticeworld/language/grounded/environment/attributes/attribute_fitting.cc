#include "latticeworld/language/grounded/environment/attributes/attribute_fitting.h"

#include <algorithm>
#include <optional>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/rules.h"
#include "latticeworld/layout/measures.h"

namespace latticeworld {
namespace {

// The kind of land that a layout shows.
TerrainType TerrainTypeOf(const SymbolicLayout& layout) {
  const auto share = [&](char letter) { return ShareIn(layout, letter, Region::kAnywhere); };
  if (layout.vocabulary == Vocabulary::kWild) {
    if (share('S') > 0.05 || share('R') > 0.4) return TerrainType::kMountain;
    if (share('R') > 0.15) return TerrainType::kHills;
  } else {
    if (share('B') > 0.01) return TerrainType::kSuburb;
    if (share('D') > 0.5) return TerrainType::kDesert;
  }
  if (share('W') > 0.35) return TerrainType::kCoast;
  if (share('F') > 0.35) return TerrainType::kForest;
  if (layout.vocabulary == Vocabulary::kSuburb && share('A') > 0.3) return TerrainType::kPlain;
  return TerrainType::kGrassland;
}

// What was heard, else the usual value, else the first that nobody ruled out.
template <typename Enum>
Enum Choose(const HeardCoarse& heard, std::initializer_list<Enum> usual) {
  if (const auto value = FromName<Enum>(heard.value)) return *value;
  for (const Enum value : usual) {
    if (std::find(heard.ruled_out.begin(), heard.ruled_out.end(), NameOf(value)) ==
        heard.ruled_out.end()) {
      return value;
    }
  }
  return *usual.begin();
}

const std::vector<ValueBound>& ValuesOf(const EnvironmentClaim& claim, const FineBounds& bounds) {
  return claim.variant_key == VariantKey::kMaterial ? bounds.materials : bounds.season_variants;
}

FineParameter ParameterOf(const EnvironmentClaim& claim) {
  if (claim.kind == EnvironmentClaimKind::kDensity) return FineParameter::kDensity;
  switch (claim.parameter_key) {
    case ParameterKey::kRotationYaw:
      return FineParameter::kYaw;
    case ParameterKey::kScale:
      return FineParameter::kScale;
    case ParameterKey::kHeight:
      return FineParameter::kHeight;
    case ParameterKey::kWind:
      return FineParameter::kWind;
    case ParameterKey::kSlope:
      return FineParameter::kSlope;
  }
  return FineParameter::kDensity;
}

// Whether some value that the wish asks for is legal under the coarse attributes.
bool IsPossible(const FineWish& wish, const CoarseAttributes& coarse, const Catalogue& catalogue) {
  const EnvironmentClaim& claim = wish.claim;
  const FineBounds bounds = BoundsOf(coarse, claim.asset, catalogue);
  if (claim.kind == EnvironmentClaimKind::kVariant) {
    return std::any_of(claim.values.begin(), claim.values.end(), [&](const std::string& value) {
      return BreachOf(ValuesOf(claim, bounds), value).empty();
    });
  }
  const std::optional<NumberBound>& bound = bounds.number(ParameterOf(claim));
  return !bound || claim.least > claim.most ||  // a yaw through north
         (claim.least <= bound->range.high && claim.most >= bound->range.low);
}

// The season in which most of the wishes are legal, the usual one of equals.
Season SeasonFor(const HeardEnvironment& heard, CoarseAttributes coarse, Season usual,
                 const Catalogue& catalogue) {
  const HeardCoarse& said = heard.coarse_of(CoarseKey::kSeason);
  if (!said.value.empty() && !said.hint) return usual;
  Season best = usual;
  std::ptrdiff_t most = -1;
  for (const Season season :
       {usual, Season::kSummer, Season::kAutumn, Season::kSpring, Season::kWinter}) {
    if (std::find(said.ruled_out.begin(), said.ruled_out.end(), NameOf(season)) !=
        said.ruled_out.end()) {
      continue;
    }
    coarse.season = season;
    const std::ptrdiff_t possible =
        std::count_if(heard.fine.begin(), heard.fine.end(),
                      [&](const FineWish& wish) { return IsPossible(wish, coarse, catalogue); });
    if (possible > most) {
      most = possible;
      best = season;
    }
  }
  return best;
}

// "a calm breeze": desert wind cannot be 2: the rule ... allows ...; it is 8
std::string Refusal(const EnvironmentClaim& claim, std::string_view property,
                    std::string_view wanted, std::string_view breach, std::string_view is) {
  std::string text = Quote(claim.words) + ": " + std::string(NameOf(claim.asset)) + " ";
  text.append(property).append(" cannot be ").append(wanted).append(": ").append(breach);
  return text.append("; it is ").append(is);
}

void PutVariant(const FineWish& wish, const FineBounds& bounds, FineAttribute* fine,
                std::vector<std::string>* warnings) {
  const EnvironmentClaim& claim = wish.claim;
  const bool material = claim.variant_key == VariantKey::kMaterial;
  std::string& value = material ? fine->material : fine->season_variant;
  if (std::find(claim.values.begin(), claim.values.end(), value) != claim.values.end()) return;
  for (const std::string& wanted : claim.values) {
    if (!BreachOf(ValuesOf(claim, bounds), wanted).empty()) continue;
    value = wanted;
    return;
  }
  warnings->push_back(Refusal(claim, NameOf(claim.variant_key), claim.values.front(),
                              BreachOf(ValuesOf(claim, bounds), claim.values.front()), value));
}

// The wish, or the nearest value that the rules allow.
void PutNumber(const FineWish& wish, const FineBounds& bounds, FineAttribute* fine,
               std::vector<std::string>* warnings) {
  const EnvironmentClaim& claim = wish.claim;
  const FineParameter parameter = ParameterOf(claim);
  const std::optional<NumberBound>& bound = bounds.number(parameter);
  const std::string breach = bound ? BreachOf(*bound, wish.value) : std::string();
  if (breach.empty()) return SetValue(parameter, wish.value, fine);
  const double value = std::clamp(wish.value, bound->range.low, bound->range.high);
  SetValue(parameter, value, fine);
  // "dense" is many densities: only one that is none of them refuses the words.
  if (value >= claim.least && value <= claim.most) return;
  warnings->push_back(
      Refusal(claim, NameOf(parameter), FormatDouble(wish.value), breach, FormatDouble(value)));
}

}  // namespace

CoarseAttributes FitCoarse(const HeardEnvironment& heard, const SymbolicLayout& layout,
                           const Catalogue& catalogue) {
  CoarseAttributes coarse;
  coarse.terrain_type =
      Choose(heard.coarse_of(CoarseKey::kTerrainType),
             {TerrainTypeOf(layout), TerrainType::kGrassland, TerrainType::kPlain});
  coarse.artistic_style =
      Choose(heard.coarse_of(CoarseKey::kArtisticStyle),
             {ArtisticStyle::kRealistic, ArtisticStyle::kCartoon, ArtisticStyle::kCyberpunk});
  coarse.weather = Choose(heard.coarse_of(CoarseKey::kWeather),
                          {Weather::kSunny, Weather::kCloudy, Weather::kFog});
  coarse.time_of_day =
      Choose(heard.coarse_of(CoarseKey::kTimeOfDay), {TimeOfDay::kDay, TimeOfDay::kNight});
  // Snow falls in winter when nobody names the season.
  const Season usual = Choose(heard.coarse_of(CoarseKey::kSeason),
                              {coarse.weather == Weather::kSnow ? Season::kWinter : Season::kSummer,
                               Season::kSummer, Season::kAutumn, Season::kSpring});
  coarse.season = SeasonFor(heard, coarse, usual, catalogue);
  return coarse;
}

FineAttributes FitFine(const std::vector<FineWish>& wishes, const CoarseAttributes& coarse,
                       const Catalogue& catalogue, std::vector<std::string>* warnings) {
  FineAttributes attributes = DeriveFineAttributes(coarse, catalogue);
  for (const FineWish& wish : wishes) {
    const FineBounds bounds = BoundsOf(coarse, wish.claim.asset, catalogue);
    FineAttribute* fine = &attributes[static_cast<std::size_t>(wish.claim.asset)];
    if (wish.claim.kind == EnvironmentClaimKind::kVariant) {
      PutVariant(wish, bounds, fine, warnings);
    } else {
      PutNumber(wish, bounds, fine, warnings);
    }
  }
  return attributes;
}

}  // namespace latticeworld
