#include "latticeworld/language/reading/claim_coverage.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "latticeworld/language/reading/sentence_places.h"
#include "latticeworld/language/reading/text_units.h"

namespace latticeworld {
namespace {

class KeyTaker {
 public:
  std::set<std::string> Take() && { return std::move(keys_); }

  void AddLand(char letter) {
    if (letter != '\0') keys_.insert("land " + std::string(1, letter));
  }
  void AddPlaces(const std::vector<std::string>& names) {
    keys_.merge(latticeworld::KeysOf(names, SentenceKind::kLayout, Vocabulary::kSuburb));
  }
  void AddZone(const Zone& zone) {
    if (!zone.is_anywhere()) AddPlaces({zone.name, PlaceName(zone)});
  }
  void AddHeading(Claim::Heading heading) {
    if (heading.east != 0 || heading.south != 0) AddPlaces({HeadingName(heading)});
  }
  // Both bounds, and what lies between where that is what a word like "several" leaves open.
  void AddNumbers(double least, double most) {
    constexpr double kWidest = 12.0;
    if (!std::isfinite(least)) least = 1.0;
    if (!std::isfinite(most)) most = least;
    const double step = most - least <= kWidest ? 1.0 : most - least;
    for (double number = least; number <= most; number += step) {
      keys_.insert("number " + std::to_string(std::lround(number)));
    }
  }
  void Add(std::string key) { keys_.insert(std::move(key)); }

 private:
  std::set<std::string> keys_;
};

// Whether words say "in the middle of" something, which is what a claim asks for that is within it.
bool SayMiddleOf(std::string_view words) {
  for (const std::string_view middle : {"middle of ", "center of ", "centre of ", "heart of "}) {
    if (words.find(middle) != std::string_view::npos) return true;
  }
  return false;
}

std::set<std::string> KeysOf(const std::vector<Claim>& claims) {
  KeyTaker taker;
  // "Two roads, one from ..., one from ...": of how many places or courses of a class there are.
  std::map<std::pair<ClaimKind, char>, std::set<std::string>> several;
  for (const Claim& claim : claims) {
    for (const char letter : {claim.subject, claim.object, claim.second_object}) {
      taker.AddLand(letter);
    }
    for (const char letter : claim.sequence) taker.AddLand(letter);
    for (const Zone& zone : {claim.zone, claim.object_zone, claim.from, claim.to}) {
      taker.AddZone(zone);
    }
    taker.AddHeading(claim.heading);
    if (claim.kind == ClaimKind::kOrder) {
      taker.AddHeading({-claim.heading.east, -claim.heading.south});
    }
    if (claim.kind == ClaimKind::kWithin && SayMiddleOf(claim.words)) {
      taker.AddPlaces({"center"});
    }
    if (claim.kind == ClaimKind::kCount) taker.AddNumbers(claim.least, claim.most);
    if (claim.kind == ClaimKind::kPresent || claim.kind == ClaimKind::kCourse) {
      several[{claim.kind, claim.subject}].insert(claim.zone.name + claim.from.name +
                                                  claim.to.name);
    }
  }
  for (const auto& [of, places] : several) {
    taker.AddNumbers(static_cast<double>(places.size()), static_cast<double>(places.size()));
  }
  return std::move(taker).Take();
}

std::set<std::string> KeysOf(const std::vector<EnvironmentClaim>& claims) {
  KeyTaker taker;
  // "Six dogs, two by ..., four in ...", "two flocks": how many there are in all, and in how many
  // groups.
  std::map<std::vector<AgentCategory>, int> all, groups;
  for (const EnvironmentClaim& claim : claims) {
    for (const AgentCategory category : claim.categories) {
      taker.Add("who " + std::string(NameOf(category)));
    }
    for (const Region position : claim.positions) {
      taker.AddPlaces({std::string(NameOf(position))});
    }
    const bool counts = claim.kind == EnvironmentClaimKind::kAgents ||
                        claim.kind == EnvironmentClaimKind::kTotalAgents;
    if (counts) taker.AddNumbers(claim.least_quantity, claim.most_quantity);
    if (claim.kind == EnvironmentClaimKind::kAgents &&
        claim.least_quantity == claim.most_quantity) {
      all[claim.categories] += claim.most_quantity;
      ++groups[claim.categories];
    }
  }
  for (const auto& of : {all, groups}) {
    for (const auto& [categories, number] : of) taker.AddNumbers(number, number);
  }
  return std::move(taker).Take();
}

}  // namespace

TextCoverage CoverageOf(std::string_view text, const std::vector<std::string>& sentences,
                        const std::vector<Claim>& claims, Vocabulary vocabulary) {
  std::set<std::string> keys = latticeworld::KeysOf(sentences, SentenceKind::kLayout, vocabulary);
  keys.merge(KeysOf(claims));
  return CoverageOfKeys(text, std::move(keys), SentenceKind::kLayout, vocabulary);
}

TextCoverage CoverageOf(std::string_view text, const std::vector<std::string>& sentences,
                        const std::vector<EnvironmentClaim>& claims, Vocabulary vocabulary) {
  std::set<std::string> keys =
      latticeworld::KeysOf(sentences, SentenceKind::kEnvironment, vocabulary);
  keys.merge(KeysOf(claims));
  return CoverageOfKeys(text, std::move(keys), SentenceKind::kEnvironment, vocabulary);
}

}  // namespace latticeworld
