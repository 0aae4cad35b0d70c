#include "latticeworld/language/reading/land_completion.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/reading/reading_of_sentences.h"
#include "latticeworld/language/reading/sentences_of_claims.h"
#include "latticeworld/language/reading/things/beside_things.h"
#include "latticeworld/language/reading/things/thing_words.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/thing_kinds.h"

namespace latticeworld {
namespace {

// What one reading's claims speak of.
class Named {
 public:
  explicit Named(const std::vector<Claim>& claims) {
    for (const Claim& claim : claims) {
      kinds_.insert(claim.kind);
      of_subject_.insert({claim.kind, claim.subject});
      letters_.insert({claim.subject, claim.object, claim.second_object});
      letters_.insert(claim.sequence.begin(), claim.sequence.end());
    }
  }

  bool Has(ClaimKind kind) const { return kinds_.count(kind) > 0; }

  // Whether it says nothing of what a claim of another reading says.
  bool Lacks(const Claim& claim) const {
    switch (claim.kind) {
      case ClaimKind::kCount:
      case ClaimKind::kRest:
        return false;
      case ClaimKind::kOrder:
        return !Has(ClaimKind::kOrder);
      case ClaimKind::kDominant:
        return IsUnnamed(claim) ||
               !(Has(ClaimKind::kDominant) || Has(ClaimKind::kMoreThan) || Has(ClaimKind::kAmount));
      case ClaimKind::kShape:
      case ClaimKind::kDirection:
      case ClaimKind::kBetween:
      case ClaimKind::kSurrounds:
      case ClaimKind::kWithin:
      case ClaimKind::kAdjacent:
      case ClaimKind::kAlong:
      case ClaimKind::kConnects:
      case ClaimKind::kCrosses:
        return of_subject_.count({claim.kind, claim.subject}) == 0;
      default:
        return IsUnnamed(claim);
    }
  }

 private:
  bool IsUnnamed(const Claim& claim) const { return letters_.count(claim.subject) == 0; }

  std::set<ClaimKind> kinds_;
  std::set<std::pair<ClaimKind, char>> of_subject_;
  std::set<char> letters_;
};

// Returns the classes that a text names by nouns of single things of a reading alone: "a wooden
// pier" is no village, "a stone wall" no rock.
std::set<char> ClassesOfThings(std::string_view text, const std::vector<ThingWish>& things,
                               Vocabulary vocabulary) {
  // An oak may have been read as a tree: both are of the class of forests.
  const auto class_of = [vocabulary](const std::string& kind) {
    const ClassWord* noun = MatchClassWord(Tokenize(kind), 0).word;
    return noun == nullptr ? '\0' : noun->LetterIn(vocabulary);
  };
  const auto is_had = [&](const ThingKind& kind) {
    const char letter = class_of(kind.name);
    return std::any_of(things.begin(), things.end(), [&](const ThingWish& wish) {
      if (wish.count_most == kMostThings) return false;  // "the pines": a forest as well
      return wish.kind == kind.name || (letter != '\0' && letter == class_of(wish.kind));
    });
  };
  ThingWords words(text, vocabulary);
  std::set<char> of_things, of_land;
  std::size_t end_of_thing = 0;
  for (std::size_t at = 0; at < words.tokens().size(); ++at) {
    words.GoTo(at);
    bool plural = false;
    const ThingKind* kind = words.TakeKind(&plural);
    if (kind != nullptr && is_had(*kind)) end_of_thing = std::max(end_of_thing, words.at());
    const ClassWord* noun = MatchClassWord(words.tokens(), at).word;
    if (noun != nullptr)
      (at < end_of_thing ? of_things : of_land).insert(noun->LetterIn(vocabulary));
  }
  of_land.insert('\0');  // nouns of no class in this vocabulary
  for (const char letter : of_land) of_things.erase(letter);
  return of_things;
}

// Classes by what the features of a plan call them, "the river"; those of several features have no
// name of their own.
LandNames NamesOf(const std::vector<PlannedFeature>& features) {
  LandNames names;
  std::set<char> several;
  for (const PlannedFeature& feature : features) {
    if (feature.supposed || feature.noun.empty()) continue;
    const bool is_new = names.insert({feature.letter, "the " + feature.noun}).second;
    if (!is_new) several.insert(feature.letter);
  }
  for (const char letter : several) names.erase(letter);
  return names;
}

}  // namespace

std::vector<Claim> WithoutThings(std::vector<Claim> claims, const LayoutRequest& request,
                                 const std::vector<ThingWish>& things) {
  const std::set<char> of_things = ClassesOfThings(request.instruction, things, request.vocabulary);
  const auto is_of_thing = [&of_things](const Claim& claim) {
    return of_things.count(claim.subject) + of_things.count(claim.object) > 0;
  };
  claims.erase(std::remove_if(claims.begin(), claims.end(), is_of_thing), claims.end());
  return claims;
}

Result<LayoutReading> Completed(const LayoutRequest& request, LayoutReading reading,
                                const std::vector<Claim>& second) {
  const Named named(reading.plan.claims);
  if (!reading.of_sentences || named.Has(ClaimKind::kRest)) return reading;
  std::vector<Claim> missing;
  std::copy_if(second.begin(), second.end(), std::back_inserter(missing),
               [&named](const Claim& claim) { return named.Lacks(claim); });
  if (missing.empty()) return reading;
  std::vector<std::string> sentences = reading.sentences;
  for (std::string& sentence :
       SentencesOf(missing, request.vocabulary, NamesOf(reading.plan.features))) {
    if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end())
      sentences.push_back(std::move(sentence));
  }
  auto whole =
      ReadBesideThings(request, ThingsTaken::kWhole, [&sentences](const LayoutRequest& rest) {
        return Result<LayoutReading>(ReadingOfSentences(rest, std::move(sentences)));
      });
  if (whole.ok()) whole->log_probability = reading.log_probability;
  return whole;
}

}  // namespace latticeworld
