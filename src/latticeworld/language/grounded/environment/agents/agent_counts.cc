// Reading about agents: counts without a noun of their own.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_discourse.h"

namespace latticeworld {
namespace internal {
namespace {

constexpr std::size_t kPlaceAhead_tokens = 8;

bool IsInSeveralPlaces(const AgentWish& wish) {
  return wish.places.size() > 1 || !wish.more_land.empty();
}

}  // namespace

std::size_t AgentReader::ReadLoneCount(const Count& said) {
  Count count = said;
  std::size_t next = at_ + count.tokens;
  if (last_ == kNone || next > tokens_.size()) return 0;
  const std::size_t of_them = next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
  std::size_t more = next < tokens_.size() && noted_.IsAnyWord(next, {"more", "others"}) ? 1 : 0;
  if (noted_.IsWord(next, "in") && noted_.IsAnyWord(next + 1, {"number", "all", "total"})) more = 2;
  // "sixty heads", "five to a corner"
  const bool heads = noted_.IsAnyWord(next, {"heads", "head", "members", "individuals", "strong"});
  if (heads) more = 1;
  // "one team in the north": as many as a team has.
  const bool packs = unit_ > 1 && ReadCollective(noted_, words_, next).tokens > 0;
  if (packs) {
    ++count.tokens;
    ++next;
  }
  // "a flock of 30 sheep and another of 15"
  const bool sized =
      at_ > 1 && noted_.IsWord(at_ - 1, "of") && noted_.IsAnyWord(at_ - 2, {"one", "another"});
  if (unit_ > 1 && !sized && of_them == 0 && more == 0 &&
      ReadCollective(noted_, words_, at_).tokens == 0) {
    count = {CappedProduct(count.least, unit_), CappedProduct(count.value, unit_),
             CappedProduct(count.most, unit_), count.tokens};
  }
  const bool each =
      noted_.IsAnyWord(next, {"each", "apiece"}) ||
      (noted_.IsAnyWord(next, {"to", "per", "in", "at", "for"}) &&
       (noted_.IsAnyWord(next, {"per"}) || noted_.IsAnyWord(next + 1, {"a", "each", "every"})) &&
       IsInSeveralPlaces(groups_[last_].wish));
  if (of_them == 0 && !each && !EndsNounPhrase(next + more)) return 0;
  Group& whole = groups_[last_];
  // "two packs of wolves, seven in each"
  if (packs_ > 1 && part_ == kNone &&
      (noted_.IsAnyWord(next, {"each", "apiece", "per"}) ||
       (noted_.IsAnyWord(next, {"in", "to"}) &&
        noted_.IsAnyWord(next + 1, {"each", "a", "every"})))) {
    std::size_t end = next;
    while (!noted_.IsPause(end) && end < next + 3) ++end;
    SetCount({CappedProduct(count.least, packs_), CappedProduct(count.value, packs_),
              CappedProduct(count.most, packs_), 1},
             &whole);
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
  if (each && IsInSeveralPlaces(whole.wish) && !whole.wish.counted) {
    SetCount(count, &whole);
    whole.wish.each = true;
    std::size_t end = next;
    while (!noted_.IsPause(end)) ++end;
    noted_.Mark(at_, end, &TokenNote::agent);
    return end - at_;
  }
  if (of_them == 0 && more == 0 && IsFlockOf(whole)) {
    AddLike(last_, count, count.tokens);
    AgentWish& flock = groups_[last_].wish;
    flock.categories = {AgentCategory::kSheep};
    flock.exact = true;
    flock.name = "flock";
    flock.state.reset();
    noted_.Mark(at_, at_ + count.tokens, &TokenNote::agent);
    return count.tokens;
  }
  const std::size_t tokens = count.tokens + std::max(of_them, more);
  noted_.Mark(at_, at_ + tokens, &TokenNote::agent);
  const bool plain = of_them == 0 && more == 0;
  const auto tell_count = [&](std::size_t end) {
    SetCount(count, &groups_[last_]);
    Extend(last_, tokens_[end - 1].end);
    subject_ = {last_};
    joined_ = paused_ = false;
    return end - at_;
  };
  // "20 sheep and 30 horses, 50 in all"
  if (more == 2 && !noted_.IsWord(next + 1, "number") && whole.wish.counted &&
      TotalOf(GroupsOfSentence()) == count.value) {
    return tokens;
  }
  if (corrected_ && plain) return tell_count(at_ + tokens);
  const bool bare = noted_.IsPause(at_ + tokens);
  if (!whole.wish.counted) {
    if (plain && FollowsNoun(whole)) return tell_count(at_ + tokens);
    // "a herd of horses, nine of them", "an ambush: six of them lie in wait", "sheep, five in
    // number"
    const bool more_than_said = of_them > 0 && count.least > whole.wish.most;
    // "The goblins are in the forest. All twelve of them are asleep."
    const bool all = of_them > 0 && noted_.IsWord(at_, "all") && part_ == kNone;
    if (all) return tell_count(at_ + tokens);
    if ((bare && (of_them > 0 || more == 2 || heads)) || more_than_said) {
      return tell_count(at_ + tokens);
    }
    if (plain && IsAnnounced(whole, bare)) return tell_count(at_ + tokens);
  }
  std::size_t place_end = at_;
  while (place_end > 0 && noted_.IsAnyWord(place_end - 1, {"there", "are", "is", "have", "we"})) {
    --place_end;
  }
  if (bare && plain && whole.wish.counted && lead_.set && place_end > 0 &&
      noted_.notes[place_end - 1].place) {
    // "in the north five goblins, in the south seven"
    AddLike(last_, count, tokens);
    return tokens;
  }
  if (bare && plain) {
    // "sheep: lower left, nine", "... There are four."
    const bool told_so = at_ > 0 && noted_.IsAnyWord(at_ - 1, {"are", "is", "were"});
    if (!whole.wish.counted && (whole.sentence == sentence_ || told_so)) SetCount(count, &whole);
    return tokens;
  }
  // "Sheep stand in the fields. Six of them graze.": of at least so many.
  if (of_them > 0 && !whole.wish.counted && part_ == kNone && count.least == count.most &&
      count.value >= whole.wish.quantity && whole.wish.least > 1) {
    whole.wish.least = std::max(whole.wish.least, count.value);
    whole.wish.quantity = count.value + 1;
    whole.wish.most = std::max(whole.wish.most, CappedProduct(count.value, 2));
  }
  const int left = whole.wish.quantity;
  const bool told = whole.wish.IsPlaced();
  // "Ten sheep graze in the north. Four are asleep." Four in the south would be others.
  const bool elsewhere = whole.sentence == sentence_ || count.value >= left || IsPlaceAhead(next);
  // "six eagles, of which two are asleep"
  const bool out_of = at_ > 1 && count.value < left && RoleAt(Role::kOfThem, at_ - 2) == 2;
  const bool goes_on = part_ != kNone && rest_ == last_ && more == 0 && count.value <= left;
  // "Four rovers are in the village, but one has driven off."
  const bool contrasts = more == 0 && count.value < left && whole.wish.counted &&
                         (noted_.IsWord(at_, "but") ||
                          (at_ > 0 && noted_.IsAnyWord(at_ - 1, {"but", "although", "though"})));
  // "Ten sheep graze in the north, four are asleep."
  const bool among = more == 0 && count.value < left && whole.wish.counted &&
                     whole.sentence == sentence_ && noted_.IsAnyWord(next, {"are", "is"}) &&
                     !IsPlaceAhead(next);
  const bool splits = of_them > 0 || out_of || goes_on || contrasts || among ||
                      ((!told || !elsewhere) && more == 0 && count.value <= left &&
                       (left > 1 || part_ != kNone) && (whole.wish.counted || part_ != kNone));
  if (splits) {
    Split(count, std::min(count.value, std::max(1, left)), tokens);
    return tokens + RenamePart(at_ + tokens);
  }
  // "two goblins in the north and three in the south"
  AddLike(last_, count, tokens);
  return tokens;
}

std::vector<std::size_t> AgentReader::GroupsOfSentence() const {
  std::vector<std::size_t> here;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    if (!groups_[i].removed && groups_[i].sentence == sentence_) here.push_back(i);
  }
  return here;
}

bool AgentReader::FollowsNoun(const Group& group) const {
  // "goblins x4 in the north", "horses: eight"
  std::size_t end = at_;
  while (end > 0 && (noted_.IsWord(end - 1, "x") || tokens_[end - 1].kind == TokenKind::kComma)) {
    if (tokens_[end - 1].text == ",") break;
    --end;
  }
  return end > 0 && noted_.notes[end - 1].agent && tokens_[end - 1].end == group.end;
}

bool AgentReader::IsAnnounced(const Group& group, bool bare) const {
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

bool AgentReader::IsSpreadOut(const Group& group) const {
  if (group.sentence != sentence_) return false;
  for (std::size_t i = at_; i > 0 && tokens_[i - 1].begin >= group.begin; --i) {
    if (noted_.IsAnyWord(i - 1, {"spread", "scattered", "distributed", "dotted", "strung"})) {
      return true;
    }
  }
  return false;
}

bool AgentReader::IsFlockOf(const Group& group) const {
  // "a shepherd and his flock of sixty"
  return noted_.IsAnyWord(at_, {"flock", "flocks"}) &&
         LocomotionOf(group.wish.categories.front()) == Locomotion::kLegs &&
         group.wish.categories.front() != AgentCategory::kSheep;
}

bool AgentReader::IsPlaceAhead(std::size_t at) const {
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
