// Reading about agents: parts of a group, and what is left of it.

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"
#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace internal {

std::size_t AgentReader::ReadRestOfTotal(std::size_t at) {
  while (noted_.IsAnyWord(at, {"are", "is", "being", "should", "be"})) ++at;
  if (noted_.IsPause(at) || words_.species.LengthAt(tokens_, at) == 0) return 0;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const AgentWish& total = groups_[i].wish;
    if (groups_[i].removed || !total.counted || total.categories.size() < 2) continue;
    // Those who were left when others were split off are told by themselves.
    const bool all = total.categories.size() == EnumNames(AgentCategory{}).size();
    if (groups_[i].taken > 0 && !all) continue;
    int left = total.quantity + groups_[i].taken;
    for (std::size_t j = i + 1; j < groups_.size(); ++j) {
      if (!groups_[j].removed) left -= groups_[j].wish.quantity;
    }
    if (left <= 0) continue;
    pending_ = {left, left, left, at - at_};
    count_at_ = at_;
    phrase_begin_ = std::min(phrase_begin_, tokens_[at_].begin);
    return at - at_;
  }
  return 0;
}

std::size_t AgentReader::ReadAllBut() {
  if (!noted_.IsAnyWord(at_, {"all", "everyone", "everybody", "every"})) return 0;
  std::size_t next = at_ + 1;
  if (noted_.IsWord(next, "one")) ++next;
  next += next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
  if (!noted_.IsAnyWord(next, {"but", "except", "save", "bar"})) return 0;
  ++next;
  if (noted_.IsWord(next, "for")) ++next;
  const Count left = ReadCount(noted_, words_, next);
  Group* whole = Last();
  if (left.tokens == 0 || left.least != left.most || whole == nullptr) return 0;
  next += left.tokens;
  next += next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
  if (whole->wish.quantity <= left.value || !EndsNounPhrase(next)) return 0;
  for (std::size_t i = at_; i < next; ++i) noted_.notes[i].negated = false;
  noted_.Mark(at_, next, &TokenNote::agent);
  const int most = whole->wish.quantity - left.value;
  Split({most, most, most, next - at_}, most, next - at_);
  groups_[rest_].unlike = part_;
  return next - at_;
}

std::size_t AgentReader::ReadExceptSome() {
  if (!noted_.IsAnyWord(at_, {"except", "but", "save", "excepting", "bar", "barring"}) ||
      Last() == nullptr) {
    return 0;
  }
  std::size_t next = at_ + 1;
  if (noted_.IsWord(next, "for")) ++next;
  const Count count = ReadCount(noted_, words_, next);
  if (count.tokens == 0 || count.least != count.most) return 0;
  next += count.tokens;
  next += next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
  // "..., except two rovers that are parked"
  const auto named = words_.species.At(tokens_, next);
  if (named.tokens > 0 && !noted_.IsPause(next)) {
    const std::vector<std::size_t> same = GroupsOf(*named.rows.front(), next, next + named.tokens);
    if (same.empty()) return 0;
    next += named.tokens;
    last_ = same.back();
  }
  const bool alone = noted_.IsPause(next) || noted_.IsAnyWord(next, {"which", "who", "that"});
  if (!alone || count.value >= groups_[last_].wish.quantity) return 0;
  for (std::size_t i = at_; i < tokens_.size() && !noted_.IsEnd(i); ++i) {
    noted_.notes[i].negated = false;
  }
  noted_.Mark(at_, next, &TokenNote::agent);
  Split(count, count.value, next - at_);
  groups_[part_].wish.state.reset();
  // "..., which has landed on the bridge", but "..., which just stands around".
  if (tokens_[std::min(next, tokens_.size() - 1)].kind == TokenKind::kComma &&
      IsPlaceAhead(next + 1)) {
    groups_[part_].wish.ForgetPlace();
    groups_[part_].with = kNone;
  }
  return next - at_;
}

std::size_t AgentReader::ReadFraction() {
  if (pending_.tokens > 0) return 0;
  int parts = 1, of = 2;
  std::size_t next = at_;
  std::size_t said = RoleAt(Role::kHalf, at_);  // "half of the herd"
  if (said > 0) {
    next = at_ + said;
  } else {
    // "half asleep"
    if (words_.states.LengthAt(tokens_, at_) > 1) return 0;
    const bool article = noted_.IsAnyWord(at_, {"a", "an", "one", "another"});
    const NumberMatch number = MatchNumber(tokens_, at_);
    if (noted_.IsAnyWord(at_, {"the", "other"}) && noted_.IsWord(at_ + 1, "half")) return 0;
    if (article) {
      next = at_ + 1;
    } else if (number.tokens == 1) {
      parts = number.value;
      next = at_ + 1;
    }
    if (noted_.IsAnyWord(next, {"half", "halves"})) {
      of = 2;
    } else if (noted_.IsAnyWord(next, {"quarter", "quarters"})) {
      of = 4;
    } else {
      of = OrdinalAt(next);
      if (of < 3 || next == at_) return 0;
    }
    ++next;
    said = next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
    next += said;
    // "half is", "half in the north"; "a third is parked" is one of them.
    const bool plural = noted_.IsAnyWord(next, {"are", "should", "will", "were", "have"});
    const bool half = of == 2 && !noted_.IsPause(next) && EndsNounPhrase(next);
    // "one third over the lake", "two thirds asleep"; "a third over the lake" is one more.
    const bool share =
        (noted_.IsWord(at_, "one") || parts > 1) && !noted_.IsPause(next) && EndsNounPhrase(next);
    if (said == 0 && !half && !share && !(plural && parts < of)) return 0;
    if (said == 0 && of == 2 && noted_.IsWord(next, "of")) return 0;
    // "half that number"
    if (noted_.IsWord(next, "that") && noted_.IsAnyWord(next + 1, {"number", "many"})) return 0;
  }
  Group* whole = Last();
  if (parts >= of) return 0;
  const bool is_rest = part_ != kNone && rest_ == last_;
  if (last_ == kNone || (whole == nullptr && !is_rest)) return 0;
  if (part_ == kNone || whole_quantity_ == 0) whole_quantity_ = groups_[last_].wish.quantity;
  noted_.Mark(at_, next, &TokenNote::agent);
  // The second half, or the third third, is what the others left.
  const int left = groups_[last_].wish.quantity;
  int quantity = (CappedProduct(whole_quantity_, parts) + of / 2) / of;
  if (of == 2) quantity = is_rest ? left : (whole_quantity_ + 1) / 2;
  quantity = std::clamp(quantity, 1, std::max(1, left));
  if (is_rest && left - quantity == 1 && of == 3) quantity = left;
  const int whole_quantity = whole_quantity_;
  Split({}, quantity, next - at_);
  whole_quantity_ = whole_quantity;
  clause_open_ = false;
  return next - at_ + RenamePart(next);
}

std::size_t AgentReader::ReadUnit() {
  if (last_ == kNone || !noted_.IsAnyWord(at_, {"in", "as", "into", "forming"})) return 0;
  if (groups_[last_].wish.quantity < 2) return 0;
  std::size_t next = at_ + 1;
  if (noted_.IsPause(next)) return 0;
  const NumberMatch groups = MatchNumber({tokens_[next]}, 0);
  if (ReadCollective(noted_, words_, next).tokens == 0) next += groups.tokens;
  while (noted_.IsAnyWord(next, {"equal", "small", "separate", "different"})) ++next;
  const Count pack = ReadCollective(noted_, words_, next);
  if (pack.tokens == 0) return 0;
  const bool plural = Singular(tokens_[next].text) != tokens_[next].text;
  if (!plural && groups.tokens == 0) return 0;
  next += 1;
  int unit = pack.least == pack.most ? pack.value / (plural ? 2 : 1) : 0;
  if (noted_.IsWord(next, "of")) {
    const Count each = ReadCount(noted_, words_, next + 1);
    if (each.tokens == 0 || !EndsNounPhrase(next + 1 + each.tokens)) return 0;
    unit = each.value;
    next += 1 + each.tokens;
    noted_.IsWord(next, "each") ? ++next : next;
  } else if (unit == 0 && groups.tokens > 0) {
    unit = groups_[last_].wish.quantity / std::max(1, groups.value);
  }
  if (unit < 1 || unit > groups_[last_].wish.quantity) return 0;
  unit_ = unit;
  noted_.Mark(at_, next, &TokenNote::agent);
  return next - at_;
}

int AgentDiscourse::OrdinalAt(std::size_t at) const {
  constexpr std::string_view kOrdinals[] = {"first", "second",  "third",  "fourth", "fifth",
                                            "sixth", "seventh", "eighth", "ninth",  "tenth"};
  for (std::size_t i = 0; i < std::size(kOrdinals); ++i) {
    if (noted_.IsWord(at, kOrdinals[i]) ||
        (i > 1 && noted_.IsWord(at, std::string(kOrdinals[i]) + "s"))) {
      return static_cast<int>(i) + 1;
    }
  }
  return 0;
}

std::size_t AgentReader::ReadOrdinal() {
  if (last_ == kNone || pending_.tokens > 0) return 0;
  const bool definite = noted_.IsAnyWord(at_, {"the", "their"});
  if (!definite && !noted_.IsWord(at_, "a")) return 0;
  const bool last = definite && noted_.IsAnyWord(at_ + 1, {"last", "final"});
  const int ordinal = OrdinalAt(at_ + 1);
  std::size_t next = at_ + 2;
  // "the first group" is one of those that were named, unless there is only one.
  const bool group = noted_.IsAnyWord(next, {"group", "team", "herd", "flock", "band", "squad"});
  if (group && unit_ == 1 && !last) return 0;
  if (group || noted_.IsAnyWord(next, {"one", "pair", "trio"})) ++next;
  const bool bare_last = last && part_ != kNone && !noted_.IsPause(next);
  // "a seventh, who is braver, runs"
  const bool aside = noted_.IsAnyWord(next + 1, {"who", "which"});
  if ((ordinal == 0 && !bare_last) || (noted_.IsPause(next) && !aside)) return 0;
  if (!EndsNounPhrase(next) && !(bare_last && MatchPlace(tokens_, next).tokens > 0)) return 0;
  noted_.Mark(at_, next, &TokenNote::agent);
  if (last) {
    TakeRest({});
    Extend(last_, tokens_[next - 1].end);
    return next - at_;
  }
  // One of those who were counted, or one that comes on top of them.
  const bool among = definite && groups_[last_].wish.quantity > 1 &&
                     (part_ != kNone || groups_[last_].wish.quantity >= ordinal);
  if (among) {
    Split({}, unit_, next - at_);
  } else if (rest_ == last_ && groups_[last_].wish.quantity == 1 && part_ != kNone) {
    TakeRest({});
  } else {
    AddLike(last_, {unit_, unit_, unit_, next - at_}, next - at_);
  }
  return next - at_;
}

std::size_t AgentReader::RenamePart(std::size_t at) {
  const std::size_t renamed = Rename(part_, at);
  if (renamed > 0 && rest_ != kNone) LeaveOthers();
  // "Eleven sheep, three of them lambs, doze": all of them do.
  const std::size_t next = at + renamed;
  if (renamed > 0 && next + 1 < tokens_.size() && tokens_[next].kind == TokenKind::kComma &&
      words_.states.LengthAt(tokens_, next + 1) > 0 && !IsDoing(next + 1)) {
    subject_ = {rest_, part_};
    previous_ = subject_;
  }
  return renamed;
}

void AgentReader::LeaveOthers() {
  Group& rest = groups_[rest_];
  const AgentWish& part = groups_[part_].wish;
  const std::size_t kinds = rest.wish.categories.size();
  if (kinds < 2 || !Contains(rest.wish.categories, part.categories)) return;
  rest.taken += part.quantity;
  // Agents of all kinds are told by their number only.
  if (kinds == EnumNames(AgentCategory{}).size() || part.categories.size() >= kinds) return;
  std::vector<AgentCategory>& others = rest.wish.categories;
  others.erase(
      std::remove_if(others.begin(), others.end(),
                     [&](AgentCategory category) { return Contains(part.categories, {category}); }),
      others.end());
}

std::size_t AgentReader::Rename(std::size_t index, std::size_t at) {
  const std::size_t first = at;
  while (noted_.IsAnyWord(at, {"are", "is", "should", "be", "being", "must"})) ++at;
  if (noted_.IsPause(at) || index == kNone) return 0;
  const auto match = words_.species.At(tokens_, at);
  if (match.tokens == 0 || IsVerbHere(at, true) || noted_.notes[at].negated) return 0;
  Group& group = groups_[index];
  // "nine of them guard the bridge"
  const bool verb = at == first && words_.states.LengthAt(tokens_, at) > 0;
  const bool several = group.wish.quantity > 1;
  if (verb && !(several ? match.rows.front()->plural : match.rows.front()->singular)) return 0;
  group.wish.categories = match.rows.front()->categories;
  group.wish.exact = match.rows.front()->exact;
  group.wish.name = JoinWords(tokens_, at, at + match.tokens);
  group.end = std::max(group.end, tokens_[at + match.tokens - 1].end);
  noted_.Mark(at, at + match.tokens, &TokenNote::agent);
  return at + match.tokens - first;
}

void AgentReader::Split(const Count& count, int quantity, std::size_t tokens) {
  const std::size_t whole = last_;
  if (whole == kNone) return;
  quantity = std::max(1, quantity);
  if (part_ == kNone) whole_quantity_ = groups_[whole].wish.quantity;
  Group part = groups_[whole];
  // "half hide in the forest and half in the fields": they hide there, too.
  if (part_ != kNone && rest_ == whole && groups_[part_].sentence == sentence_ &&
      !part.wish.state.has_value() && !noted_.IsAnyWord(at_ + tokens, {"are", "is"})) {
    part.wish.state = groups_[part_].wish.state;
  }
  Group& rest = groups_[whole];
  part.wish.quantity = quantity;
  part.wish.least = count.tokens > 0 ? count.least : quantity;
  part.wish.most = count.tokens > 0 ? count.most : quantity;
  if (part.wish.least > quantity || part.wish.most < quantity) {
    part.wish.least = part.wish.most = quantity;
  }
  if (!rest.wish.counted && count.tokens == 0) {
    part.wish.least = std::min(quantity, std::max(1, rest.wish.least / 3));
    part.wish.most = std::max(part.wish.quantity, rest.wish.most);
  }
  part.begin = tokens_[at_].begin;
  part.end = tokens_[std::min(at_ + tokens, tokens_.size()) - 1].end;
  part.sentence = sentence_;
  part.removed = false;
  part.inherited = true;
  rest.wish.quantity -= quantity;
  rest.wish.least = std::max(0, rest.wish.least - part.wish.most);
  rest.wish.most = std::max(rest.wish.quantity, rest.wish.most - part.wish.least);
  if (rest.wish.quantity <= 0) rest.removed = true;
  split_state_ = true;
  rest_ = whole;
  groups_.push_back(std::move(part));
  subject_ = {groups_.size() - 1};
  previous_ = subject_;
  part_ = groups_.size() - 1;
}

void AgentReader::TakeRest(const Count& count) {
  const std::size_t rest = rest_ != kNone ? rest_ : last_;
  if (rest == kNone) return;
  Group& group = groups_[rest];
  if (count.tokens > 0) {
    group.wish.least = count.least;
    group.wish.quantity = count.value;
    group.wish.most = count.most;
  }
  if (group.wish.quantity <= 0) return;
  group.removed = false;
  // "Ninety goblins attack. ..., the other half sleep."
  split_state_ = true;
  subject_ = {rest};
  previous_ = subject_;
}

Group* AgentReader::Last() {
  return last_ == kNone || groups_[last_].wish.quantity < 2 ? nullptr : &groups_[last_];
}

}  // namespace internal

}  // namespace latticeworld
