#include "latticeworld/language/reading/checked_reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/reading/claim_coverage.h"
#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/sentences_of_claims.h"

namespace latticeworld {
namespace {

// A model that is less sure of the tokens of its sentences than this, in the mean (natural
// logarithm of their probability), has misread more often than the rules have: over the left-out
// authors f13, g01 and g02.
constexpr double kSure = -0.15;

bool IsSure(double log_probability) { return log_probability >= kSure; }

std::set<AgentCategory> CategoriesOf(const HeardEnvironment& heard) {
  std::set<AgentCategory> categories;
  for (const AgentWish& wish : heard.agents) {
    categories.insert(wish.categories.begin(), wish.categories.end());
  }
  for (const EnvironmentClaim& claim : heard.absences) {
    categories.insert(claim.categories.begin(), claim.categories.end());
  }
  return categories;
}

bool IsOfTheSame(const EnvironmentClaim& a, const EnvironmentClaim& b) {
  return a.kind == b.kind && a.asset == b.asset && a.variant_key == b.variant_key &&
         a.parameter_key == b.parameter_key;
}

// Whether a sentence asks for agents, or for none.
bool IsOfAgents(const std::string& sentence, const Catalogue& catalogue) {
  const HeardEnvironment heard = EnvironmentOfSentences({sentence}, catalogue);
  return !heard.agents.empty() || !heard.absences.empty();
}

// Completes what one reader has heard by what only the other one has. Returns what was added;
// agents are added all or none, and then take the place of those that were heard.
HeardEnvironment Complete(HeardEnvironment* heard, const HeardEnvironment& other) {
  HeardEnvironment added;
  for (std::size_t i = 0; i < heard->coarse.size(); ++i) {
    HeardCoarse& coarse = heard->coarse[i];
    if (!coarse.value.empty() || !coarse.ruled_out.empty()) continue;
    coarse = other.coarse[i];
    added.coarse[i] = other.coarse[i];
  }
  for (const FineWish& wish : other.fine) {
    const bool known =
        std::any_of(heard->fine.begin(), heard->fine.end(),
                    [&wish](const FineWish& mine) { return IsOfTheSame(mine.claim, wish.claim); });
    if (known) continue;
    heard->fine.push_back(wish);
    added.fine.push_back(wish);
  }
  const std::set<AgentCategory> mine = CategoriesOf(*heard);
  const std::set<AgentCategory> others = CategoriesOf(other);
  const bool wider = others.size() > mine.size() &&
                     std::includes(others.begin(), others.end(), mine.begin(), mine.end());
  if (wider) {
    heard->agents = added.agents = other.agents;
    heard->absences = added.absences = other.absences;
  }
  return added;
}

// The same of a reading, whose sentences and coverage then say what was added too.
void Complete(const EnvironmentRequest& request, const HeardEnvironment& other,
              EnvironmentReading* reading) {
  const HeardEnvironment added = Complete(&reading->heard, other);
  std::vector<std::string>& sentences = reading->sentences;
  if (!added.agents.empty() || !added.absences.empty()) {
    sentences.erase(std::remove_if(sentences.begin(), sentences.end(),
                                   [&request](const std::string& sentence) {
                                     return IsOfAgents(sentence, *request.catalogue);
                                   }),
                    sentences.end());
  }
  for (std::string& sentence : SentencesOf(ClaimsOf(added, request.layout))) {
    if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end()) {
      sentences.push_back(std::move(sentence));
    }
  }
  const Vocabulary vocabulary = request.layout->vocabulary;
  reading->coverage = CoverageOf(request.instruction, sentences,
                                 ClaimsOf(reading->heard, request.layout), vocabulary);
  TakeOffCarried(reading->coverage, SentenceKind::kEnvironment, vocabulary,
                 &reading->heard.not_understood);
}

// Whether the second reading may count and complete the first, or only stands beside it.
enum class Second : std::uint8_t { kChecks, kIsCompared };

class CheckedReader final : public InstructionReader {
 public:
  CheckedReader(std::shared_ptr<InstructionReader> first, std::shared_ptr<InstructionReader> second,
                Second role)
      : first_(std::move(first)), second_(std::move(second)), checks_(role == Second::kChecks) {
    LW_CHECK(first_ != nullptr && second_ != nullptr, "two readers check each other");
  }

  std::string_view name() const override { return checks_ ? "checked" : first_->name(); }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& progress,
                                   std::vector<ModelReply>* replies) override {
    const std::size_t asked = replies->size();
    LW_ASSIGN_OR_RETURN(LayoutReading first, first_->ReadLayout(request, progress, replies));
    if (replies->size() == asked) return first;
    LW_ASSIGN_OR_RETURN(LayoutReading second, second_->ReadLayout(request, progress, replies));
    if (checks_ && !IsSure(first.log_probability)) std::swap(first, second);
    first.second = std::move(second.plan.claims);
    return first;
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& progress,
                                             std::vector<ModelReply>* replies) override {
    const std::size_t asked = replies->size();
    LW_ASSIGN_OR_RETURN(EnvironmentReading first,
                        first_->ReadEnvironment(request, progress, replies));
    if (replies->size() == asked) return first;
    LW_ASSIGN_OR_RETURN(EnvironmentReading second,
                        second_->ReadEnvironment(request, progress, replies));
    if (checks_ && !IsSure(first.log_probability)) std::swap(first, second);
    if (checks_) Complete(request, second.heard, &first);
    first.second = std::move(second.heard);
    return first;
  }

 private:
  const std::shared_ptr<InstructionReader> first_;
  const std::shared_ptr<InstructionReader> second_;
  const bool checks_;
};

}  // namespace

std::shared_ptr<InstructionReader> MakeComparedReader(std::shared_ptr<InstructionReader> first,
                                                      std::shared_ptr<InstructionReader> second) {
  return std::make_shared<CheckedReader>(std::move(first), std::move(second), Second::kIsCompared);
}

std::shared_ptr<InstructionReader> MakeCheckedReader(std::shared_ptr<InstructionReader> first,
                                                     std::shared_ptr<InstructionReader> second) {
  return std::make_shared<CheckedReader>(std::move(first), std::move(second), Second::kChecks);
}

}  // namespace latticeworld
