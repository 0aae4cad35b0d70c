#include "latticeworld/language/reading/environment_exchange.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/reading/claim_coverage.h"
#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/made_up.h"
#include "latticeworld/language/reading/sentences_of_claims.h"

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
  return std::any_of(wishes.begin(), wishes.end(),
                     [&wanted](const FineWish& wish) { return AreOfSame(wish, wanted); });
}

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

// gives_way: whether a wish of the reading does so to one of the second, which speaks of the same.
template <typename GivesWay>
void ExchangeFine(const GivesWay& gives_way, std::vector<FineWish>* mine,
                  std::vector<FineWish>* second, Exchanged* exchanged) {
  std::vector<FineWish>& taken = exchanged->taken.fine;
  std::vector<FineWish>& replaced = exchanged->replaced.fine;
  std::copy_if(second->begin(), second->end(), std::back_inserter(taken),
               [&](const FineWish& wish) {
                 return std::all_of(mine->begin(), mine->end(), [&](const FineWish& own) {
                   return !AreOfSame(own, wish) || gives_way(own, wish);
                 });
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

bool HasSame(const std::vector<EnvironmentClaim>& absences, const EnvironmentClaim& wanted) {
  return std::any_of(absences.begin(), absences.end(), [&wanted](const EnvironmentClaim& one) {
    return one.kind == wanted.kind && one.categories == wanted.categories &&
           one.least_quantity == wanted.least_quantity && one.most_quantity == wanted.most_quantity;
  });
}

void DropMadeUpAbsences(const MadeUp& made_up, HeardEnvironment* mine, Exchanged* exchanged) {
  const auto goes = std::stable_partition(
      mine->absences.begin(), mine->absences.end(),
      [&made_up](const EnvironmentClaim& absence) { return !made_up.Is(absence); });
  exchanged->replaced.absences.assign(goes, mine->absences.end());
  mine->absences.erase(goes, mine->absences.end());
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
  exchanged->replaced.absences.insert(exchanged->replaced.absences.end(), mine->absences.begin(),
                                      mine->absences.end());
  std::swap(mine->agents, second->agents);
  std::swap(mine->absences, second->absences);
}

// Whether two things that were heard speak of the same.
bool Overlap(const HeardEnvironment& a, const HeardEnvironment& b) {
  for (std::size_t i = 0; i < a.coarse.size(); ++i) {
    if (IsSaid(a.coarse[i]) && IsSaid(b.coarse[i])) return true;
  }
  return (!a.agents.empty() && !b.agents.empty()) ||
         std::any_of(
             a.absences.begin(), a.absences.end(),
             [&b](const EnvironmentClaim& absence) { return HasSame(b.absences, absence); }) ||
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
  const MadeUp made_up(request, *reading);
  const auto gives_way = [&](const FineWish& own, const FineWish& other) {
    return parts.count(ReadingPart::kFine) > 0 || made_up.Is(own, other);
  };
  ExchangeFine(gives_way, &heard.fine, &second->fine, &exchanged);
  DropMadeUpAbsences(made_up, &heard, &exchanged);
  ExchangeAgents(parts.count(ReadingPart::kAgents) > 0, &heard, second, &exchanged);
  if (IsEmpty(exchanged.taken) && IsEmpty(exchanged.replaced)) return;

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
