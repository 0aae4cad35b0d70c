// Reading about agents: shares of those who are named with them ("half of the ten sheep").

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"
#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace internal {

Fraction AgentDiscourse::FractionAt(std::size_t at) const {
  if (noted_.IsWord(at, "half")) return {1, 2, 1};
  const NumberMatch number = MatchNumber(tokens_, at);
  if (number.tokens != 1 && !noted_.IsAnyWord(at, {"a", "one"})) return {};
  const int parts = number.tokens == 1 ? number.value : 1;
  int of = noted_.IsAnyWord(at + 1, {"quarter", "quarters"}) ? 4 : OrdinalAt(at + 1);
  if (noted_.IsWord(at + 1, "half")) of = 2;
  if (of < 2 || noted_.IsWord(at + 1, "second") || parts >= of) return {};
  return {parts, of, 2};
}

Count AgentDiscourse::VaguePartAt(std::size_t at, int whole) const {
  const std::size_t few = noted_.IsWord(at, "a") ? 1 : 0;
  const int most = std::max(1, whole - 1);
  Count part;
  if (few == 0 && noted_.IsWord(at, "most") && !noted_.IsWord(at + 1, "part")) {
    part = {whole / 2 + 1, (whole * 2 + 2) / 3, most, 1};
  } else if (few == 0 && noted_.IsWord(at, "many")) {
    part = {whole / 3, (whole * 2 + 2) / 3, most, 1};
  } else if (few == 0 && noted_.IsAnyWord(at, {"some", "part"})) {
    part = {2, (whole + 2) / 3, most, 1};
  } else if (few == 0 && noted_.IsWord(at, "several")) {
    part = {3, (whole + 2) / 3, most, 1};
  } else if (noted_.IsWord(at + few, "few")) {
    part = {2, (whole + 3) / 4, whole / 2, few + 1};
  } else {
    return {};
  }
  part.value = std::clamp(part.value, 1, most);
  part.least = std::clamp(part.least, 1, part.value);
  part.most = std::clamp(part.most, part.value, most);
  return part;
}

std::size_t AgentReader::ReadPartOfCounted() {
  if (pending_.tokens > 0 || noted_.notes[at_].negated) return 0;
  // "One group of 500 sheep. One of 400 goblins."
  if (noted_.IsAnyWord(at_, {"one", "another", "two"}) && noted_.IsWord(at_ + 1, "of") &&
      MatchNumber(tokens_, at_ + 2).tokens > 0 &&
      NounAhead(at_ + 2 + MatchNumber(tokens_, at_ + 2).tokens)) {
    Known(2);
    return 2;
  }
  // "most of the twenty sheep"
  const std::size_t vague = VaguePartAt(at_, 2).tokens;
  const Fraction fraction = vague > 0 ? Fraction{1, 1, vague} : FractionAt(at_);
  // "all but one of the five sheep"
  const bool all_but = noted_.IsWord(at_, "all") &&
                       noted_.IsAnyWord(at_ + 1, {"but", "except", "save", "bar", "barring"});
  const std::size_t first = all_but ? at_ + 2 : at_;
  const Count part =
      fraction.tokens > 0 ? Count{0, 0, 0, fraction.tokens} : ReadCount(noted_, words_, first);
  std::size_t next = first + part.tokens;
  if (part.tokens == 0 || part.least != part.most) return 0;
  if (noted_.IsWord(next, "of")) {
    ++next;
  } else if (!noted_.IsWord(at_, "half")) {
    return 0;
  }
  if (!noted_.IsAnyWord(next, {"the", "my", "our", "these", "those", "all"})) return 0;
  ++next;
  const Count whole = next < tokens_.size() ? ReadCount(noted_, words_, next) : Count{};
  if (whole.tokens == 0 || whole.least != whole.most || whole.value < 2 ||
      part.value >= whole.value || !NounAhead(next + whole.tokens)) {
    return 0;
  }
  int taken = all_but ? whole.value - part.value : part.value;
  if (fraction.tokens > 0) {
    taken = (CappedProduct(whole.value, fraction.parts) + fraction.of / 2) / fraction.of;
  }
  part_of_ = vague > 0 ? VaguePartAt(at_, whole.value) : Count{taken, taken, taken, 1};
  for (std::size_t i = at_; all_but && i < tokens_.size() && !noted_.IsEnd(i); ++i) {
    noted_.notes[i].negated = false;
  }
  // "only one of the four eagles is in the air": the others are not.
  const bool only = noted_.IsAnyWord(at_, {"only", "just"}) ||
                    (at_ > 0 && noted_.IsAnyWord(at_ - 1, {"only", "just"}));
  all_but_ = all_but || only;
  noted_.Mark(at_, next, &TokenNote::agent);
  return next - at_;
}

std::size_t AgentDiscourse::WholeOf(const std::vector<std::size_t>& groups, int part) const {
  std::size_t whole = kNone;
  for (const std::size_t index : groups) {
    const AgentWish& wish = groups_[index].wish;
    const bool fits = wish.counted && wish.quantity > std::max(1, part);
    if (fits && (whole == kNone || whole != rest_)) whole = index;
  }
  return whole;
}

std::size_t AgentReader::ReadPartOfNamed() {
  if (pending_.tokens > 0 || noted_.notes[at_].negated) return 0;
  const Fraction fraction = FractionAt(at_);
  const std::size_t vague = VaguePartAt(at_, 2).tokens;
  // "all but one of the sheep"
  const bool all_but =
      noted_.IsWord(at_, "all") && noted_.IsAnyWord(at_ + 1, {"but", "except", "save", "bar"});
  const std::size_t first = at_ + (all_but ? 2 : 0);
  Count part = fraction.tokens > 0 || vague > 0 ? Count{} : ReadCount(noted_, words_, first);
  std::size_t noun = first + std::max({vague, fraction.tokens, part.tokens});
  if (noun == first || part.least != part.most) return 0;
  if (noted_.IsWord(noun, "of")) {
    ++noun;
  } else if (!noted_.IsWord(at_, "half")) {
    return 0;
  }
  if (!noted_.IsAnyWord(noun, {"the", "my", "our", "these", "those", "your"})) return 0;
  ++noun;
  const auto match = words_.species.At(tokens_, noun);
  if (match.tokens == 0) return 0;
  const std::size_t end = noun + match.tokens;
  const std::size_t whole = WholeOf(GroupsOf(*match.rows.front(), noun, end), part.value);
  if (whole == kNone) return 0;
  const int quantity = groups_[whole].wish.quantity;
  if (vague > 0) part = VaguePartAt(at_, quantity);
  int taken = part.value;
  if (fraction.tokens > 0) {
    // "a third of the drones ..., two thirds of the drones": of all of them.
    const int all = whole == rest_ && part_ != kNone ? whole_quantity_ : quantity;
    taken = (CappedProduct(all, fraction.parts) + fraction.of / 2) / fraction.of;
  }
  if (all_but) taken = quantity - part.value;
  for (std::size_t i = at_; all_but && !noted_.IsEnd(i); ++i) noted_.notes[i].negated = false;
  noted_.Mark(at_, end, &TokenNote::agent);
  if (last_ != whole) part_ = rest_ = kNone;
  last_ = whole;
  Split(all_but ? Count{} : part, std::clamp(taken, 1, quantity), end - at_);
  if (all_but) groups_[rest_].unlike = part_;
  joined_ = paused_ = acted_ = clause_open_ = false;
  return end - at_ + RenamePart(end);
}

}  // namespace internal

}  // namespace latticeworld
