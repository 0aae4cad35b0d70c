#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/drawn/drawn.h"
#include "latticeworld/language/grounded/synthesis/layout_from_relief.h"
#include "latticeworld/language/grounded/synthesis/layout_synthesis.h"
#include "latticeworld/language/grounded/synthesis/relief_conflicts.h"

namespace latticeworld {
namespace {

// A warning for each claim that the layout does not meet.
void AppendUnsatisfied(const std::vector<Claim>& claims, const SymbolicLayout& layout,
                       std::vector<std::string>* warnings) {
  for (const Claim& claim : claims) {
    const ClaimMeasure measure = Measure(claim, layout);
    if (measure.holds) continue;
    warnings->push_back("not satisfied: " + Quote(claim.words) + ": " + measure.explanation);
  }
}

void AppendNotUnderstood(const std::vector<std::string>& words,
                         std::vector<std::string>* warnings) {
  constexpr std::size_t kMaxQuoted = 20;
  for (std::size_t i = 0; i < std::min(words.size(), kMaxQuoted); ++i) {
    warnings->push_back("not understood: " + Quote(words[i]));
  }
  if (words.size() > kMaxQuoted) {
    warnings->push_back("not understood: " + std::to_string(words.size() - kMaxQuoted) +
                        " further pieces of the text");
  }
}

class DrawnLayoutGenerator final : public LayoutGenerator {
 public:
  DrawnLayoutGenerator(std::string name, std::shared_ptr<InstructionReader> reader)
      : name_(std::move(name)), reader_(std::move(reader)) {}

  std::string_view name() const override { return name_; }

  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress& progress,
                                std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(Validate(request));
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    progress.Report("layout", 0.0);
    LayoutPlan plan;
    if (request.reading != nullptr) {
      plan = request.reading->plan;
    } else {
      LW_ASSIGN_OR_RETURN(LayoutReading reading, reader_->ReadLayout(request, progress, replies));
      plan = std::move(reading.plan);
    }
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    LayoutAnswer answer;
    answer.warnings = std::move(plan.warnings);
    AppendNotUnderstood(plan.not_understood, &answer.warnings);
    if (plan.claims.empty() && request.relief != nullptr) {
      answer.layout = LayoutFromRelief(request.vocabulary, *request.relief, request.seed);
      return answer;
    }
    answer.layout = SynthesizeLayout(plan, request.relief, request.seed);
    AppendUnsatisfied(plan.claims, answer.layout, &answer.warnings);
    if (request.relief != nullptr) {
      for (std::string& conflict :
           ReliefConflicts(plan.claims, request.vocabulary, *request.relief)) {
        answer.warnings.push_back(std::move(conflict));
      }
    }
    return answer;
  }

 private:
  const std::string name_;
  const std::shared_ptr<InstructionReader> reader_;
};

}  // namespace

std::unique_ptr<LayoutGenerator> MakeDrawnLayoutGenerator(
    std::string name, std::shared_ptr<InstructionReader> reader) {
  return std::make_unique<DrawnLayoutGenerator>(std::move(name), std::move(reader));
}

}  // namespace latticeworld
