#include <algorithm>
#include <cstdio>
#include <map>
#include <string_view>
#include <utility>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/sentences_of_claims.h"
#include "latticeworld/language/reading/things/sentence_assets.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/language/sentences/sentence_writer.h"

namespace latticeworld {
namespace {

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

// The range in words, open towards a bound of what is legal.
std::string RangeInWords(double least, double most, const Range& legal) {
  if (least == most) return Number(least);
  if (most >= legal.high) return "at least " + Number(least);
  if (least <= legal.low) return "at most " + Number(most);
  return Number(least) + " to " + Number(most);
}

std::string CountInWords(int least, int most) {
  if (least == most) return std::to_string(least);
  if (most >= kMaxAgents) return "at least " + std::to_string(least);
  return std::to_string(least) + " to " + std::to_string(most);
}

std::string AnyOf(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : " or ") + value;
  return text;
}

std::string AgentsInWords(const std::vector<AgentCategory>& categories, bool one) {
  std::vector<std::string> names;
  if (categories.empty()) names.emplace_back("agent");
  for (const AgentCategory category : categories) names.emplace_back(NameOf(category));
  if (!one) {
    for (std::string& name : names) name = PluralNoun(name);
  }
  return AnyOf(names);
}

std::string WriteOne(std::string_view form, const std::vector<Filling>& fillings) {
  return WriteSentence(SentenceKind::kEnvironment, form, fillings);
}

std::string SayCoarse(const EnvironmentClaim& claim) {
  switch (claim.coarse_key) {
    case CoarseKey::kTerrainType:
      return WriteOne("terrain", {{"terrains", AnyOf(claim.values)}});
    case CoarseKey::kSeason:
      return WriteOne("season", {{"seasons", AnyOf(claim.values)}});
    case CoarseKey::kArtisticStyle:
      return WriteOne("style", {{"styles", AnyOf(claim.values)}});
    case CoarseKey::kWeather:
      return WriteOne("weather", {{"weathers", AnyOf(claim.values)}});
    case CoarseKey::kTimeOfDay:
      return WriteOne("time", {{"times", AnyOf(claim.values)}});
  }
  return "";
}

std::string SayDensity(const EnvironmentClaim& claim) {
  const std::string amount =
      claim.most <= 0.0
          ? "none"
          : RangeInWords(100.0 * claim.least, 100.0 * claim.most, {0.0, 100.0}) + " %";
  return WriteOne("density", {{"asset", std::string(AssetWord(claim.asset))}, {"amount", amount}});
}

std::string SayParameter(const EnvironmentClaim& claim) {
  const std::string range = RangeInWords(claim.least, claim.most, RangeOf(claim.parameter_key));
  switch (claim.parameter_key) {
    case ParameterKey::kRotationYaw:
      return WriteOne("turned", {{"range", range}});
    case ParameterKey::kScale:
      return WriteOne("scale", {{"range", range}});
    case ParameterKey::kHeight:
      return WriteOne("level", {{"range", range}});
    case ParameterKey::kWind:
      return WriteOne("wind", {{"range", range}});
    case ParameterKey::kSlope:
      return WriteOne("pitch", {{"range", range}});
  }
  return "";
}

// The place whose agents may be in these regions; empty: no place of the small language is that.
std::string PlaceOfRegions(std::vector<Region> regions) {
  static const std::map<std::vector<Region>, std::string> places = [] {
    std::map<std::vector<Region>, std::string> all;
    for (const std::string_view list : {"side", "exact"}) {
      for (const std::string& name : SentenceWords(list)) {
        const auto heard =
            EnvironmentOfSentences({"1 agent in the " + name}, *Catalogue::BuiltIn());
        std::vector<Region> held = ClaimsOf(heard, nullptr).front().positions;
        std::sort(held.begin(), held.end());
        all.emplace(std::move(held), "the " + name);
      }
    }
    return all;
  }();
  std::sort(regions.begin(), regions.end());
  const auto found = places.find(regions);
  return found == places.end() ? std::string() : found->second;
}

std::string SayAgents(const EnvironmentClaim& claim) {
  std::vector<Filling> fillings = {
      {"count", CountInWords(claim.least_quantity, claim.most_quantity)},
      {"whom", AgentsInWords(claim.categories, claim.most_quantity == 1)}};
  if (!claim.states.empty()) {
    std::vector<std::string> states;
    for (const AgentState state : claim.states) states.emplace_back(NameOf(state));
    fillings.emplace_back("states", AnyOf(states));
  }
  const std::string place = PlaceOfRegions(claim.positions);
  if (!place.empty()) fillings.emplace_back("place", place);
  return WriteOne(place.empty() ? "group" : "group_zone", fillings);
}

std::string Say(const EnvironmentClaim& claim) {
  switch (claim.kind) {
    case EnvironmentClaimKind::kCoarse:
      return SayCoarse(claim);
    case EnvironmentClaimKind::kDensity:
      return SayDensity(claim);
    case EnvironmentClaimKind::kVariant:
      return WriteOne("variant", {{"asset", std::string(AssetWord(claim.asset))},
                                  {"values", AnyOf(claim.values)}});
    case EnvironmentClaimKind::kParameter:
      return SayParameter(claim);
    case EnvironmentClaimKind::kAgents:
      return SayAgents(claim);
    case EnvironmentClaimKind::kNoAgents:
      return WriteOne("nobody", {{"whom", AgentsInWords(claim.categories, false)}});
    case EnvironmentClaimKind::kTotalAgents:
      return WriteOne("total", {{"count", CountInWords(claim.least_quantity, claim.most_quantity)},
                                {"whom", AgentsInWords({}, claim.most_quantity == 1)}});
  }
  return "";
}

}  // namespace

std::vector<std::string> SentencesOf(const EnvironmentClaim& claim) {
  std::string sentence = Say(claim);
  if (!ReadSentence(sentence, SentenceKind::kEnvironment).has_value()) return {};
  return {std::move(sentence)};
}

std::vector<std::string> SentencesOf(const std::vector<EnvironmentClaim>& claims) {
  std::vector<std::string> all;
  for (const EnvironmentClaim& claim : claims) {
    for (std::string& sentence : SentencesOf(claim)) {
      if (std::find(all.begin(), all.end(), sentence) == all.end()) {
        all.push_back(std::move(sentence));
      }
    }
  }
  return all;
}

}  // namespace latticeworld
