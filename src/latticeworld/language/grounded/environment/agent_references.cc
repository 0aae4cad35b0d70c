// Reading about agents: words that go back to groups named before.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agent_discourse.h"

namespace latticeworld {
namespace internal {

std::size_t AgentReader::ReadPartOfCounted() {
  if (pending_.tokens > 0 || noted_.notes[at_].negated) return 0;
  const bool half = noted_.IsWord(at_, "half");
  const Count part = half ? Count{0, 0, 0, 1} : ReadCount(noted_, words_, at_);
  std::size_t next = at_ + part.tokens;
  if (part.tokens == 0 || part.least != part.most) return 0;
  if (noted_.IsWord(next, "of")) {
    ++next;
  } else if (!half) {
    return 0;
  }
  if (!noted_.IsAnyWord(next, {"the", "my", "our", "these", "those", "all"})) return 0;
  ++next;
  const Count whole = next < tokens_.size() ? ReadCount(noted_, words_, next) : Count{};
  if (whole.tokens == 0 || whole.least != whole.most || whole.value < 2 ||
      part.value >= whole.value || !NounAhead(next + whole.tokens)) {
    return 0;
  }
  part_of_ = half ? (whole.value + 1) / 2 : part.value;
  noted_.Mark(at_, next, &TokenNote::agent);
  return next - at_;
}

std::size_t AgentReader::ReadReference() {
  if (const std::size_t part = ReadPartOfCounted(); part > 0) return part;
  if (groups_.empty() || noted_.notes[at_].negated) return 0;
  if (const std::size_t half = RoleAt(Role::kHalf, at_); half > 0) {
    Group* whole = Last();
    if (whole == nullptr) return 0;
    noted_.Mark(at_, at_ + half, &TokenNote::agent);
    // The second half is what the first one left.
    const bool second = rest_ == last_ && halved_ == last_;
    Split({}, second ? whole->wish.quantity : (whole->wish.quantity + 1) / 2, half);
    halved_ = rest_;
    return half + RenamePart(at_ + half);
  }
  if (const std::size_t some = RoleAt(Role::kSomeOfThem, at_); some > 0) {
    Group* whole = Last();
    if (whole == nullptr) return 0;
    noted_.Mark(at_, at_ + some, &TokenNote::agent);
    const bool most = noted_.IsAnyWord(at_, {"most", "many"});
    const int quantity = whole->wish.quantity;
    Split({}, most ? (quantity * 2 + 2) / 3 : (quantity + 2) / 3, some);
    return some;
  }
  if (const std::size_t all = ReadAllOfThem(); all > 0) return all;
  if (const std::size_t ordinal = ReadOrdinal(); ordinal > 0) return ordinal;
  if (const std::size_t again = ReadAnotherGroup(); again > 0) return again;
  // "Goblins? None, please."
  if (noted_.IsWord(at_, "none") && noted_.IsPause(at_ + 1) && last_ != kNone &&
      words_.assets.LengthAt(tokens_, at_ > 0 ? at_ - 1 : at_) == 0) {
    groups_[last_].removed = true;
    Known(1);
    return 1;
  }
  const std::size_t others = RoleAt(Role::kOthers, at_);
  if (others > 0) {
    // "the remaining five" counts along; "the other horses" is read as a noun phrase.
    const Count count =
        at_ + others < tokens_.size() ? ReadCount(noted_, words_, at_ + others) : Count{};
    const std::size_t next = at_ + others + count.tokens;
    const bool noun = next < tokens_.size() && words_.species.LengthAt(tokens_, next) > 0;
    if (const std::size_t left = ReadRestOfTotal(next); left > 0) return left;
    if (!noun && EndsNounPhrase(next)) {
      noted_.Mark(at_, next, &TokenNote::agent);
      TakeRest(count);
      return others + count.tokens;
    }
  }
  if (const std::size_t one = ReadFormerOrLatter(); one > 0) return one;
  if (noted_.IsAnyWord(at_, {"both", "all", "neither", "none"}) && at_ > 0 &&
      noted_.IsPause(at_ - 1) && at_ + 1 < tokens_.size() &&
      words_.states.LengthAt(tokens_, at_ + 1) > 0) {
    // "knights in the north, goblins in the south, all asleep"
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const bool named = std::find(subject_.begin(), subject_.end(), i) != subject_.end();
      if (groups_[i].sentence != sentence_ || groups_[i].removed || named) continue;
      subject_.push_back(i);
    }
    Known(1);
    return 1;
  }
  const std::size_t they = RoleAt(Role::kThey, at_);
  const bool it = noted_.IsWord(at_, "it") && previous_.size() == 1 && at_ + 1 < tokens_.size() &&
                  words_.states.LengthAt(tokens_, at_ + 1) > 0 &&
                  words_.coarse.LengthAt(tokens_, at_ + 1) == 0;
  if (they > 0 || it) {
    const std::size_t tokens = std::max<std::size_t>(they, 1);
    Known(tokens);
    // As an object ("chase them") a pronoun changes nothing.
    if (subject_.empty()) subject_ = previous_;
    return tokens;
  }
  return 0;
}

std::size_t AgentReader::ReadRestOfTotal(std::size_t at) {
  while (noted_.IsAnyWord(at, {"are", "is", "being", "should", "be"})) ++at;
  if (noted_.IsPause(at) || words_.species.LengthAt(tokens_, at) == 0) return 0;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const AgentWish& total = groups_[i].wish;
    if (groups_[i].removed || !total.counted || total.categories.size() < 2) continue;
    int left = total.quantity;
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

std::size_t AgentReader::ReadFormerOrLatter() {
  const bool former = noted_.IsAnyWord(at_, {"former", "first", "firsts"});
  if (!former && !noted_.IsAnyWord(at_, {"latter", "second", "last"})) return 0;
  const bool bare = noted_.IsAnyWord(at_, {"former", "latter"});
  const std::size_t group =
      noted_.IsAnyWord(at_ + 1, {"group", "ones", "band", "party", "lot", "team"}) ? 1 : 0;
  if (!bare && group == 0) return 0;
  // "the latter two", "the latter are"
  std::vector<std::size_t> named;
  for (std::size_t i = groups_.size(); i > 0 && named.size() < 2; --i) {
    if (!groups_[i - 1].removed) named.push_back(i - 1);
  }
  if (named.size() < 2) return 0;
  subject_ = {former ? named.back() : named.front()};
  previous_ = {named.back(), named.front()};
  joined_ = paused_ = acted_ = false;
  noted_.Mark(at_, at_ + 1 + group, &TokenNote::agent);
  return 1 + group;
}

std::size_t AgentReader::ReadAllOfThem() {
  const bool both = noted_.IsWord(at_, "both");
  if (!both && !noted_.IsWord(at_, "all")) return 0;
  const Count count = both ? Count{2, 2, 2, 0} : ReadCount(noted_, words_, at_ + 1);
  if (!both && (count.tokens == 0 || count.least != count.most)) return 0;
  std::size_t next = at_ + 1 + count.tokens;
  next += next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
  if (!EndsNounPhrase(next)) return 0;
  std::vector<std::size_t> named;
  int sum = 0;
  for (std::size_t i = groups_.size(); i > 0 && sum < count.value; --i) {
    const Group& group = groups_[i - 1];
    if (group.removed || group.wish.each) continue;
    sum += group.wish.quantity;
    named.insert(named.begin(), i - 1);
  }
  if (sum != count.value || named.size() < 2) return 0;
  noted_.Mark(at_, next, &TokenNote::agent);
  subject_ = named;
  previous_ = subject_;
  joined_ = paused_ = acted_ = false;
  return next - at_;
}

std::size_t AgentReader::ReadOrdinal() {
  if (last_ == kNone || !noted_.IsWord(at_, "the")) return 0;
  constexpr std::string_view kOrdinals[] = {"first", "second",  "third",  "fourth", "fifth",
                                            "sixth", "seventh", "eighth", "ninth",  "tenth"};
  int ordinal = 0;
  for (std::size_t i = 0; i < std::size(kOrdinals); ++i) {
    if (noted_.IsWord(at_ + 1, kOrdinals[i])) ordinal = static_cast<int>(i) + 1;
  }
  const std::size_t next = at_ + (noted_.IsWord(at_ + 2, "one") ? 3 : 2);
  if (ordinal == 0 || noted_.IsPause(next) || !EndsNounPhrase(next)) return 0;
  noted_.Mark(at_, next, &TokenNote::agent);
  // One of those who were counted, or one that comes on top of them.
  const bool among = groups_[last_].wish.quantity > 1 &&
                     (part_ != kNone || groups_[last_].wish.quantity >= ordinal);
  if (among) {
    Split({}, 1, next - at_);
  } else if (rest_ == last_ && groups_[last_].wish.quantity == 1 && part_ != kNone) {
    TakeRest({});
  } else {
    AddLike(last_, {1, 1, 1, next - at_}, next - at_);
  }
  return next - at_;
}

std::size_t AgentReader::ReadCompany() {
  if (subject_.empty()) return 0;
  const std::size_t near = RoleAt(Role::kNear, at_);
  const std::size_t in = RoleAt(Role::kIn, at_);
  const std::size_t said = noted_.IsWord(at_, "with") ? 1 : std::max(near, in);
  if (said == 0 || !noted_.IsAnyWord(at_ + said, {"them", "him", "her"})) return 0;
  std::size_t model = subject_.front();
  while (model > 0 && (model == subject_.front() || groups_[model].removed)) --model;
  if (model == subject_.front() || groups_[model].removed) return 0;
  for (const std::size_t index : subject_) {
    AgentWish& wish = groups_[index].wish;
    if (!wish.places.empty() || wish.feature.has_value()) continue;
    wish.places = groups_[model].wish.places;
    wish.feature = groups_[model].wish.feature;
    Extend(index, tokens_[at_ + said].end);
  }
  noted_.Mark(at_, at_ + said + 1, &TokenNote::place);
  return said + 1;
}

std::size_t AgentReader::ReadAnotherGroup() {
  const std::size_t more = RoleAt(Role::kMore, at_);
  if (more == 0 || last_ == kNone || at_ + more >= tokens_.size()) return 0;
  const std::size_t pack_at = at_ + more;
  // "another in the west"
  if (noted_.IsAnyWord(at_, {"another", "one", "yet"}) && EndsNounPhrase(pack_at) &&
      (!noted_.IsPause(pack_at) || lead_set_)) {
    noted_.Mark(at_, pack_at, &TokenNote::agent);
    AddLike(last_, {1, 1, 1, more}, more);
    return more;
  }
  // "other ten in the south"
  const Count ten = ReadCount(noted_, words_, pack_at);
  if (ten.tokens > 0 && !NounAhead(pack_at + ten.tokens) && !noted_.IsPause(pack_at + ten.tokens) &&
      EndsNounPhrase(pack_at + ten.tokens) && words_.species.LengthAt(tokens_, pack_at) == 0) {
    noted_.Mark(at_, pack_at + ten.tokens, &TokenNote::agent);
    AddLike(last_, ten, more + ten.tokens);
    return more + ten.tokens;
  }
  const Count pack = ReadCollective(noted_, words_, pack_at);
  if (pack.tokens == 0 || words_.species.LengthAt(tokens_, pack_at) > 0 ||
      noted_.IsWord(pack_at + 1, "of")) {
    return 0;
  }
  noted_.Mark(at_, pack_at + 1, &TokenNote::agent);
  AddLike(last_, pack, more + 1);
  return more + 1;
}

void AgentReader::AddLike(std::size_t model, const Count& count, std::size_t tokens) {
  Group group = groups_[model];
  group.wish.places.clear();
  group.wish.feature.reset();
  group.wish.each = false;
  group.begin = tokens_[at_].begin;
  group.end = tokens_[at_ + tokens - 1].end;
  group.removed = false;
  group.sentence = sentence_;
  SetCount(count, &group);
  ApplyLead(&group);
  split_state_ = true;  // its state is only that of the others so far
  groups_.push_back(std::move(group));
  subject_ = {groups_.size() - 1};
  previous_ = subject_;
  last_ = groups_.size() - 1;
}

std::size_t AgentReader::RenamePart(std::size_t at) {
  const std::size_t first = at;
  while (noted_.IsAnyWord(at, {"are", "is", "should", "be", "being", "must"})) ++at;
  if (noted_.IsPause(at) || part_ == kNone) return 0;
  const auto match = words_.species.At(tokens_, at);
  if (match.tokens == 0 || IsVerbHere(at, true)) return 0;
  AgentWish& part = groups_[part_].wish;
  part.categories = match.rows.front()->categories;
  part.exact = match.rows.front()->exact;
  part.name = JoinWords(tokens_, at, at + match.tokens);
  groups_[part_].end = tokens_[at + match.tokens - 1].end;
  noted_.Mark(at, at + match.tokens, &TokenNote::agent);
  return at + match.tokens - first;
}

void AgentReader::Split(const Count& count, int quantity, std::size_t tokens) {
  const std::size_t whole = last_;
  if (whole == kNone) return;
  quantity = std::max(1, quantity);
  Group part = groups_[whole];
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
  subject_ = {rest};
  previous_ = subject_;
}

Group* AgentReader::Last() {
  return last_ == kNone || groups_[last_].wish.quantity < 2 ? nullptr : &groups_[last_];
}

}  // namespace internal

}  // namespace latticeworld
