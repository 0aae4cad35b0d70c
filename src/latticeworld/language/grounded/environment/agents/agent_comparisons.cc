// Reading about agents: counts by comparison with other groups, and for each of two sides.

#include <algorithm>
#include <array>
#include <string_view>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"
#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace internal {
namespace {

constexpr std::size_t kToMeasure_tokens = 6;  // from "as many" to the group it is measured by

Count Exactly(int value, std::size_t tokens) { return {value, value, value, tokens}; }

}  // namespace

Count AgentReader::ReadComparedCount() {
  std::size_t next = at_;
  int times = 1;
  bool half = false;
  bool number_of_those = false;
  constexpr std::array<std::string_view, 5> kTimes = {"twice", "double", "thrice", "triple",
                                                      "half"};
  constexpr std::array<int, 5> kFactors = {2, 2, 3, 3, 1};
  for (std::size_t i = 0; i < kTimes.size(); ++i) {
    if (!noted_.IsWord(at_, kTimes[i])) continue;
    times = kFactors[i];
    half = kTimes[i] == "half";
    next = at_ + 1;
  }
  const NumberMatch number = MatchNumber(tokens_, at_);
  if (next == at_ && number.tokens > 0 && noted_.IsWord(at_ + number.tokens, "times")) {
    times = number.value;
    next = at_ + number.tokens + 1;
  }
  while (noted_.IsAnyWord(next, {"just", "exactly", "equally", "the", "an", "again"})) ++next;
  if (noted_.IsWord(next, "as") && noted_.IsWord(next + 1, "many")) {
    next += 2;
    // "as many sheep as possible", "as many as fit on the road"
    for (std::size_t i = next; i < next + kToMeasure_tokens && !noted_.IsEnd(i); ++i) {
      if (noted_.IsWord(i, "as") &&
          noted_.IsAnyWord(i + 1, {"possible", "you", "we", "i", "can", "could", "fit", "fits",
                                   "will", "feasible", "needed", "necessary"})) {
        return {};
      }
    }
    // "as many as twenty" is a bound.
    if (noted_.IsWord(next, "as") && ReadCount(noted_, words_, next + 1).tokens > 0) return {};
  } else if (noted_.IsAnyWord(next, {"same", "equal", "identical"}) &&
             noted_.IsAnyWord(next + 1, {"number", "count", "amount"})) {
    next += noted_.IsWord(next + 2, "of") ? 3 : 2;
  } else if (next > at_ && noted_.IsAnyWord(next, {"that", "this", "their"}) &&
             noted_.IsAnyWord(next + 1, {"number", "many"})) {
    // "goblins, three times that number", "half that number of knights"
    next += noted_.IsWord(next + 2, "of") ? 3 : 2;
    number_of_those = true;
  } else if (next > at_ && noted_.IsWord(next - 1, "equally") && noted_.IsWord(next, "many")) {
    ++next;
  } else if (next > at_ && noted_.IsWord(next, "number") && times > 1) {
    next += noted_.IsWord(next + 1, "of") ? 2 : 1;
  } else {
    return {};
  }
  std::size_t measure = MeasureAhead(next);
  if (measure == kNone) {
    for (std::size_t i = groups_.size(); i > 0 && measure == kNone; --i) {
      const AgentWish& wish = groups_[i - 1].wish;
      // "about 30 goblins"
      const bool rough = wish.quantity > 1 && wish.least > kSomeSeen.least &&
                         wish.least < wish.most && wish.most <= kMaxAgents;
      const bool itself = i - 1 == last_ && !wish.counted && !rough;
      const bool known = !number_of_those || wish.counted || rough;
      if (!groups_[i - 1].removed && !itself && known) measure = i - 1;
    }
  }
  if (measure == kNone) {
    // "Goblins, twice as many knights": nobody knows how many, and not "many".
    Count some = kSomeSeen;
    some.tokens = next - at_;
    return NounAhead(next) && !number_of_those ? some : Count{};
  }
  // "sheep: twice as many as eagles"
  while (next < tokens_.size() && noted_.notes[next].ignored) ++next;
  const AgentWish& wish = groups_[measure].wish;
  const auto so_many = [&](int whole) {
    return std::max(1, half ? whole / 2 : std::min(kMaxAgents, CappedProduct(whole, times)));
  };
  if (wish.counted || wish.least <= kSomeSeen.least || wish.most > kMaxAgents) {
    return Exactly(so_many(wish.quantity), next - at_);
  }
  return {so_many(wish.least), so_many(wish.quantity), so_many(wish.most), next - at_};
}

std::size_t AgentReader::MeasureAhead(std::size_t at) {
  for (std::size_t i = at; i < at + kToMeasure_tokens && !noted_.IsEnd(i); ++i) {
    if (!noted_.IsWord(i, "as")) continue;
    std::size_t noun = i + 1;
    while (noted_.IsAnyWord(noun, {"there", "are", "the", "of"})) ++noun;
    const auto match = words_.species.At(tokens_, noun);
    if (match.tokens == 0) return kNone;
    const std::vector<std::size_t> same = GroupsOf(*match.rows.front(), noun, noun + match.tokens);
    if (same.empty()) return kNone;
    noted_.Mark(i, noun + match.tokens, &TokenNote::ignored);
    return same.back();
  }
  return kNone;
}

std::size_t AgentReader::ReadCountsOfSides() {
  const Count first = pending_.tokens > 0 ? Count{} : ReadCount(noted_, words_, at_);
  if (first.tokens == 0 || last_ == kNone) return 0;
  std::size_t next = at_ + first.tokens;
  // Groups that wait for their counts.
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    if (!groups_[i].removed && !groups_[i].wish.counted) open.push_back(i);
  }
  if (open.size() < 2) return 0;
  Count second;
  if (noted_.IsAnyWord(next, {"against", "vs", "vs.", "versus", "v"})) {
    second = ReadCount(noted_, words_, next + 1);
    if (second.tokens == 0 || NounAhead(next + 1 + second.tokens)) return 0;
    next += 1 + second.tokens;
    open.erase(open.begin(), open.end() - 2);
  } else if (noted_.IsWord(next, "and") && open.size() == 2) {
    // "goblins and knights, 25 and 15 respectively"
    second = ReadCount(noted_, words_, next + 1);
    if (second.tokens == 0 || !noted_.IsWord(next + 1 + second.tokens, "respectively")) return 0;
    next += 2 + second.tokens;
  } else {
    if (noted_.IsAnyWord(next, {"each", "apiece", "aside"})) {
      ++next;
    } else if (noted_.IsWord(next, "of") && noted_.IsWord(next + 1, "each")) {
      next += noted_.IsAnyWord(next + 2, {"kind", "sort", "type", "species"}) ? 3 : 2;
    } else if (noted_.IsAnyWord(next, {"on", "per", "to", "for", "a", "in"})) {
      while (noted_.IsAnyWord(
          next, {"on", "per", "to", "for", "a", "in", "each", "every", "either", "both"})) {
        ++next;
      }
      if (!noted_.IsAnyWord(next, {"side", "sides", "team", "party", "army", "band", "group"})) {
        return 0;
      }
      ++next;
    } else {
      return 0;
    }
    std::vector<std::size_t> here;
    for (const std::size_t i : open) {
      if (groups_[i].sentence + 1 >= sentence_) here.push_back(i);
    }
    if (here.size() < 2) return 0;
    open = here;
    second = first;
  }
  for (std::size_t i = 0; i < open.size(); ++i) {
    SetCount(i == 0 ? first : second, &groups_[open[i]]);
    Extend(open[i], tokens_[next - 1].end);
  }
  noted_.Mark(at_, next, &TokenNote::agent);
  subject_ = open;
  previous_ = open;
  joined_ = paused_ = acted_ = false;
  return next - at_;
}

std::size_t AgentReader::ReadLikewise() {
  const std::vector<std::size_t>& told = subject_.empty() ? previous_ : subject_;
  if (told.empty()) return 0;
  // "the farmers are in the fields, the sheep, too"
  const std::size_t too = noted_.IsWord(at_, "too") ? 1 : 0;
  const std::size_t well = noted_.IsWord(at_, "as") && noted_.IsWord(at_ + 1, "well") ? 2 : 0;
  if (too + well > 0 && noted_.IsPause(at_ + too + well) && !subject_.empty()) {
    std::size_t model = subject_.front();
    while (model > 0 && (model == subject_.front() || groups_[model].removed)) --model;
    for (const std::size_t index : subject_) {
      if (model >= index || groups_[index].wish.IsPlaced()) continue;
      if (!groups_[index].wish.state.has_value()) {
        groups_[index].wish.state = groups_[model].wish.state;
      }
      if (groups_[index].with == kNone) groups_[index].with = model;
    }
    Known(too + well);
    return too + well;
  }
  std::size_t next = at_;
  if (noted_.IsAnyWord(at_, {"so", "as"}) &&
      noted_.IsAnyWord(at_ + 1, {"do", "does", "are", "is"})) {
    next = at_ + 2;
  } else if (noted_.IsWord(at_, "likewise")) {
    next = at_ + 1;
  }
  if (next == at_) return 0;
  const std::size_t count = ReadCount(noted_, words_, next).tokens;
  if (count == 0 && !noted_.IsAnyWord(next, {"a", "an", "the", "some"}) &&
      words_.species.LengthAt(tokens_, next) == 0) {
    return 0;
  }
  model_ = told.back();
  Known(next - at_);
  return next - at_;
}

std::size_t AgentReader::ReadEachHas() {
  if (!noted_.IsAnyWord(at_, {"each", "every"}) || noted_.notes[at_].negated) return 0;
  std::size_t next = at_ + 1;
  if (noted_.IsWord(next, "one")) ++next;
  next += next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
  while (noted_.IsAnyWord(next, {"is", "are", "being"})) ++next;
  std::size_t verb = 0;
  if (noted_.IsAnyWord(next, {"with", "has", "have", "having", "leads", "leading", "rides",
                              "carrying", "carries", "brings", "keeps"})) {
    verb = 1;
  }
  if (noted_.IsAnyWord(next, {"accompanied", "followed", "escorted", "flanked", "joined"}) &&
      noted_.IsWord(next + 1, "by")) {
    verb = 2;
  }
  const std::vector<std::size_t> owners = subject_.empty() ? previous_ : subject_;
  if (verb == 0 || owners.empty() ||
      !(NounAhead(next + verb) || ReadCount(noted_, words_, next + verb).tokens > 0))
    return 0;
  subject_ = owners;
  times_ = TotalOf(owners);
  joined_ = true;
  paused_ = false;
  Known(next + verb - at_);
  return next + verb - at_;
}

}  // namespace internal

}  // namespace latticeworld
