#include "latticeworld/language/reading/checked_reader.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/reading/environment_exchange.h"
#include "latticeworld/language/reading/land_completion.h"
#include "latticeworld/language/reading/made_up.h"
#include "latticeworld/language/reading/reading_evidence.h"

namespace latticeworld {
namespace {

// What completing a model's reading adds to the odds that it is the better one: these are of what
// models say themselves.
constexpr double kLogOddsOfCompletion = 1.0;

// The parts of an environment in which the second reading counts where both say something.
std::set<ReadingPart> PartsOfSecond(const std::vector<ReadingEvidence>& evidence) {
  std::set<ReadingPart> parts;
  for (const ReadingEvidence& one : evidence) {
    if (LogOddsOfModel(one) < 0.0) parts.insert(one.part);
  }
  return parts;
}

// Whether a text was the small language, which no model was asked to read. A text without a
// sentence for the model was not asked of it either: the second reading is all there is.
template <typename Reading>
bool IsSmallLanguage(const Reading& reading, const std::vector<ModelReply>& replies,
                     std::size_t asked) {
  return replies.size() == asked && !reading.sentences.empty();
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
  bool reads_by_kind() const override { return first_->reads_by_kind(); }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& progress,
                                   std::vector<ModelReply>* replies) override {
    const std::size_t asked = replies->size();
    LW_ASSIGN_OR_RETURN(LayoutReading first, first_->ReadLayout(request, progress, replies));
    if (IsSmallLanguage(first, *replies, asked)) return first;
    LW_ASSIGN_OR_RETURN(LayoutReading second, second_->ReadLayout(request, progress, replies));
    // What the rules take for land where the model has single things counts only for the rules.
    std::vector<Claim> claims = second.plan.claims;
    second.plan.claims = WithoutThings(claims, request, first.plan.things);
    std::vector<ReadingEvidence> evidence = EvidenceOf(first, second, request.vocabulary);
    // Single things that a model reads make no claims of land.
    const bool of_things = evidence.front().claims == 0 && evidence.front().second_claims == 0 &&
                           !first.plan.things.empty();
    if (checks_ && !of_things && LogOddsOfModel(evidence.front()) < -kLogOddsOfCompletion) {
      second.plan.claims = std::move(claims);
      std::swap(first, second);
    } else if (checks_) {
      LW_ASSIGN_OR_RETURN(first, Completed(request, std::move(first), second.plan.claims));
    }
    first.second = std::move(second.plan.claims);
    first.evidence = std::move(evidence);
    return first;
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& progress,
                                             std::vector<ModelReply>* replies) override {
    const std::size_t asked = replies->size();
    LW_ASSIGN_OR_RETURN(EnvironmentReading first,
                        first_->ReadEnvironment(request, progress, replies));
    if (IsSmallLanguage(first, *replies, asked)) return first;
    LW_ASSIGN_OR_RETURN(EnvironmentReading second,
                        second_->ReadEnvironment(request, progress, replies));
    if (checks_) first = WithoutUnspoken(request, std::move(first), second.sentences);
    first.evidence = EvidenceOf(first, second, request.layout);
    if (checks_) Exchange(request, PartsOfSecond(first.evidence), &first, &second.heard);
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
