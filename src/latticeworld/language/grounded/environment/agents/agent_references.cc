// Reading about agents: words that go back to groups named before.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"

namespace latticeworld {
namespace internal {

std::size_t AgentReader::ReadReference() {
  if (const std::size_t part = ReadPartOfCounted(); part > 0) return part;
  if (groups_.empty() || noted_.notes[at_].negated) return 0;
  if (const std::size_t part = ReadPartOfNamed(); part > 0) return part;
  if (const std::size_t unit = ReadUnit(); unit > 0) return unit;
  if (const std::size_t one = ReadCountOfFormer(); one > 0) return one;
  if (const std::size_t all_but = ReadAllBut(); all_but > 0) return all_but;
  if (const std::size_t fraction = ReadFraction(); fraction > 0) return fraction;
  if (const std::size_t some = RoleAt(Role::kSomeOfThem, at_); some > 0) {
    return Last() == nullptr ? 0 : ReadSomeOfThem(some);
  }
  if (const std::size_t all = ReadAllOfThem(); all > 0) return all;
  if (told_former_ == sentence_ + 1 && noted_.IsWord(at_, "the")) {
    // "..., the second sleeps": read with its next word.
    if (noted_.IsAnyWord(at_ + 1, {"second", "other", "latter"})) return 1;
  }
  if (const std::size_t ordinal = ReadOrdinal(); ordinal > 0) return ordinal;
  if (const std::size_t again = ReadAnotherGroup(); again > 0) return again;
  if (const std::size_t none = ReadNoneWanted(); none > 0) return none;
  if (const std::size_t others = ReadOthers(); others > 0) return others;
  if (const std::size_t one = ReadFormerOrLatter(); one > 0) return one;
  if (const std::size_t all = ReadEverybody(); all > 0) return all;
  return ReadPronoun();
}

std::size_t AgentReader::ReadSomeOfThem(std::size_t tokens) {
  const AgentWish& whole = Last()->wish;
  noted_.Mark(at_, at_ + tokens, &TokenNote::agent);
  const Count part = VaguePartAt(at_, whole.quantity);
  const bool ranges = whole.counted && part.tokens > 0;
  Split(ranges ? part : Count{}, part.value, tokens);
  return tokens;
}

std::size_t AgentReader::ReadNoneWanted() {
  if (!noted_.IsWord(at_, "none") || last_ == kNone || at_ == 0 || !noted_.IsPause(at_ - 1) ||
      words_.assets.LengthAt(tokens_, at_ - 1) > 0) {
    return 0;
  }
  std::size_t end = at_ + 1;
  while (noted_.IsAnyWord(end, {"today", "tonight", "here", "now", "please", "this", "time", "at",
                                "all", "whatsoever", "anywhere", "needed", "wanted"})) {
    ++end;
  }
  if (!noted_.IsPause(end)) return 0;
  groups_[last_].removed = true;
  Known(end - at_);
  return end - at_;
}

std::size_t AgentReader::ReadOthers() {
  const std::size_t others = RoleAt(Role::kOthers, at_);
  if (others == 0) return 0;
  // "the remaining five" counts along; "the other horses" is read as a noun phrase.
  const Count count =
      at_ + others < tokens_.size() ? ReadCount(noted_, words_, at_ + others) : Count{};
  const std::size_t tokens = others + count.tokens;
  const std::size_t next = at_ + tokens;
  // "the others fly", but "the other guards sleep"
  const bool verb = count.tokens == 0 && !noted_.IsPause(next) &&
                    !noted_.IsAnyWord(next - 1, {"other", "remaining"}) && IsVerbHere(next, false);
  const bool noun = !verb && next < tokens_.size() && words_.species.LengthAt(tokens_, next) > 0;
  if (const std::size_t left = ReadRestOfTotal(next); left > 0) return left;
  if (noun || !EndsNounPhrase(next)) return 0;
  noted_.Mark(at_, next, &TokenNote::agent);
  // "One sheep has strayed, the other nineteen graze."
  const bool first_told = part_ == kNone && rest_ == kNone && last_ != kNone &&
                          groups_[last_].wish.counted && count.value > groups_[last_].wish.quantity;
  if (first_told) {
    AddLike(last_, count, tokens);
    return tokens;
  }
  if (count.tokens == 0 && TakeOtherGroups()) return others;
  TakeRest(count);
  const std::size_t rest = subject_.empty() ? kNone : subject_.front();
  return tokens + Rename(rest, next);
}

std::size_t AgentReader::ReadPronoun() {
  const std::size_t they = RoleAt(Role::kThey, at_);
  const bool it = noted_.IsWord(at_, "it") && previous_.size() == 1 && at_ + 1 < tokens_.size() &&
                  words_.states.LengthAt(tokens_, at_ + 1) > 0 &&
                  words_.coarse.LengthAt(tokens_, at_ + 1) == 0;
  if (they == 0 && !it) return 0;
  const std::size_t tokens = std::max<std::size_t>(they, 1);
  Known(tokens);
  // As an object ("watch them") a pronoun only says where its verb's subject is.
  if (!subject_.empty() && acted_ && verb_end_ == at_) {
    const std::size_t watched = GroupBefore(!it, true);
    for (const std::size_t index : subject_) {
      if (groups_[index].with == kNone && watched != index) groups_[index].with = watched;
    }
  }
  if (subject_.empty()) subject_ = previous_;
  if (subject_.size() == 1 && IsMutual()) AddOtherSide();
  return tokens;
}

bool AgentReader::TakeOtherGroups() {
  if (part_ != kNone || subject_.empty() || acted_on_ != sentence_ + 1) return false;
  const bool before = std::all_of(subject_.begin(), subject_.end(), [&](std::size_t index) {
    return groups_[index].sentence != sentence_;
  });
  if (!before) return false;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    const bool told = group.removed || group.purpose || group.wish.state.has_value();
    if (!told && !IsSubject(i)) others.push_back(i);
  }
  if (others.empty()) return false;
  subject_ = others;
  previous_ = others;
  joined_ = paused_ = acted_ = false;
  return true;
}

bool AgentDiscourse::IsMutual() const {
  for (std::size_t i = at_; !noted_.IsEnd(i); ++i) {
    if (noted_.IsAnyWord(i, {"each", "one"}) && noted_.IsAnyWord(i + 1, {"other", "another"})) {
      return true;
    }
  }
  return false;
}

void AgentReader::AddOtherSide() {
  // "Ten goblins. Ten knights. They fight each other."
  const std::size_t one = subject_.front();
  for (std::size_t i = one; i > 0; --i) {
    if (groups_[i - 1].removed) continue;
    if (groups_[one].wish.quantity < 2 || groups_[i - 1].sentence + 1 == groups_[one].sentence) {
      subject_.insert(subject_.begin(), i - 1);
    }
    return;
  }
}

std::size_t AgentReader::ReadEverybody() {
  std::size_t next = at_;
  if (noted_.IsAnyWord(next, {"they", "these", "those"})) {
    ++next;
    if (noted_.IsAnyWord(next, {"are", "should", "must", "will"})) ++next;
    if (noted_.IsWord(next, "be")) ++next;
  }
  const bool they = next > at_;
  if (!noted_.IsAnyWord(
          next, {"all", "both", "each", "every", "everyone", "everybody", "neither", "none"})) {
    return 0;
  }
  const bool person = noted_.IsAnyWord(next, {"everyone", "everybody"});
  const bool every = noted_.IsAnyWord(next, {"each", "every"});
  const bool denied = noted_.IsAnyWord(next, {"neither", "none"});
  ++next;
  if (every && noted_.IsWord(next, "one")) ++next;
  const std::size_t of_them = next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
  next += of_them;
  if (noted_.IsWord(next, "else") || (denied && of_them > 0)) return 0;
  const bool after_pause = at_ == 0 || noted_.IsPause(at_ - 1) || noted_.IsWord(at_ - 1, "and");
  const bool acts = next < tokens_.size() && words_.states.LengthAt(tokens_, next) > 0;
  const bool is = noted_.IsAnyWord(next, {"are", "is", "should", "must", "were"});
  // "9 goblins; 9 knights; all idle"
  const bool alone = acts && noted_.IsWord(at_, "all") && at_ > 0 && noted_.IsEnd(at_ - 1);
  // "..., two black ones, four white ones, all in the fields"
  const bool all_there = noted_.IsWord(at_, "all") && groups_.size() > 1 &&
                         noted_.IsAnyWord(next, {"in", "on", "at", "by", "near", "beside"}) &&
                         PlacePhraseAt(next) > 0;
  const bool whole_sentence = of_them > 0 || person || they || alone || (is && !every);
  if (!they && of_them == 0 && !(after_pause && (acts || all_there || (is && !every)))) return 0;
  if (of_them > 0 && !after_pause) return 0;
  // Those of this sentence, and those of before who wait for a word.
  std::vector<std::size_t> everybody = subject_.empty() ? previous_ : subject_;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    const bool told = group.sentence != sentence_ && group.wish.state.has_value();
    const bool before = group.sentence != sentence_ && !whole_sentence;
    if (group.removed || group.purpose || told || before) continue;
    if (std::find(everybody.begin(), everybody.end(), i) == everybody.end()) everybody.push_back(i);
  }
  everybody.erase(std::remove_if(everybody.begin(), everybody.end(),
                                 [&](std::size_t i) { return groups_[i].removed; }),
                  everybody.end());
  std::sort(everybody.begin(), everybody.end());
  if (everybody.empty()) return 0;
  subject_ = everybody;
  previous_ = everybody;
  everybody_ = true;
  joined_ = paused_ = acted_ = false;
  Known(next - at_);
  return next - at_;
}

std::vector<std::size_t> AgentDiscourse::NamedLast() const {
  std::vector<std::size_t> named;
  for (std::size_t i = groups_.size(); i > 0 && named.size() < 2; --i) {
    if (!groups_[i - 1].removed) named.push_back(i - 1);
  }
  return named;
}

std::size_t AgentReader::ReadCountOfFormer() {
  const Count count = pending_.tokens > 0 ? Count{} : ReadCount(noted_, words_, at_);
  if (count.tokens == 0) return 0;
  std::size_t next = at_ + count.tokens;
  if (noted_.IsWord(next, "one")) ++next;
  const bool former = noted_.IsWord(next + 2, "former");
  if (!noted_.IsWord(next, "of") || !noted_.IsWord(next + 1, "the") ||
      !(former || noted_.IsWord(next + 2, "latter"))) {
    return 0;
  }
  next += 3;
  const std::vector<std::size_t> named = NamedLast();
  if (named.size() < 2) return 0;
  const std::size_t index = former ? named.back() : named.front();
  noted_.Mark(at_, next, &TokenNote::agent);
  if (groups_[index].wish.counted) {
    last_ = index;
    Split(count, count.value, next - at_);
  } else {
    SetCount(count, &groups_[index]);
    Extend(index, tokens_[next - 1].end);
    subject_ = {index};
  }
  joined_ = paused_ = acted_ = false;
  return next - at_;
}

std::size_t AgentReader::ReadFormerOrLatter() {
  const bool former = noted_.IsAnyWord(at_, {"former", "first", "firsts"});
  if (!former && !noted_.IsAnyWord(at_, {"latter", "second", "last", "other"})) return 0;
  const bool bare = noted_.IsAnyWord(at_, {"former", "latter"});
  const bool noun = noted_.IsAnyWord(
      at_ + 1, {"group", "ones", "band", "party", "lot", "team", "herd", "flock", "squad"});
  // "The first group grazes, the second sleeps."
  const bool second = !former && told_former_ == sentence_ + 1 && EndsNounPhrase(at_ + 1);
  if (!bare && !noun && !second) return 0;
  if (noted_.IsWord(at_, "other") && !second) return 0;
  // "the latter two", "the latter are"
  const std::vector<std::size_t> named = NamedLast();
  if (named.size() < 2) return 0;
  if (former) told_former_ = sentence_ + 1;
  subject_ = {former ? named.back() : named.front()};
  previous_ = {named.back(), named.front()};
  joined_ = paused_ = acted_ = false;
  const std::size_t tokens = noun ? 2 : 1;
  noted_.Mark(at_, at_ + tokens, &TokenNote::agent);
  return tokens;
}

std::size_t AgentReader::ReadAllOfThem() {
  const bool both = noted_.IsWord(at_, "both");
  if (!both && !noted_.IsAnyWord(at_, {"all", "these", "those", "the"})) return 0;
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

std::size_t AgentReader::ReadAnotherGroup() {
  const std::size_t more = RoleAt(Role::kMore, at_);
  if (more == 0 || last_ == kNone || at_ + more >= tokens_.size()) return 0;
  const std::size_t pack_at = at_ + more;
  // "Second group: ..." is a heading.
  if (pack_at + 1 < tokens_.size() && tokens_[pack_at + 1].text == ":") return 0;
  // "another in the west"
  if (noted_.IsAnyWord(at_, {"another", "one", "yet"}) && EndsNounPhrase(pack_at) &&
      (!noted_.IsPause(pack_at) || lead_.set)) {
    noted_.Mark(at_, pack_at, &TokenNote::agent);
    // "three pairs: ... another in the south" is one of those.
    if (unit_ > 1 && part_ != kNone && groups_[last_].wish.quantity >= unit_) {
      Split({}, unit_, more);
    } else {
      AddLike(last_, {unit_, unit_, unit_, more}, more);
    }
    return more;
  }
  // "other ten in the south", "Another twelve, waiting."
  const Count ten = ReadCount(noted_, words_, pack_at);
  const bool bare =
      noted_.IsPause(pack_at + ten.tokens) && !noted_.IsAnyWord(at_, {"another", "yet"});
  if (ten.tokens > 0 && !NounAhead(pack_at + ten.tokens) && !bare &&
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
  group.wish.ForgetPlace();
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

}  // namespace internal

}  // namespace latticeworld
