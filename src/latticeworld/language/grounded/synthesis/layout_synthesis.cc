#include "latticeworld/language/grounded/synthesis/layout_synthesis.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/grounded/synthesis/claim_search.h"
#include "latticeworld/language/grounded/synthesis/draft.h"
#include "latticeworld/language/grounded/synthesis/lines/line_copies.h"
#include "latticeworld/language/grounded/synthesis/naturalness.h"

namespace latticeworld {
namespace {

constexpr int kMaxAttempts = 8;
constexpr int kSearched = 2;         // of the best attempts
constexpr int kSearchBudget = 1200;  // measured claims for each
constexpr double kGone = 1e-6;

struct Attempt {
  Canvas canvas;
  double distance = 0.0;
  double roughness = 0.0;

  bool IsBetterThan(const Attempt& other) const {
    if (distance < other.distance - kGone) return true;
    return distance < other.distance + kGone && roughness < other.roughness;
  }
};

Attempt Construct(const LayoutPlan& plan, const ForbiddenCells& forbidden, const Relief* relief,
                  std::uint64_t seed, int number) {
  Draft draft{
      plan, forbidden, relief,   RandomStream(seed, "language/layout/" + std::to_string(number)),
      {},   {},        Canvas(), std::vector<std::vector<CellIndex>>(plan.features.size())};
  draft.wishes = PieceWishesOf(plan, &draft.random);
  draft.skeleton = PlaceSkeleton(plan, draft.wishes, forbidden, relief, &draft.random);
  LayPieces(&draft);
  LayLines(&draft);
  LayLatePieces(&draft);
  LayLand(&draft);
  TidySmallPieces(plan, forbidden, &draft.canvas);
  Attempt attempt{std::move(draft.canvas)};
  const LayoutMasks masks(SymbolicLayout{plan.vocabulary, attempt.canvas.letters()});
  attempt.distance = TotalDistance(plan, masks);
  attempt.roughness = CostOf(RoughnessOf(masks, attempt.canvas.lines()));
  return attempt;
}

}  // namespace

SymbolicLayout SynthesizeLayout(const LayoutPlan& asked, const Relief* relief, std::uint64_t seed) {
  const LayoutPlan plan = WithLineCopies(asked);
  const ForbiddenCells forbidden(plan);
  // The best attempts first; the first that satisfies all claims will do.
  std::vector<Attempt> attempts;
  for (int number = 0; number < kMaxAttempts; ++number) {
    attempts.push_back(Construct(plan, forbidden, relief, seed, number));
    if (attempts.back().distance < kGone) {
      return {plan.vocabulary, attempts.back().canvas.letters()};
    }
  }
  std::stable_sort(attempts.begin(), attempts.end(),
                   [](const Attempt& a, const Attempt& b) { return a.IsBetterThan(b); });
  attempts.resize(std::min<std::size_t>(attempts.size(), kSearched));
  RandomStream random(seed, "language/layout/search");
  for (Attempt& attempt : attempts) {
    attempt.distance = SatisfyClaims(plan, forbidden, kSearchBudget, &random, &attempt.canvas);
    SmoothBorders(plan, forbidden, &attempt.canvas);
    TidySmallPieces(plan, forbidden, &attempt.canvas);
    if (attempt.distance < kGone) return {plan.vocabulary, attempt.canvas.letters()};
  }
  const auto best =
      std::min_element(attempts.begin(), attempts.end(),
                       [](const Attempt& a, const Attempt& b) { return a.distance < b.distance; });
  return {plan.vocabulary, best->canvas.letters()};
}

}  // namespace latticeworld
