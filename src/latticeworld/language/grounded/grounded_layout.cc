#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/grounded.h"
#include "latticeworld/language/grounded/layout_parser.h"
#include "latticeworld/language/grounded/layout_synthesis.h"
#include "latticeworld/language/grounded/relief_conflicts.h"

namespace latticeworld {
namespace {

constexpr int kMaxAttempts = 12;
// Wishes laid in all attempts together: what asks for much is drawn again less often.
constexpr int kMaxLaidWishes = 64;

int AttemptsFor(const LayoutPlan& plan) {
  const auto wishes = static_cast<int>(plan.areas.size() + plan.courses.size());
  return std::clamp(kMaxLaidWishes / std::max(1, wishes), 2, kMaxAttempts);
}

double TotalDistance(const std::vector<Claim>& claims, const SymbolicLayout& layout) {
  double total = 0.0;
  for (const Claim& claim : claims) total += Measure(claim, layout).distance;
  return total;
}

class GroundedLayoutGenerator final : public LayoutGenerator {
 public:
  std::string_view name() const override { return "grounded"; }

  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress& progress) override {
    LW_RETURN_IF_ERROR(Validate(request));
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    LayoutPlan plan = ParseLayoutInstruction(request.instruction, request.vocabulary);
    LayoutAnswer answer;
    if (plan.claims.empty() && request.relief != nullptr) {
      answer.layout = LayoutFromRelief(request.vocabulary, *request.relief, request.seed);
      answer.warnings = std::move(plan.warnings);
      return answer;
    }
    // Lay out and measure; where a claim fails, draw again and keep the best.
    double best = std::numeric_limits<double>::infinity();
    const int attempts = AttemptsFor(plan);
    for (int attempt = 0; attempt < attempts && best > 0.0; ++attempt) {
      LW_RETURN_IF_ERROR(progress.CheckCancelled());
      progress.Report("layout", static_cast<double>(attempt) / attempts);
      SymbolicLayout layout = SynthesizeLayout(
          plan, request.relief, request.seed + static_cast<std::uint64_t>(attempt) * 0x9E3779B9u);
      const double distance = TotalDistance(plan.claims, layout);
      if (distance >= best) continue;
      best = distance;
      answer.layout = std::move(layout);
    }
    answer.warnings = std::move(plan.warnings);
    for (const Claim& claim : plan.claims) {
      const ClaimMeasure measure = Measure(claim, answer.layout);
      if (measure.holds) continue;
      answer.warnings.push_back("not satisfied: " + Quote(claim.words) + ": " +
                                measure.explanation);
    }
    if (request.relief != nullptr) {
      for (std::string& conflict :
           ReliefConflicts(plan.claims, request.vocabulary, *request.relief)) {
        answer.warnings.push_back(std::move(conflict));
      }
    }
    answer.claims = std::move(plan.claims);
    return answer;
  }
};

}  // namespace

std::unique_ptr<LayoutGenerator> MakeGroundedLayoutGenerator() {
  return std::make_unique<GroundedLayoutGenerator>();
}

}  // namespace latticeworld
