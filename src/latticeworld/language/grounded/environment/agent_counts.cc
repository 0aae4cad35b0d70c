// Reading about agents: counts without a noun of their own.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agent_discourse.h"

namespace latticeworld {
namespace internal {

std::size_t AgentReader::ReadLoneCount(const Count& count) {
  std::size_t next = at_ + count.tokens;
  if (last_ == kNone || next > tokens_.size()) return 0;
  const std::size_t of_them = next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
  std::size_t more = next < tokens_.size() && noted_.IsAnyWord(next, {"more", "others"}) ? 1 : 0;
  if (noted_.IsWord(next, "in") && noted_.IsAnyWord(next + 1, {"number", "all", "total"})) more = 2;
  // "sixty heads", "five to a corner"
  if (noted_.IsAnyWord(next, {"heads", "head", "members", "individuals", "strong"})) more = 1;
  const bool each =
      noted_.IsAnyWord(next, {"each", "apiece"}) ||
      (noted_.IsAnyWord(next, {"to", "per", "in", "at", "for"}) &&
       (noted_.IsAnyWord(next, {"per"}) || noted_.IsAnyWord(next + 1, {"a", "each", "every"})) &&
       groups_[last_].wish.places.size() > 1);
  if (of_them == 0 && !each && !EndsNounPhrase(next + more)) return 0;
  Group& whole = groups_[last_];
  if (each && whole.wish.places.size() > 1 && !whole.wish.counted) {
    SetCount(count, &whole);
    whole.wish.each = true;
    std::size_t end = next;
    while (!noted_.IsPause(end)) ++end;
    noted_.Mark(at_, end, &TokenNote::agent);
    return end - at_;
  }
  if (of_them == 0 && more == 0 && noted_.IsAnyWord(at_, {"flock", "flocks"}) &&
      LocomotionOf(whole.wish.categories.front()) == Locomotion::kLegs && last_ != kNone &&
      whole.wish.categories.front() != AgentCategory::kSheep) {
    // "a shepherd and his flock of sixty"
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
  if (corrected_ && of_them == 0 && more == 0) {
    SetCount(count, &whole);
    Extend(last_, tokens_[at_ + count.tokens - 1].end);
    subject_ = {last_};
    return tokens;
  }
  // "goblins x4 in the north"
  const std::size_t noun_end = at_ > 0 && noted_.IsWord(at_ - 1, "x") ? at_ - 1 : at_;
  const bool follows =
      noun_end > 0 && noted_.notes[noun_end - 1].agent && tokens_[noun_end - 1].end == whole.end;
  if (follows && of_them == 0 && more == 0 && !whole.wish.counted) {
    SetCount(count, &whole);
    Extend(last_, tokens_[at_ + count.tokens - 1].end);
    return tokens;
  }
  const bool told = !whole.wish.places.empty() || whole.wish.feature.has_value();
  const bool bare = noted_.IsPause(at_ + tokens);
  // "a herd of horses, nine of them", "an ambush: six of them lie in wait", "sheep, five in number"
  const bool more_than_said = of_them > 0 && count.least > whole.wish.most;
  const bool heads = noted_.IsAnyWord(next, {"heads", "head", "members", "individuals", "strong"});
  if (!whole.wish.counted && ((bare && (of_them > 0 || more == 2 || heads)) || more_than_said)) {
    SetCount(count, &whole);
    subject_ = {last_};
    return tokens;
  }
  if (bare && of_them == 0 && more == 0 && whole.wish.counted && lead_set_ && at_ > 0 &&
      noted_.notes[at_ - 1].place) {
    // "in the north five goblins, in the south seven"
    AddLike(last_, count, tokens);
    return tokens;
  }
  if (bare && of_them == 0 && more == 0) {
    // "sheep: lower left, nine", "... There are four."
    const bool told_so = at_ > 0 && noted_.IsAnyWord(at_ - 1, {"are", "is", "were"});
    if (!whole.wish.counted && (whole.sentence == sentence_ || told_so)) SetCount(count, &whole);
    return tokens;
  }
  const int left = part_ != kNone ? groups_[last_].wish.quantity : whole.wish.quantity;
  const bool splits =
      of_them > 0 || (!told && more == 0 && count.value <= left && (left > 1 || part_ != kNone) &&
                      (whole.wish.counted || part_ != kNone));
  if (splits) {
    Split(count, std::min(count.value, std::max(1, left)), tokens);
    return tokens + RenamePart(at_ + tokens);
  }
  // "two goblins in the north and three in the south"
  AddLike(last_, count, tokens);
  return tokens;
}

void AgentReader::SetCount(const Count& count, Group* group) {
  group->wish.least = count.least;
  group->wish.quantity = count.value;
  group->wish.most = count.most;
  group->wish.counted = count.least == count.most;
}

}  // namespace internal

}  // namespace latticeworld
