#include "latticeworld/generation/fidelity/reading_difference.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/layout_mask.h"

namespace latticeworld {
namespace {

// That there is something, how much and where: "a lake in the north", "the lake is in the north".
bool IsOfPresence(ClaimKind kind) {
  constexpr ClaimKind kKinds[] = {ClaimKind::kPresent, ClaimKind::kAmount,   ClaimKind::kDominant,
                                  ClaimKind::kLocated, ClaimKind::kMoreThan, ClaimKind::kRest};
  return std::find(std::begin(kKinds), std::end(kKinds), kind) != std::end(kKinds);
}

// Whether it is the same to say it of the object and the subject.
bool IsMutual(ClaimKind kind) {
  constexpr ClaimKind kKinds[] = {ClaimKind::kAdjacent, ClaimKind::kApart, ClaimKind::kCrosses,
                                  ClaimKind::kParallel};
  return std::find(std::begin(kKinds), std::end(kKinds), kind) != std::end(kKinds);
}

bool Overlap(const Zone& a, const Zone& b) {
  return a.is_anywhere() || b.is_anywhere() || !(MaskOf(a) & MaskOf(b)).empty();
}

// Bounds that are not said are none.
bool Overlap(double least, double most, double other_least, double other_most) {
  const auto lower = [](double bound) { return bound == Claim::kUnsaid ? 0.0 : bound; };
  return lower(least) <= other_most && lower(other_least) <= most;
}

// Either may leave open which ones.
template <typename T>
bool Overlap(const std::vector<T>& some, const std::vector<T>& others) {
  return some.empty() || others.empty() ||
         std::find_first_of(some.begin(), some.end(), others.begin(), others.end()) != some.end();
}

// Whether what the claim asks for the other one asks for too.
bool IsAskedBy(const Claim& a, const Claim& b) {
  // Where a line runs it is.
  if (a.kind == ClaimKind::kPresent && b.kind == ClaimKind::kCourse) return a.subject == b.subject;
  if (IsOfPresence(a.kind) && IsOfPresence(b.kind)) {
    return a.subject == b.subject && Overlap(a.zone, b.zone);
  }
  const bool straight = a.subject == b.subject && a.object == b.object;
  const bool turned = a.subject == b.object && a.object == b.subject;
  if (a.kind != b.kind) return false;
  if (a.kind == ClaimKind::kDirection && turned && !straight) {
    return a.heading == Claim::Heading{-b.heading.east, -b.heading.south};
  }
  if (!straight && !(turned && IsMutual(a.kind))) return false;
  if (!Overlap(a.zone, b.zone)) return false;
  switch (a.kind) {
    case ClaimKind::kCount:
      return Overlap(a.least, a.most, b.least, b.most);
    case ClaimKind::kShape:
      return a.shape == b.shape;
    case ClaimKind::kOrder:
      return a.sequence == b.sequence && a.heading == b.heading;
    case ClaimKind::kDirection:
      return a.heading == b.heading;
    default:
      return true;
  }
}

bool IsAskedBy(const EnvironmentClaim& a, const EnvironmentClaim& b) {
  if (a.kind != b.kind || a.coarse_key != b.coarse_key || a.asset != b.asset ||
      a.variant_key != b.variant_key || a.parameter_key != b.parameter_key) {
    return false;
  }
  return Overlap(a.values, b.values) && Overlap(a.least, a.most, b.least, b.most) &&
         Overlap(a.categories, b.categories) && Overlap(a.states, b.states) &&
         Overlap(a.positions, b.positions) &&
         Overlap(a.least_quantity, a.most_quantity, b.least_quantity, b.most_quantity);
}

// The words of claims that are to be told, each once, with what is said of the first claim of them.
class Told {
 public:
  explicit Told(const std::vector<std::string>& so_far) : so_far_(so_far) {}

  void Add(const std::string& words, const std::string& of_claim) {
    const std::string quote = Quote(words);
    const auto holds = [&quote](const std::string& text) {
      return text.find(quote) != std::string::npos;
    };
    if (std::any_of(so_far_.begin(), so_far_.end(), holds) ||
        std::any_of(told_.begin(), told_.end(), holds)) {
      return;
    }
    told_.push_back(quote + " (" + of_claim + ")");
  }

  // "what: ..."; empty: nothing is told.
  std::string Say(const std::string& what) const {
    if (told_.empty()) return "";
    constexpr std::size_t kMost = 5;
    const auto some = static_cast<std::ptrdiff_t>(std::min(kMost, told_.size()));
    const std::vector<std::string> first(told_.begin(), told_.begin() + some);
    const std::size_t more = told_.size() - first.size();
    return what + Join(first, ", ") + (more > 0 ? " and " + std::to_string(more) + " more" : "");
  }

 private:
  const std::vector<std::string>& so_far_;
  std::vector<std::string> told_;
};

template <typename AnyClaim, typename World>
void Compare(const std::vector<AnyClaim>& first, const std::vector<AnyClaim>& second,
             const World& world, Told* of_first, Told* of_second) {
  const auto asks = [](const std::vector<AnyClaim>& claims, const AnyClaim& claim) {
    return std::any_of(claims.begin(), claims.end(),
                       [&claim](const AnyClaim& other) { return IsAskedBy(claim, other); });
  };
  for (const AnyClaim& claim : first) {
    if (!asks(second, claim)) of_first->Add(claim.words, std::string(NameOf(claim.kind)));
  }
  for (const AnyClaim& claim : second) {
    const auto measure = Measure(claim, world);
    if (!measure.holds) {
      of_second->Add(claim.words, measure.explanation);
    } else if (!asks(first, claim)) {
      of_second->Add(claim.words, std::string(NameOf(claim.kind)));
    }
  }
}

}  // namespace

std::vector<std::string> DifferenceWarnings(const LayoutReading& layout_reading,
                                            const EnvironmentReading& environment_reading,
                                            const SymbolicLayout& layout,
                                            const EnvironmentConfig& environment,
                                            const std::vector<std::string>& so_far) {
  Told of_first(so_far);
  Told of_second(so_far);
  if (!layout_reading.second.empty()) {
    Compare(layout_reading.plan.claims, layout_reading.second, layout, &of_first, &of_second);
  }
  if (environment_reading.second) {
    Compare(ClaimsOf(environment_reading.heard, &layout),
            ClaimsOf(*environment_reading.second, &layout), environment, &of_first, &of_second);
  }
  std::vector<std::string> differing;
  for (const std::string& text :
       {of_first.Say("it does not ask for "), of_second.Say("it asks for ")}) {
    if (!text.empty()) differing.push_back(text);
  }
  if (differing.empty()) return {};
  return {"a second reading differs: " + Join(differing, "; ")};
}

}  // namespace latticeworld
