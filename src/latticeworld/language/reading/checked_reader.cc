#include "latticeworld/language/reading/checked_reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <set>
#include <utility>

#include "latticeworld/common/check.h"

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

void Complete(HeardEnvironment* heard, const HeardEnvironment& other) {
  for (std::size_t i = 0; i < heard->coarse.size(); ++i) {
    HeardCoarse& coarse = heard->coarse[i];
    if (coarse.value.empty() && coarse.ruled_out.empty()) coarse = other.coarse[i];
  }
  for (const FineWish& wish : other.fine) {
    const bool known =
        std::any_of(heard->fine.begin(), heard->fine.end(),
                    [&wish](const FineWish& mine) { return IsOfTheSame(mine.claim, wish.claim); });
    if (!known) heard->fine.push_back(wish);
  }
  const std::set<AgentCategory> mine = CategoriesOf(*heard);
  const std::set<AgentCategory> others = CategoriesOf(other);
  const bool wider = others.size() > mine.size() &&
                     std::includes(others.begin(), others.end(), mine.begin(), mine.end());
  if (wider) {
    heard->agents = other.agents;
    heard->absences = other.absences;
  }
}

class CheckedReader final : public InstructionReader {
 public:
  CheckedReader(std::shared_ptr<InstructionReader> first, std::shared_ptr<InstructionReader> second)
      : first_(std::move(first)), second_(std::move(second)) {
    LW_CHECK(first_ != nullptr && second_ != nullptr, "two readers check each other");
  }

  std::string_view name() const override { return "checked"; }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& progress,
                                   std::vector<ModelReply>* replies) override {
    const std::size_t asked = replies->size();
    LW_ASSIGN_OR_RETURN(LayoutReading first, first_->ReadLayout(request, progress, replies));
    if (replies->size() == asked) return first;
    LW_ASSIGN_OR_RETURN(LayoutReading second, second_->ReadLayout(request, progress, replies));
    if (!IsSure(first.log_probability)) std::swap(first, second);
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
    if (!IsSure(first.log_probability)) std::swap(first, second);
    Complete(&first.heard, second.heard);
    first.second = std::move(second.heard);
    return first;
  }

 private:
  const std::shared_ptr<InstructionReader> first_;
  const std::shared_ptr<InstructionReader> second_;
};

}  // namespace

std::shared_ptr<InstructionReader> MakeCheckedReader(std::shared_ptr<InstructionReader> first,
                                                     std::shared_ptr<InstructionReader> second) {
  return std::make_shared<CheckedReader>(std::move(first), std::move(second));
}

}  // namespace latticeworld
