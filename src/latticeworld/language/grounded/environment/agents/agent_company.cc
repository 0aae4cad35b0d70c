// Reading about agents: places told by who or what is there ("above them", "beside the horses").

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"
#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace internal {
namespace {

constexpr std::size_t kMemory_tokens = 60;  // how far back a pronoun reaches for land

}  // namespace

std::size_t AgentReader::ReadCompany() {
  const std::size_t near = RoleAt(Role::kNear, at_);
  const std::size_t in = RoleAt(Role::kIn, at_);
  const bool with = noted_.IsWord(at_, "with");
  // "hover above them": the preposition is part of what they do.
  const bool object = verb_end_ == at_ && at_ > 0 &&
                      (noted_.IsAnyWord(at_ - 1, {"above", "over", "around", "about", "after"}) ||
                       (acted_ && noted_.IsWord(at_, "it")));
  const std::size_t said = with ? 1 : std::max(near, in);
  if ((said == 0 && !object) || noted_.notes[at_].negated) return 0;
  Reference reference = ReferenceAt(at_ + said, true);
  if (reference.tokens == 0) reference = ReferenceAt(at_ + said, false);
  if (reference.tokens == 0) return 0;
  const std::size_t end = at_ + said + reference.tokens;
  const bool pronoun = words_.species.LengthAt(tokens_, end - 1) == 0;
  // "with the horses in the south" goes on about the horses.
  if (with && !pronoun) return 0;
  // Who comes from somebody, or stands across from them, is elsewhere.
  const bool apart = noted_.IsAnyWord(at_, {"from", "opposite", "across", "facing", "to"});
  const bool fronted = IsFronted(end);
  if (fronted && noted_.IsAnyWord(at_ + said, {"each", "every"}) && reference.group != kNone) {
    times_ = TotalOf({reference.group});
  }
  if (subject_.empty() && !fronted) return 0;
  if (fronted) reference = ReferenceAt(at_ + said, false);
  std::size_t group = reference.group;
  std::optional<FeaturePlace> land;
  if (reference.land && !with) land = LandBefore(reference.plural, group == kNone);
  if (land.has_value()) {
    land->near = near > in;
    group = kNone;
  }
  if (group == kNone && !land.has_value() && !apart) return 0;
  noted_.Mark(at_, end, &TokenNote::place);
  if (apart) return end - at_;
  if (fronted) {
    SetPlace({}, land, false, {}, end);
    lead_.with = group;
    return end - at_;
  }
  for (const std::size_t index : subject_) {
    if (group == index || !groups_[index].wish.places.empty()) continue;
    if (groups_[index].wish.feature.has_value()) continue;
    groups_[index].with = group;
    if (land.has_value()) groups_[index].wish.feature = land;
    Extend(index, tokens_[end - 1].end);
  }
  return end - at_;
}

Reference AgentDiscourse::ReferenceAt(std::size_t at, bool of_others) const {
  if (noted_.IsPause(at)) return {};
  const bool bare = noted_.IsAnyWord(at, {"these", "those", "both"}) && EndsNounPhrase(at + 1);
  if (noted_.IsWord(at, "them") || bare) {
    return {1, GroupBefore(true, of_others), true, true};
  }
  // "above all five", "among all of them", "above everybody"
  if (noted_.IsAnyWord(at, {"everybody", "everyone"})) return {1, GroupBefore(true, of_others)};
  if (noted_.IsWord(at, "all")) {
    const std::size_t count = MatchNumber(tokens_, at + 1).tokens;
    const std::size_t all = 1 + count + RoleAt(Role::kOfThem, at + 1 + count);
    if (all > 1 && EndsNounPhrase(at + all)) return {all, GroupBefore(true, of_others)};
  }
  if (noted_.IsAnyWord(at, {"each", "every"})) {
    const std::size_t one = noted_.IsWord(at + 1, "one") ? 1 : 0;
    const std::size_t of_them = RoleAt(Role::kOfThem, at + 1 + one);
    if (of_them > 0) return {1 + one + of_them, GroupBefore(true, of_others)};
  }
  if (noted_.IsAnyWord(at, {"him", "her"}) && EndsNounPhrase(at + 1)) {
    return {1, GroupBefore(false, of_others), false, false};
  }
  if (noted_.IsWord(at, "it")) return {1, GroupBefore(false, of_others), true, false};
  if (!noted_.IsAnyWord(at, {"the", "their", "these", "those", "his", "her", "its"})) return {};
  // "at his side"
  if (noted_.IsAnyWord(at + 1, {"side", "sides", "feet", "heels", "company", "midst", "ranks",
                                "head", "heads"}) &&
      !noted_.IsWord(at, "the")) {
    return {2, GroupBefore(noted_.IsWord(at, "their"), of_others)};
  }
  // "between the two", "next to the first one"
  const std::size_t one = noted_.IsAnyWord(at + 2, {"one", "ones", "group"}) ? 1 : 0;
  if (noted_.IsWord(at + 1, "two") && EndsNounPhrase(at + 2))
    return {2, GroupBefore(true, of_others)};
  if (noted_.IsAnyWord(at + 1, {"first", "former", "second", "latter", "last", "third"}) &&
      (noted_.IsPause(at + 2 + one) || EndsNounPhrase(at + 2 + one))) {
    std::vector<std::size_t> named;
    for (const std::size_t sentence : {sentence_, sentence_ == 0 ? kNone : sentence_ - 1}) {
      for (std::size_t i = 0; i < groups_.size(); ++i) {
        const bool own = of_others && IsSubject(i);
        if (!groups_[i].removed && !own && groups_[i].sentence == sentence) named.push_back(i);
      }
      if (!named.empty()) break;
    }
    if (named.empty()) return {};
    std::size_t which = named.size() - 1;
    if (noted_.IsAnyWord(at + 1, {"first", "former"})) which = 0;
    if (noted_.IsWord(at + 1, "second")) which = std::min<std::size_t>(1, which);
    if (noted_.IsWord(at + 1, "third")) which = std::min<std::size_t>(2, which);
    return {2 + one, named[which]};
  }
  // "beside the two horses"
  std::size_t noun = at + 1;
  const Count count = ReadCount(noted_, words_, noun);
  noun += count.tokens;
  const auto match = words_.species.At(tokens_, noun);
  if (match.tokens == 0 || noted_.notes[noun].negated) return {};
  const SpeciesWord& word = *match.rows.front();
  for (std::size_t i = groups_.size(); i > 0; --i) {
    const Group& group = groups_[i - 1];
    const bool own = of_others && IsSubject(i - 1);
    if (group.removed || own || !Contains(word.categories, group.wish.categories)) continue;
    if (count.tokens > 0 && count.value != group.wish.quantity) continue;
    return {noun + match.tokens - at, i - 1};
  }
  return {};
}

std::size_t AgentDiscourse::GroupBefore(bool plural, bool of_others) const {
  std::size_t any = kNone;
  for (std::size_t i = groups_.size(); i > 0; --i) {
    const Group& group = groups_[i - 1];
    const bool own = of_others && IsSubject(i - 1);
    if (group.removed || own || group.purpose) continue;
    if ((group.wish.quantity > 1) == plural) return i - 1;
    if (any == kNone) any = i - 1;
  }
  return any;
}

void AgentReader::JoinSubjectTo(std::size_t index) {
  std::size_t at = pending_.tokens > 0 ? count_at_ : at_;
  while (at > 0 &&
         noted_.IsAnyWord(at - 1, {"the", "a", "an", "their", "his", "her", "my", "our"})) {
    --at;
  }
  if (at == 0) return;
  // The preposition that ends right before the noun phrase.
  std::size_t preposition = 0;
  for (std::size_t length = 1; length <= std::min<std::size_t>(4, at); ++length) {
    const std::size_t first = at - length;
    if (std::max(RoleAt(Role::kNear, first), RoleAt(Role::kIn, first)) == length) {
      preposition = length;
    }
  }
  const std::size_t first = at - preposition;
  if (preposition == 0 || noted_.IsAnyWord(first, {"by", "from", "to", "opposite", "for", "about",
                                                   "towards", "toward", "into", "past"})) {
    return;
  }
  for (const std::size_t owner : subject_) {
    Group& group = groups_[owner];
    const bool placed = group.wish.IsPlaced();
    if (!placed && group.with == kNone && owner != index) group.with = index;
  }
}

std::optional<FeaturePlace> AgentDiscourse::LandBefore(bool plural, bool placed) const {
  const FeatureWord* other = nullptr;  // of the other number
  for (std::size_t i = at_; i > 0 && i + kMemory_tokens > at_; --i) {
    const std::size_t at = i - 1;
    const auto match = words_.features.At(tokens_, at);
    if (match.tokens == 0 || noted_.notes[at].agent) continue;
    if (noted_.notes[at].place && !placed) break;
    const std::string& last = tokens_[at + match.tokens - 1].text;
    const FeatureWord* word = match.rows.front();
    if ((Singular(last) != last) == plural)
      return FeaturePlace{word->name, word->suburb, word->wild, false, {}};
    if (other == nullptr) other = word;
  }
  if (other == nullptr || !placed) return std::nullopt;
  return FeaturePlace{other->name, other->suburb, other->wild, false, {}};
}

}  // namespace internal

}  // namespace latticeworld
