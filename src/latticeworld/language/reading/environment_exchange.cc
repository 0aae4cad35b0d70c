#include "latticeworld/language/reading/environment_exchange.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/reading/claim_coverage.h"
#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/sentences_of_claims.h"
#include "latticeworld/language/reading/text_units.h"

namespace latticeworld {
namespace {

template <typename Values, typename Wrong>
void EraseIf(Values* values, const Wrong& wrong) {
  values->erase(std::remove_if(values->begin(), values->end(), wrong), values->end());
}

bool IsSaid(const HeardCoarse& coarse) {
  return !coarse.value.empty() || !coarse.ruled_out.empty();
}

bool HasAgents(const HeardEnvironment& heard) {
  return !heard.agents.empty() || !heard.absences.empty();
}

bool HasSame(const std::vector<FineWish>& wishes, const FineWish& wanted) {
  return std::any_of(wishes.begin(), wishes.end(), [&wanted](const FineWish& wish) {
    const EnvironmentClaim& a = wish.claim;
    const EnvironmentClaim& b = wanted.claim;
    return a.kind == b.kind && a.asset == b.asset && a.variant_key == b.variant_key &&
           a.parameter_key == b.parameter_key;
  });
}

using Numbers = std::map<std::string, int>;  // how often each is said

Numbers NumbersIn(const std::vector<std::string>& texts, Vocabulary vocabulary) {
  Numbers numbers;
  for (const std::string& text : texts) {
    for (const TextUnit& unit : UnitsOf(text, SentenceKind::kEnvironment, vocabulary)) {
      for (const std::string& key : unit.keys)
        if (StartsWith(key, "number ")) ++numbers[key];
    }
  }
  return numbers;
}

// Finds parameters that a model made up: they are nothing like those of another reading, and the
// text does not say their numbers, or says them of something else. Models that were taught "no
// wind" and "12 m/s" may read "windy, three sheep" as 3 m/s.
class MadeUpParameters {
 public:
  MadeUpParameters(const EnvironmentRequest& request, const EnvironmentReading& reading)
      : request_(request),
        reading_(reading),
        of_text_(NumbersIn({request.instruction}, request.layout->vocabulary)),
        of_sentences_(NumbersIn(reading.sentences, request.layout->vocabulary)) {}

  // Whether the reading has such a one of what `other` speaks of.
  bool StandFor(const FineWish& other) const {
    const EnvironmentClaim& theirs = other.claim;
    if (theirs.kind != EnvironmentClaimKind::kParameter) return false;
    const std::vector<FineWish>& fine = reading_.heard.fine;
    return std::any_of(fine.begin(), fine.end(), [&](const FineWish& wish) {
      const EnvironmentClaim& mine = wish.claim;
      return HasSame({wish}, other) && (mine.most < theirs.least || theirs.most < mine.least) &&
             !IsSaid(wish);
    });
  }

 private:
  // Whether the text says a number of the sentences that say the wish, as often as all sentences.
  bool IsSaid(const FineWish& wish) const {
    std::vector<std::string> saying;
    std::copy_if(reading_.sentences.begin(), reading_.sentences.end(), std::back_inserter(saying),
                 [&](const std::string& sentence) {
                   return HasSame(EnvironmentOfSentences({sentence}, *request_.catalogue).fine,
                                  wish);
                 });
    const Numbers numbers = NumbersIn(saying, request_.layout->vocabulary);
    return numbers.empty() || std::any_of(numbers.begin(), numbers.end(), [this](const auto& one) {
             const auto in_text = of_text_.find(one.first);
             return in_text != of_text_.end() && in_text->second >= of_sentences_.at(one.first);
           });
  }

  const EnvironmentRequest& request_;
  const EnvironmentReading& reading_;
  const Numbers of_text_, of_sentences_;
};

// What was taken over, and what it took the place of.
struct Exchanged {
  HeardEnvironment taken;
  HeardEnvironment replaced;
};

void ExchangeCoarse(bool counts, HeardCoarse* mine, HeardCoarse* second, HeardCoarse* taken,
                    HeardCoarse* replaced) {
  const bool fills = mine->value.empty() && (!second->value.empty() || !IsSaid(*mine));
  const bool replaces =
      counts && !second->value.empty() && second->value != mine->value && !second->hint;
  if (!IsSaid(*second) || !(fills || replaces)) return;
  *taken = *second;
  if (!IsSaid(*mine)) {
    *mine = *second;
    return;
  }
  *replaced = *mine;
  std::swap(*mine, *second);
}

void ExchangeFine(bool counts, const MadeUpParameters& made_up, std::vector<FineWish>* mine,
                  std::vector<FineWish>* second, Exchanged* exchanged) {
  std::vector<FineWish>& taken = exchanged->taken.fine;
  std::vector<FineWish>& replaced = exchanged->replaced.fine;
  std::copy_if(second->begin(), second->end(), std::back_inserter(taken),
               [&](const FineWish& wish) {
                 return counts || !HasSame(*mine, wish) || made_up.StandFor(wish);
               });
  const auto goes = std::stable_partition(
      mine->begin(), mine->end(), [&](const FineWish& wish) { return !HasSame(taken, wish); });
  replaced.assign(goes, mine->end());
  mine->erase(goes, mine->end());
  mine->insert(mine->end(), taken.begin(), taken.end());
  if (replaced.empty()) return;
  EraseIf(second, [&](const FineWish& wish) { return HasSame(replaced, wish); });
  second->insert(second->end(), replaced.begin(), replaced.end());
}

void ExchangeAgents(bool counts, HeardEnvironment* mine, HeardEnvironment* second,
                    Exchanged* exchanged) {
  if (!HasAgents(*second)) return;
  if (HasAgents(*mine) && !counts) return;
  exchanged->taken.agents = second->agents;
  exchanged->taken.absences = second->absences;
  if (!HasAgents(*mine)) {
    mine->agents = second->agents;
    mine->absences = second->absences;
    return;
  }
  exchanged->replaced.agents = mine->agents;
  exchanged->replaced.absences = mine->absences;
  std::swap(mine->agents, second->agents);
  std::swap(mine->absences, second->absences);
}

// Whether two things that were heard speak of the same.
bool Overlap(const HeardEnvironment& a, const HeardEnvironment& b) {
  for (std::size_t i = 0; i < a.coarse.size(); ++i) {
    if (IsSaid(a.coarse[i]) && IsSaid(b.coarse[i])) return true;
  }
  return (HasAgents(a) && HasAgents(b)) ||
         std::any_of(a.fine.begin(), a.fine.end(),
                     [&b](const FineWish& wish) { return HasSame(b.fine, wish); });
}

bool IsEmpty(const HeardEnvironment& heard) {
  return !HasAgents(heard) && heard.fine.empty() &&
         std::none_of(heard.coarse.begin(), heard.coarse.end(), IsSaid);
}

void AddNew(std::vector<std::string> from, std::vector<std::string>* to) {
  for (std::string& text : from) {
    if (std::find(to->begin(), to->end(), text) == to->end()) to->push_back(std::move(text));
  }
}

}  // namespace

void Exchange(const EnvironmentRequest& request, const std::set<ReadingPart>& parts,
              EnvironmentReading* reading, HeardEnvironment* second) {
  HeardEnvironment& heard = reading->heard;
  Exchanged exchanged;
  for (std::size_t i = 0; i < heard.coarse.size(); ++i) {
    ExchangeCoarse(parts.count(ReadingPart::kCoarse) > 0, &heard.coarse[i], &second->coarse[i],
                   &exchanged.taken.coarse[i], &exchanged.replaced.coarse[i]);
  }
  ExchangeFine(parts.count(ReadingPart::kFine) > 0, MadeUpParameters(request, *reading),
               &heard.fine, &second->fine, &exchanged);
  ExchangeAgents(parts.count(ReadingPart::kAgents) > 0, &heard, second, &exchanged);
  if (IsEmpty(exchanged.taken)) return;

  // What was replaced is neither said nor warned of any more.
  EraseIf(&reading->sentences, [&](const std::string& sentence) {
    if (!Overlap(EnvironmentOfSentences({sentence}, *request.catalogue), exchanged.replaced)) {
      return false;
    }
    EraseIf(&heard.warnings, [&sentence](const std::string& warning) {
      return warning.find(sentence) != std::string::npos;
    });
    return true;
  });
  AddNew(SentencesOf(ClaimsOf(exchanged.taken, request.layout)), &reading->sentences);
  AddNew(second->warnings, &heard.warnings);
  const Vocabulary vocabulary = request.layout->vocabulary;
  reading->coverage = CoverageOf(request.instruction, reading->sentences,
                                 ClaimsOf(heard, request.layout), vocabulary);
  TakeOffCarried(reading->coverage, SentenceKind::kEnvironment, vocabulary, &heard.not_understood);
  AddLost(reading->coverage, heard.warnings, &heard.not_understood);
}

}  // namespace latticeworld
