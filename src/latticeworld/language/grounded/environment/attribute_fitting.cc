#include "latticeworld/language/grounded/environment/attribute_fitting.h"

#include <algorithm>
#include <optional>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/season_rules.h"
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

bool IsPossible(const FineWish& wish, const CoarseAttributes& coarse) {
  const EnvironmentClaim& claim = wish.claim;
  if (claim.kind != EnvironmentClaimKind::kVariant ||
      claim.variant_key != VariantKey::kSeasonVariant) {
    return true;
  }
  return std::any_of(claim.values.begin(), claim.values.end(), [&](const std::string& value) {
    return IsAllowed(claim.asset, value, coarse);
  });
}

// The season in which most of the wished variants can be seen, the usual one of equals.
Season SeasonFor(const HeardEnvironment& heard, CoarseAttributes coarse, Season usual) {
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
                      [&](const FineWish& wish) { return IsPossible(wish, coarse); });
    if (possible > most) {
      most = possible;
      best = season;
    }
  }
  return best;
}

void PutVariant(const FineWish& wish, const CoarseAttributes& coarse, FineAttribute* fine,
                std::vector<std::string>* warnings) {
  const EnvironmentClaim& claim = wish.claim;
  const bool material = claim.variant_key == VariantKey::kMaterial;
  std::string& value = material ? fine->material : fine->season_variant;
  if (std::find(claim.values.begin(), claim.values.end(), value) != claim.values.end()) return;
  for (const std::string& wanted : claim.values) {
    if (!material && !IsAllowed(claim.asset, wanted, coarse)) continue;
    value = wanted;
    return;
  }
  warnings->push_back(Quote(claim.words) + ": " + std::string(NameOf(claim.asset)) + " cannot be " +
                      claim.values.front() + " in " + std::string(NameOf(coarse.season)) +
                      "; it is " + value);
}

void PutParameter(const FineWish& wish, FineAttribute* fine) {
  switch (wish.claim.parameter_key) {
    case ParameterKey::kRotationYaw:
      fine->rotation_deg[2] = wish.value;
      break;
    case ParameterKey::kScale:
      fine->scale = wish.value;
      break;
    case ParameterKey::kHeight:
      fine->height_m = wish.value;
      break;
    case ParameterKey::kWind:
      fine->wind_mps = wish.value;
      break;
    case ParameterKey::kSlope:
      fine->slope_deg = wish.value;
      break;
  }
}

}  // namespace

CoarseAttributes FitCoarse(const HeardEnvironment& heard, const SymbolicLayout& layout) {
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
  coarse.season = SeasonFor(heard, coarse, usual);
  return coarse;
}

FineAttributes FitFine(const std::vector<FineWish>& wishes, const CoarseAttributes& coarse,
                       std::vector<std::string>* warnings) {
  FineAttributes fine = DeriveFineAttributes(coarse);
  for (const FineWish& wish : wishes) {
    FineAttribute& one = fine[static_cast<std::size_t>(wish.claim.asset)];
    if (wish.claim.kind == EnvironmentClaimKind::kDensity) one.density = wish.value;
    if (wish.claim.kind == EnvironmentClaimKind::kVariant) {
      PutVariant(wish, coarse, &one, warnings);
    }
    if (wish.claim.kind == EnvironmentClaimKind::kParameter) PutParameter(wish, &one);
  }
  return fine;
}

}  // namespace latticeworld
