#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

std::ptrdiff_t HeldOn(const SymbolicLayout& layout, const std::vector<Claim>& claims) {
  const LayoutMasks masks(layout);
  return std::count_if(claims.begin(), claims.end(),
                       [&masks](const Claim& claim) { return DistanceOf(claim, masks) == 0.0; });
}

class BestOfLayoutGenerator final : public LayoutGenerator {
 public:
  BestOfLayoutGenerator(std::unique_ptr<LayoutGenerator> generator, int tries)
      : generator_(std::move(generator)), tries_(tries) {}

  std::string_view name() const override { return generator_->name(); }

  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress& progress,
                                std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(Validate(request));
    const std::vector<Claim> claims =
        request.reading != nullptr
            ? request.reading->plan.claims
            : ReadLayoutInstruction(request.instruction, request.vocabulary).plan.claims;
    const auto all = static_cast<std::ptrdiff_t>(claims.size());
    std::optional<LayoutAnswer> best;
    std::vector<ModelReply> kept;  // of the best try, or of the last one where none has a layout
    std::ptrdiff_t best_held = -1;
    Status failure;
    for (int i = 0; i < tries_ && best_held < all; ++i) {
      LayoutRequest again = request;
      if (i > 0) again.seed = StreamSeed(request.seed, "layout try " + std::to_string(i));
      std::vector<ModelReply> said;
      Result<LayoutAnswer> answer = generator_->Generate(again, progress, &said);
      if (!answer.ok()) {
        if (answer.status().code() == StatusCode::kCancelled) return answer;
        failure = answer.status();
        if (!best) kept = std::move(said);
        continue;
      }
      const std::ptrdiff_t held = HeldOn(answer->layout, claims);
      if (held <= best_held) continue;
      best = *std::move(answer);
      best_held = held;
      kept = std::move(said);
    }
    for (ModelReply& reply : kept) replies->push_back(std::move(reply));
    if (!best) return failure;
    return *std::move(best);
  }

 private:
  const std::unique_ptr<LayoutGenerator> generator_;
  const int tries_;
};

}  // namespace

std::unique_ptr<LayoutGenerator> MakeBestOfLayoutGenerator(
    std::unique_ptr<LayoutGenerator> generator, int tries) {
  LW_CHECK(generator != nullptr && tries >= 1, "somebody tries, once or more");
  return std::make_unique<BestOfLayoutGenerator>(std::move(generator), tries);
}

}  // namespace latticeworld
