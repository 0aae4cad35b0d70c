// Reading about agents: counts without a noun of their own.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"

namespace latticeworld {
namespace internal {
namespace {

constexpr std::size_t kPlaceAhead_tokens = 8;

bool IsInSeveralPlaces(const AgentWish& wish) {
  return wish.places.size() > 1 || !wish.more_land.empty();
}

// Multiplies each bound of the count by the factor.
Count Times(const Count& count, int factor) {
  return {CappedProduct(count.least, factor), CappedProduct(count.value, factor),
          CappedProduct(count.most, factor), count.tokens};
}

}  // namespace

std::size_t AgentReader::ReadLoneCount(const Count& said) {
  if (last_ == kNone || at_ + said.tokens > tokens_.size()) return 0;
  const LoneCount lone = LoneCountOf(said);
  if (lone.of_them == 0 && !lone.each && !EndsNounPhrase(lone.next + lone.more)) return 0;
  if (const std::size_t each = ReadCountOfEach(lone); each > 0) return each;
  if (lone.IsPlain() && IsFlockOf(groups_[last_])) {
    AddFlock(lone.count);
    return lone.count.tokens;
  }
  noted_.Mark(at_, at_ + lone.tokens, &TokenNote::agent);
  if (IsTotalOfSentence(lone)) return lone.tokens;
  if (IsCountOfLast(lone)) {
    SetCount(lone.count, &groups_[last_]);
    Extend(last_, tokens_[at_ + lone.tokens - 1].end);
    subject_ = {last_};
    joined_ = paused_ = false;
    return lone.tokens;
  }
  if (lone.bare && lone.IsPlain()) {
    ReadBareCount(lone);
    return lone.tokens;
  }
  RaiseLeastOfLast(lone);
  if (IsPartOfLast(lone)) {
    const int left = std::max(1, groups_[last_].wish.quantity);
    Split(lone.count, std::min(lone.count.value, left), lone.tokens);
    return lone.tokens + RenamePart(at_ + lone.tokens);
  }
  // "two goblins in the north and three in the south"
  AddLike(last_, lone.count, lone.tokens);
  return lone.tokens;
}

LoneCount AgentDiscourse::LoneCountOf(const Count& said) const {
  LoneCount lone;
  lone.count = said;
  lone.next = at_ + said.tokens;
  lone.of_them = lone.next < tokens_.size() ? RoleAt(Role::kOfThem, lone.next) : 0;
  if (lone.next < tokens_.size() && noted_.IsAnyWord(lone.next, {"more", "others"})) lone.more = 1;
  if (noted_.IsWord(lone.next, "in") &&
      noted_.IsAnyWord(lone.next + 1, {"number", "all", "total"})) {
    lone.more = 2;
  }
  // "sixty heads", "five to a corner"
  lone.heads = noted_.IsAnyWord(lone.next, {"heads", "head", "members", "individuals", "strong"});
  if (lone.heads) lone.more = 1;
  // "one team in the north": as many as a team has.
  if (unit_ > 1 && ReadCollective(noted_, words_, lone.next).tokens > 0) {
    ++lone.count.tokens;
    ++lone.next;
  }
  // "a flock of 30 sheep and another of 15"
  const bool sized =
      at_ > 1 && noted_.IsWord(at_ - 1, "of") && noted_.IsAnyWord(at_ - 2, {"one", "another"});
  if (unit_ > 1 && !sized && lone.IsPlain() && ReadCollective(noted_, words_, at_).tokens == 0) {
    lone.count = Times(lone.count, unit_);
  }
  lone.each = noted_.IsAnyWord(lone.next, {"each", "apiece"}) ||
              (noted_.IsAnyWord(lone.next, {"to", "per", "in", "at", "for"}) &&
               (noted_.IsAnyWord(lone.next, {"per"}) ||
                noted_.IsAnyWord(lone.next + 1, {"a", "each", "every"})) &&
               IsInSeveralPlaces(groups_[last_].wish));
  lone.tokens = lone.count.tokens + std::max(lone.of_them, lone.more);
  lone.bare = noted_.IsPause(at_ + lone.tokens);
  return lone;
}

std::size_t AgentReader::ReadCountOfEach(const LoneCount& lone) {
  const Count& count = lone.count;
  const std::size_t next = lone.next;
  Group& whole = groups_[last_];
  // "two packs of wolves, seven in each"
  if (packs_ > 1 && part_ == kNone &&
      (noted_.IsAnyWord(next, {"each", "apiece", "per"}) ||
       (noted_.IsAnyWord(next, {"in", "to"}) &&
        noted_.IsAnyWord(next + 1, {"each", "a", "every"})))) {
    std::size_t end = next;
    while (!noted_.IsPause(end) && end < next + 3) ++end;
    SetCount(Times(count, packs_), &whole);
    unit_ = count.value;
    noted_.Mark(at_, end, &TokenNote::agent);
    return end - at_;
  }
  // "sixty sheep in all, twenty each in the fields, by the lake and in the forest"
  if (noted_.IsWord(next, "each") && count.least == count.most && PlacePhraseAt(next + 1) > 0 &&
      IsPlaceList(next + 1) && !whole.wish.IsPlaced()) {
    SetCount(count, &whole);
    whole.wish.each = true;
    subject_ = {last_};
    noted_.Mark(at_, next + 1, &TokenNote::agent);
    return next + 1 - at_;
  }
  if (lone.each && IsInSeveralPlaces(whole.wish) && !whole.wish.counted) {
    SetCount(count, &whole);
    whole.wish.each = true;
    std::size_t end = next;
    while (!noted_.IsPause(end)) ++end;
    noted_.Mark(at_, end, &TokenNote::agent);
    return end - at_;
  }
  return 0;
}

void AgentReader::AddFlock(const Count& count) {
  AddLike(last_, count, count.tokens);
  AgentWish& flock = groups_[last_].wish;
  flock.categories = {AgentCategory::kSheep};
  flock.exact = true;
  flock.name = "flock";
  flock.state.reset();
  noted_.Mark(at_, at_ + count.tokens, &TokenNote::agent);
}

bool AgentDiscourse::IsTotalOfSentence(const LoneCount& lone) const {
  // "20 sheep and 30 horses, 50 in all"
  return lone.more == 2 && !noted_.IsWord(lone.next + 1, "number") && groups_[last_].wish.counted &&
         TotalOf(GroupsOfSentence()) == lone.count.value;
}

bool AgentDiscourse::IsCountOfLast(const LoneCount& lone) const {
  const Group& whole = groups_[last_];
  if (corrected_ && lone.IsPlain()) return true;
  if (whole.wish.counted) return false;
  if (lone.IsPlain()) return FollowsNoun(whole) || IsAnnounced(whole, lone.bare);
  // "The goblins are in the forest. All twelve of them are asleep."
  if (lone.of_them > 0 && noted_.IsWord(at_, "all") && part_ == kNone) return true;
  // "a herd of horses, nine of them", "an ambush: six of them lie in wait", "sheep, five in
  // number"
  const bool more_than_said = lone.of_them > 0 && lone.count.least > whole.wish.most;
  return more_than_said || (lone.bare && (lone.of_them > 0 || lone.more == 2 || lone.heads));
}

void AgentReader::ReadBareCount(const LoneCount& lone) {
  Group& whole = groups_[last_];
  std::size_t place_end = at_;
  while (place_end > 0 && noted_.IsAnyWord(place_end - 1, {"there", "are", "is", "have", "we"})) {
    --place_end;
  }
  if (whole.wish.counted && lead_.set && place_end > 0 && noted_.notes[place_end - 1].place) {
    // "in the north five goblins, in the south seven"
    AddLike(last_, lone.count, lone.tokens);
    return;
  }
  // "sheep: lower left, nine", "... There are four."
  const bool told_so = at_ > 0 && noted_.IsAnyWord(at_ - 1, {"are", "is", "were"});
  if (!whole.wish.counted && (whole.sentence == sentence_ || told_so)) {
    SetCount(lone.count, &whole);
  }
}

void AgentReader::RaiseLeastOfLast(const LoneCount& lone) {
  const Count& count = lone.count;
  AgentWish& wish = groups_[last_].wish;
  // "Sheep stand in the fields. Six of them graze.": of at least so many.
  if (lone.of_them > 0 && !wish.counted && part_ == kNone && count.least == count.most &&
      count.value >= wish.quantity && wish.least > 1) {
    wish.least = std::max(wish.least, count.value);
    wish.quantity = count.value + 1;
    wish.most = std::max(wish.most, CappedProduct(count.value, 2));
  }
}

bool AgentDiscourse::IsPartOfLast(const LoneCount& lone) const {
  const Group& whole = groups_[last_];
  const int value = lone.count.value;
  const int left = whole.wish.quantity;
  if (lone.of_them > 0) return true;
  // "six eagles, of which two are asleep"
  if (at_ > 1 && value < left && RoleAt(Role::kOfThem, at_ - 2) == 2) return true;
  if (lone.more > 0) return false;
  const bool goes_on = part_ != kNone && rest_ == last_ && value <= left;
  // "Four rovers are in the village, but one has driven off."
  const bool contrasts = value < left && whole.wish.counted &&
                         (noted_.IsWord(at_, "but") ||
                          (at_ > 0 && noted_.IsAnyWord(at_ - 1, {"but", "although", "though"})));
  // "Ten sheep graze in the north, four are asleep."
  const bool among = value < left && whole.wish.counted && whole.sentence == sentence_ &&
                     noted_.IsAnyWord(lone.next, {"are", "is"}) && !IsPlaceAhead(lone.next);
  // "Ten sheep graze in the north. Four are asleep." Four in the south would be others.
  const bool elsewhere = whole.sentence == sentence_ || value >= left || IsPlaceAhead(lone.next);
  return goes_on || contrasts || among ||
         ((!whole.wish.IsPlaced() || !elsewhere) && value <= left && (left > 1 || part_ != kNone) &&
          (whole.wish.counted || part_ != kNone));
}

std::vector<std::size_t> AgentDiscourse::GroupsOfSentence() const {
  std::vector<std::size_t> here;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    if (!groups_[i].removed && groups_[i].sentence == sentence_) here.push_back(i);
  }
  return here;
}

bool AgentDiscourse::FollowsNoun(const Group& group) const {
  // "goblins x4 in the north", "horses: eight"
  std::size_t end = at_;
  while (end > 0 && (noted_.IsWord(end - 1, "x") || tokens_[end - 1].kind == TokenKind::kComma)) {
    if (tokens_[end - 1].text == ",") break;
    --end;
  }
  return end > 0 && noted_.notes[end - 1].agent && tokens_[end - 1].end == group.end;
}

bool AgentDiscourse::IsAnnounced(const Group& group, bool bare) const {
  const AgentWish& wish = group.wish;
  if (wish.least != kSomeSeen.least && wish.quantity < 2) return false;
  std::size_t first = at_;
  while (first > 0 && noted_.IsAnyWord(first - 1, {"say",  "and",   "there",   "are",    "maybe",
                                                   "so",   "about", "let",     "have",   "now",
                                                   "only", "just",  "today",   "remain", "please",
                                                   "i",    "want",  "counted", "count",  "see",
                                                   "saw",  "need",  "we",      "take",   "were"})) {
    --first;
  }
  // "I want ponies. At least twenty, please."
  const bool starts = first == 0 || tokens_[first - 1].kind == TokenKind::kStop;
  const bool untold = !wish.state.has_value() && !wish.IsPlaced();
  if (starts && bare) return true;
  // "Goblins attack the village: five in the north, ..."
  if (first > 0 && tokens_[first - 1].kind == TokenKind::kComma && tokens_[first - 1].text != ",") {
    return group.sentence == sentence_ && (wish.places.empty() || wish.feature.has_value());
  }
  // "Eagles belong there, so three are circling."
  return (untold && !NounAhead(at_ + 1)) || IsSpreadOut(group);
}

bool AgentDiscourse::IsSpreadOut(const Group& group) const {
  if (group.sentence != sentence_) return false;
  for (std::size_t i = at_; i > 0 && tokens_[i - 1].begin >= group.begin; --i) {
    if (noted_.IsAnyWord(i - 1, {"spread", "scattered", "distributed", "dotted", "strung"})) {
      return true;
    }
  }
  return false;
}

bool AgentDiscourse::IsFlockOf(const Group& group) const {
  // "a shepherd and his flock of sixty"
  return noted_.IsAnyWord(at_, {"flock", "flocks"}) &&
         LocomotionOf(group.wish.categories.front()) == Locomotion::kLegs &&
         group.wish.categories.front() != AgentCategory::kSheep;
}

bool AgentDiscourse::IsPlaceAhead(std::size_t at) const {
  // "5 SE, idle"
  if (!noted_.IsPause(at) && MatchPlace(tokens_, at).tokens > 0) return true;
  for (std::size_t i = at; i < at + kPlaceAhead_tokens && !noted_.IsPause(i); ++i) {
    if (PlacePhraseAt(i) > 0 || MatchPlace(tokens_, i).tokens > 1) return true;
  }
  return false;
}

void AgentReader::SetCount(const Count& count, Group* group) {
  group->wish.least = count.least;
  group->wish.quantity = count.value;
  group->wish.most = count.most;
  group->wish.counted = count.least == count.most;
}

}  // namespace internal

}  // namespace latticeworld
