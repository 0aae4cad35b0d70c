#include "latticeworld/language/grounded/environment/claims_of_heard.h"

#include <algorithm>
#include <string>

#include "latticeworld/language/grounded/environment/feature_places.h"

namespace latticeworld {
namespace {

std::vector<std::string> LegalValues(CoarseKey key) {
  std::vector<std::string> names;
  const auto add = [&](const auto& entries) {
    for (const auto& entry : entries) names.emplace_back(entry.name);
  };
  switch (key) {
    case CoarseKey::kTerrainType:
      add(EnumNames(TerrainType{}));
      break;
    case CoarseKey::kSeason:
      add(EnumNames(Season{}));
      break;
    case CoarseKey::kArtisticStyle:
      add(EnumNames(ArtisticStyle{}));
      break;
    case CoarseKey::kWeather:
      add(EnumNames(Weather{}));
      break;
    case CoarseKey::kTimeOfDay:
      add(EnumNames(TimeOfDay{}));
      break;
  }
  return names;
}

void AddCoarse(CoarseKey key, const HeardCoarse& heard, std::vector<EnvironmentClaim>* claims) {
  EnvironmentClaim claim;
  claim.kind = EnvironmentClaimKind::kCoarse;
  claim.coarse_key = key;
  if (!heard.value.empty()) {
    claim.values = {heard.value};
    claim.values.insert(claim.values.end(), heard.also.begin(), heard.also.end());
    claim.words = heard.words;
    claims->push_back(std::move(claim));
  } else if (!heard.ruled_out.empty()) {
    for (const std::string& value : LegalValues(key)) {
      if (std::find(heard.ruled_out.begin(), heard.ruled_out.end(), value) ==
          heard.ruled_out.end()) {
        claim.values.push_back(value);
      }
    }
    claim.words = heard.ruled_out_words;
    if (!claim.values.empty()) claims->push_back(std::move(claim));
  }
}

std::vector<Region> RegionsOf(const AgentWish& wish, const SymbolicLayout* layout) {
  std::vector<Region> regions;
  for (const Place& place : wish.places) {
    if (place.regions.empty() || place.main == Region::kAnywhere) return {};
    for (const Region region : place.regions) {
      if (std::find(regions.begin(), regions.end(), region) == regions.end()) {
        regions.push_back(region);
      }
    }
  }
  if (!wish.feature.has_value()) return regions;
  if (layout == nullptr) return wish.feature->on.has_value() ? std::vector<Region>{} : regions;
  regions = RegionsAt(*wish.feature, wish.places, *layout);
  for (const FeaturePlace& feature : wish.more_land) {
    for (const Region region : RegionsAt(feature, {}, *layout)) {
      if (std::find(regions.begin(), regions.end(), region) == regions.end()) {
        regions.push_back(region);
      }
    }
  }
  return regions;
}

void AddAgents(const AgentWish& wish, const SymbolicLayout* layout,
               std::vector<EnvironmentClaim>* claims) {
  EnvironmentClaim claim;
  claim.kind = EnvironmentClaimKind::kAgents;
  claim.categories = wish.categories;
  // Quantities beyond the limits are claimed as the limit.
  const std::size_t lands = wish.feature.has_value() ? 1 + wish.more_land.size() : 0;
  const int times =
      wish.each ? std::max<int>(1, static_cast<int>(std::max(wish.places.size(), lands))) : 1;
  const auto limited = [&](int quantity) {
    return static_cast<int>(std::clamp<long long>(1LL * quantity * times, 1, kMaxAgents));
  };
  claim.least_quantity = limited(wish.least);
  claim.most_quantity = std::max(claim.least_quantity, limited(wish.most));
  if (wish.state.has_value()) claim.states = {*wish.state};
  claim.positions = RegionsOf(wish, layout);
  claim.words = wish.words;
  claims->push_back(std::move(claim));
}

}  // namespace

std::vector<EnvironmentClaim> ClaimsOf(const HeardEnvironment& heard,
                                       const SymbolicLayout* layout) {
  std::vector<EnvironmentClaim> claims;
  for (const auto& entry : EnumNames(CoarseKey{})) {
    AddCoarse(entry.value, heard.coarse_of(entry.value), &claims);
  }
  for (const FineWish& wish : heard.fine) claims.push_back(wish.claim);
  for (const AgentWish& wish : heard.agents) AddAgents(wish, layout, &claims);
  claims.insert(claims.end(), heard.absences.begin(), heard.absences.end());
  return claims;
}

}  // namespace latticeworld
