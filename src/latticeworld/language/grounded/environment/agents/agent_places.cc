// Reading about agents: where agents are.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"

namespace latticeworld {
namespace internal {

std::size_t AgentDiscourse::SurroundingsAt(std::size_t at) const {
  if (!noted_.IsAnyWord(at, {"with", "having"})) return 0;
  bool turned = false;
  std::size_t end = at + 1;
  for (; !noted_.IsPause(end); ++end) {
    if (words_.species.LengthAt(tokens_, end) > 0) return 0;
    turned = turned || (noted_.IsAnyWord(end, {"its", "their", "his", "her", "our"}) &&
                        end + 1 < tokens_.size() && MatchHeading(tokens_, end + 1).tokens > 0);
  }
  return turned ? end - at : 0;
}

std::size_t AgentReader::ReadPlace() {
  if (const std::size_t aside = SurroundingsAt(at_); aside > 0) {
    noted_.Mark(at_, at_ + aside, &TokenNote::place);
    return aside;
  }
  if (IsPlaceOfAssets()) return 0;
  if (const std::size_t facing = FacingAt(at_); facing > 0) {
    Known(facing);
    return words_.states.LengthAt(tokens_, at_) > 0 ? 0 : facing;
  }
  if (const std::size_t there = ReadThere(); there > 0) return there;
  PlacePhrase phrase = PlacePhraseHere();
  if (phrase.end == 0) return 0;
  const std::size_t tokens = phrase.end - at_;
  if (IsDeniedBehind(phrase.end)) {
    Known(tokens);
    return tokens;
  }
  const bool fronted = !FollowsAside() && !phrase.listed && IsFronted(phrase.end);
  const std::vector<std::size_t> owners = OwnersOf(phrase, fronted);
  if (phrase.listed && !owners.empty() && StandsBeside(phrase.feature, owners.back())) {
    phrase.feature->near = true;
  }
  there_ = phrase.place.places;
  there_feature_ = phrase.feature;
  if (owners.empty() && !fronted && (!AgentsAhead(phrase.end) || EndsOtherClause(phrase.end))) {
    return 0;
  }
  noted_.Mark(at_, phrase.end, &TokenNote::place);
  // "no goblins in the north": nobody is there.
  if (phrase.negated && !absent_here_) {
    TakeBackPlace(phrase.place, phrase.feature, owners.empty() ? previous_ : owners);
  }
  if (phrase.negated || (absent_here_ && owners.empty())) return tokens;
  if (!fronted && owners.size() == 1 && phrase.feature.has_value() &&
      ShareOut(*phrase.feature, owners.front())) {
    return tokens;
  }
  SetPlace(phrase.place.places, phrase.feature, phrase.each,
           fronted ? std::vector<std::size_t>{} : owners, phrase.end);
  return tokens;
}

bool AgentDiscourse::IsPlaceOfAssets() const {
  // "knights in the village, stones everywhere": where the stones are.
  return noted_.IsWord(at_, "everywhere") && at_ > 1 && noted_.IsPause(at_ + 1) &&
         !noted_.notes[at_ - 1].agent &&
         (words_.assets.LengthAt(tokens_, at_ - 1) > 0 ||
          words_.assets.LengthAt(tokens_, at_ - 2) > 1);
}

std::size_t AgentDiscourse::FacingAt(std::size_t at) const {
  const std::size_t facing = RoleAt(Role::kFacing, at);
  if (facing == 0) return 0;
  std::size_t next = at + facing;
  while (noted_.IsAnyWord(next, {"to", "the", "towards", "toward", "due"})) ++next;
  const PlaceMatch heading = next < tokens_.size() ? MatchPlace(tokens_, next) : PlaceMatch{};
  if (heading.tokens == 0 || noted_.IsAnyWord(at + facing, {"in", "on", "at"})) return 0;
  return next + heading.tokens - at;
}

PlacePhrase AgentDiscourse::PlacePhraseHere() const {
  PlacePhrase phrase;
  const std::size_t in = RoleAt(Role::kIn, at_);
  const std::size_t near = RoleAt(Role::kNear, at_);
  const std::size_t preposition = std::max(in, near);
  // A longer phrase of another kind ("in the air", "on the hunt") is none of a place.
  if (words_.states.LengthAt(tokens_, at_) > preposition) return phrase;
  std::size_t next = at_ + preposition;
  while (noted_.IsAnyWord(
      next, {"the", "a", "an", "its", "their", "this", "each", "every", "all", "our", "that"})) {
    // "all four corners" and "the left" are MatchPlace's own.
    if (MatchPlace(tokens_, next).tokens > 1) break;
    phrase.each = phrase.each || noted_.IsAnyWord(next, {"each", "every"});
    ++next;
  }
  if (next >= tokens_.size() || noted_.IsPause(next)) return phrase;
  if (noted_.IsAnyWord(next, {"each", "every"})) phrase.each = true;
  phrase.negated = noted_.notes[next].negated;
  phrase.place = MatchPlace(tokens_, next);
  // "guards the village", "circling the lake": the object is the place.
  const bool object = preposition == 0 && verb_end_ == at_;
  const bool heading = preposition == 0 && clause_open_ && (IsHeading(next) || IsFilled(next));
  const std::size_t land = words_.features.LengthAt(tokens_, next);
  phrase.listed = preposition == 0 && IsListedLand(next, land);
  const bool told = preposition > 0 || object || heading || phrase.listed;
  if (!told && !IsBarePlace(phrase.place, next)) return phrase;
  std::size_t end = next + phrase.place.tokens;
  phrase.feature = ReadFeature(&end, near > in, phrase.place, next);
  if (phrase.place.tokens == 0 && !phrase.feature.has_value()) return phrase;
  phrase.end = end;
  if (phrase.feature.has_value() && phrase.place.tokens == 0) {
    MoveByPreposition(preposition, end == next + land, &*phrase.feature);
  }
  return phrase;
}

bool AgentDiscourse::IsListedLand(std::size_t at, std::size_t land) const {
  // "4 rovers, road, parked", "Location: forest."
  return land > 0 && at_ > 0 && at <= at_ + 1 && noted_.IsPause(at_ - 1) &&
         noted_.IsPause(at + land) && IsBareLand(at + land);
}

void AgentDiscourse::MoveByPreposition(std::size_t preposition, bool bare,
                                       FeaturePlace* feature) const {
  if (!feature->near && preposition > 1 &&
      noted_.IsAnyWord(at_ + preposition - 2, {"middle", "centre", "center", "heart"})) {
    feature->on = Heading{};  // "in the middle of the lake"
  }
  // Only water is too deep to stand in.
  if (feature->near && preposition == 1 && noted_.IsWord(at_, "at") && feature->name != "water" &&
      bare) {
    feature->near = false;
  }
}

bool AgentDiscourse::IsDeniedBehind(std::size_t end) const {
  if (end >= tokens_.size() || tokens_[end].kind != TokenKind::kComma || tokens_[end].text == ",") {
    return false;
  }
  const std::size_t next = end + 1;
  return next < tokens_.size() &&
         (RoleAt(Role::kNobody, next) > 0 || noted_.IsAnyWord(next, {"none", "nothing"}));
}

std::vector<std::size_t> AgentDiscourse::OwnersOf(const PlacePhrase& phrase, bool fronted) const {
  std::vector<std::size_t> owners = Owners();
  if (!owners.empty()) return owners;
  if (phrase.listed && IsLabel(at_)) return previous_;
  if (fronted) return {};
  const bool goes_on = !AgentsAhead(phrase.end) && !absent_here_ && IsFragment();
  return phrase.negated || goes_on ? previous_ : std::vector<std::size_t>{};
}

bool AgentDiscourse::FollowsAside() const {
  // "a robot (on patrol) in the village, ..." is said of the robot.
  std::size_t aside = at_;
  while (aside > 0 &&
         (noted_.IsAnyWord(aside - 1, {"are", "is", "were", "was"}) ||
          (noted_.notes[aside - 1].agent && words_.states.LengthAt(tokens_, aside - 1) == 1))) {
    --aside;
  }
  return aside > 0 && tokens_[aside - 1].text == ")" && !subject_.empty();
}

bool AgentDiscourse::StandsBeside(const std::optional<FeaturePlace>& land,
                                  std::size_t index) const {
  return land.has_value() && land->name == "water" &&
         LocomotionOf(groups_[index].wish.categories.front()) <= Locomotion::kLegs;
}

void AgentReader::TakeBackPlace(const PlaceMatch& place, const std::optional<FeaturePlace>& feature,
                                const std::vector<std::size_t>& owners) {
  for (const std::size_t index : owners) {
    AgentWish& wish = groups_[index].wish;
    const bool same_land =
        feature.has_value() && wish.feature.has_value() && feature->name == wish.feature->name;
    const bool same_place = !place.places.empty() && !wish.places.empty() &&
                            place.places.front().main == wish.places.front().main;
    if (!same_land && !same_place) continue;
    wish.ForgetPlace();
    corrected_ = true;
  }
}

bool AgentDiscourse::IsLabel(std::size_t at) const {
  return at > 1 && tokens_[at - 1].text == ":" &&
         noted_.IsAnyWord(at - 2, {"location", "place", "where", "position", "area", "zone", "at",
                                   "site", "region", "habitat"});
}

bool AgentDiscourse::IsBareLand(std::size_t end) const {
  if (IsLabel(at_)) return true;
  // The land is said of who was named right before, and more is said of them, or nothing at all.
  return !subject_.empty() && tokens_[at_ - 1].kind == TokenKind::kComma && at_ > 1 &&
         (noted_.notes[at_ - 2].agent || noted_.notes[at_ - 2].place) &&
         words_.variants.LengthAt(tokens_, end + 1) == 0;
}

bool AgentDiscourse::EndsOtherClause(std::size_t end) const {
  if (end + 2 >= tokens_.size() || tokens_[end].kind != TokenKind::kComma ||
      !noted_.IsWord(end + 1, "and")) {
    return false;
  }
  return noted_.IsAnyWord(end + 2, {"a", "an", "the"}) ||
         ReadCount(noted_, words_, end + 2).tokens > 0 ||
         words_.species.LengthAt(tokens_, end + 2) > 0;
}

std::size_t AgentReader::ReadThere() {
  if (!noted_.IsWord(at_, "there") || (there_.empty() && !there_feature_.has_value())) return 0;
  const bool open = noted_.IsPause(at_ + 1) || words_.states.LengthAt(tokens_, at_ + 1) > 0;
  if (!open || clause_open_ || subject_.empty() || noted_.notes[at_].negated) return 0;
  for (const std::size_t index : subject_) {
    const AgentWish& wish = groups_[index].wish;
    if (wish.IsPlaced()) return 0;
  }
  SetPlace(there_, there_feature_, false, subject_, at_ + 1);
  return 1;
}

std::vector<std::size_t> AgentDiscourse::Owners() const {
  std::vector<std::size_t> owners = subject_;
  if (owners.empty() && (corrected_ || ContinuesPrevious())) owners = previous_;
  if (object_ != kNone) owners.push_back(object_);
  return owners;
}

bool AgentDiscourse::IsFragment() const {
  if (previous_.empty()) return false;
  std::size_t first = at_;
  while (first > 0 && tokens_[first - 1].kind != TokenKind::kStop) --first;
  for (std::size_t i = first; i < at_; ++i) {
    if (tokens_[i].kind == TokenKind::kComma || noted_.notes[i].agent) continue;
    if (RoleAt(Role::kFunction, i) == 0 || words_.coarse.LengthAt(tokens_, i) > 0 ||
        words_.assets.LengthAt(tokens_, i) > 0 ||
        noted_.IsAnyWord(i, {"sun", "sky", "it", "there", "weather", "light", "wind"})) {
      return false;
    }
  }
  return true;
}

bool AgentDiscourse::ContinuesPrevious() const {
  return !previous_.empty() && at_ > 0 && noted_.IsWord(at_ - 1, "all");
}

bool AgentDiscourse::IsBarePlace(const PlaceMatch& place, std::size_t at) const {
  if (place.tokens == 0) return false;
  const std::size_t end = at + place.tokens;
  if (place.tokens == 1 && noted_.IsAnyWord(at, {"left", "right", "top", "bottom", "middle", "mid",
                                                 "heart", "midst", "sides", "border", "rim"})) {
    return noted_.IsPause(end) && !subject_.empty();
  }
  if (noted_.IsPause(end) || place.tokens > 1) return true;
  if (noted_.IsWord(end, "of")) {
    // "nine sheep south of the village"
    std::size_t land = end + 1;
    while (noted_.IsAnyWord(land, {"the", "a", "an", "our", "their", "that", "this"})) ++land;
    return land < tokens_.size() && words_.features.LengthAt(tokens_, land) > 0;
  }
  return EndsNounPhrase(end) || ReadCount(noted_, words_, end).tokens > 0 ||
         words_.features.LengthAt(tokens_, end) > 0;
}

bool AgentDiscourse::IsFronted(std::size_t end) const {
  if (!clause_open_) return false;
  std::size_t at = end;
  if (at < tokens_.size() && tokens_[at].kind == TokenKind::kComma) ++at;
  if (const std::size_t aside = SurroundingsAt(at); aside > 0 && !noted_.IsEnd(at + aside)) {
    at += aside + 1;
  }
  // "under the oak, leaning on his spear, a knight"
  if (at > end && !noted_.IsPause(at) && IsDoing(at)) {
    std::size_t pause = at;
    while (!noted_.IsPause(pause)) ++pause;
    if (!noted_.IsEnd(pause)) at = pause + 1;
  }
  std::size_t plain = 0;
  for (std::size_t i = at; plain < kPhraseTokens && !noted_.IsPause(i);) {
    const Count count = ReadCount(noted_, words_, i);
    if (count.tokens > 0 && i + count.tokens < tokens_.size() &&
        RoleAt(Role::kOfThem, i + count.tokens) > 0) {
      return false;  // "three of them" were named before
    }
    // "in the north and in the south, ten each"
    const std::size_t after = i + count.tokens;
    if (count.tokens > 0 && (noted_.IsAnyWord(after, {"each", "apiece"}) ||
                             noted_.IsAnyWord(after + 1, {"each", "every"}))) {
      return false;
    }
    if (words_.species.LengthAt(tokens_, i) > 0 || count.tokens > 0 ||
        (noted_.IsWord(i, "another") && !groups_.empty())) {
      return true;
    }
    // "on the bridge between them stands a knight"
    if (const std::size_t phrase = PlacePhraseAt(i); phrase > 0) {
      i += phrase;
      if (i < tokens_.size() && tokens_[i].kind == TokenKind::kComma) ++i;
      continue;
    }
    // "the north belongs to the goblins"
    const bool given = noted_.IsAnyWord(i, {"to", "by", "for", "of"}) && i > 0 &&
                       (noted_.IsAnyWord(i - 1, {"belongs", "belong", "goes", "held", "home",
                                                 "given", "full", "reserved", "occupied"}) ||
                        (i == at && lead_.set && noted_.IsWord(i, "to")));
    if (!given &&
        (RoleAt(Role::kIn, i) > 0 || RoleAt(Role::kNear, i) > 0 || noted_.IsWord(i, "and"))) {
      return false;
    }
    ++i;
    ++plain;
  }
  return false;
}

std::size_t AgentDiscourse::PlacePhraseAt(std::size_t at) const {
  constexpr std::size_t kAdjectives = 2;
  const std::size_t preposition = std::max(RoleAt(Role::kIn, at), RoleAt(Role::kNear, at));
  if (preposition == 0) return 0;
  std::size_t next = at + preposition;
  if (noted_.IsAnyWord(next, {"them", "it", "him", "her", "both"})) return preposition + 1;
  while (noted_.IsAnyWord(next, {"the", "a", "an", "its", "their", "this", "that", "our"})) ++next;
  for (std::size_t i = next; i <= next + kAdjectives && !noted_.IsPause(i); ++i) {
    if (words_.species.LengthAt(tokens_, i) > 0) return 0;
    const std::size_t land =
        std::max(words_.features.LengthAt(tokens_, i), MatchPlace(tokens_, i).tokens);
    if (land > 0) return i + land - at;
  }
  return 0;
}

bool AgentDiscourse::IsPlaceList(std::size_t at) const {
  constexpr std::size_t kLength = 12;
  for (std::size_t i = at; i < at + kLength && !noted_.IsEnd(i); ++i) {
    if (noted_.IsAnyWord(i, {"and", "or"})) {
      std::size_t next = i + 1;
      next += std::max(RoleAt(Role::kIn, next), RoleAt(Role::kNear, next));
      while (noted_.IsAnyWord(next, {"the", "a"})) ++next;
      return next < tokens_.size() &&
             (MatchPlace(tokens_, next).tokens > 0 || words_.features.LengthAt(tokens_, next) > 0);
    }
    if (words_.species.LengthAt(tokens_, i) > 0 || words_.states.LengthAt(tokens_, i) > 0) {
      return false;
    }
  }
  return false;
}

}  // namespace internal

}  // namespace latticeworld
