// Reading about agents: land that they are at.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"

namespace latticeworld {
namespace internal {
namespace {

constexpr std::size_t kViewTokens = 6;     // from land to where it is seen from
constexpr std::size_t kHeadingTokens = 6;  // of a clause that says something of land

}  // namespace

std::optional<FeaturePlace> AgentDiscourse::ReadFeature(std::size_t* end, bool near,
                                                        const PlaceMatch& place,
                                                        std::size_t place_at) const {
  std::size_t at = *end;
  bool relative = false;
  if (place.tokens > 0) {
    // "north of the lake"; "the northern lake" only narrows it down.
    if (noted_.IsWord(at, "of")) {
      relative = true;
      ++at;
    } else if (RoleAt(Role::kIn, at) > 0 || RoleAt(Role::kNear, at) > 0) {
      const std::size_t in = RoleAt(Role::kIn, at);
      const std::size_t beside = RoleAt(Role::kNear, at);
      near = beside > in;
      at += std::max(in, beside);
    }
  }
  const std::size_t shore = place_at + std::max<std::size_t>(1, place.tokens) - 1;
  if (!relative && !place.of_other && place.tokens > 1 && place.places.size() == 1 &&
      noted_.IsAnyWord(shore, {"shore", "shores", "bank", "banks"})) {
    // "on the western shore": of the lake, not of the map.
    const FeatureWord& word = *words_.features.At(tokens_, shore).rows.front();
    return FeaturePlace{
        word.name, word.suburb, word.wild, true, HeadingOf(place.places.front().main), true};
  }
  if (const auto far = ReadFarSide(&at); far.has_value()) {
    *end = at;
    return far;
  }
  bool outside = false;
  for (int i = 0; i < 4 && at < tokens_.size(); ++i) {
    if (noted_.IsPause(at)) return {};
    const auto match = words_.features.At(tokens_, at);
    if (match.tokens > 0) {
      const FeatureWord& word = *match.rows.front();
      // To sit on a stone is to be anywhere.
      if (word.name == "rock" && noted_.IsAnyWord(at - 1, {"a", "one"})) return {};
      FeaturePlace feature{word.name, word.suburb, word.wild, near || outside, {}};
      at += match.tokens;
      if (noted_.IsAnyWord(at, {"edge", "border", "margin", "shore", "side", "fringe", "bank",
                                "rim", "edges", "outskirts"})) {
        feature.near = true;
        ++at;
      }
      if (match.tokens > 1 && noted_.IsAnyWord(at - 1, {"edge", "margin", "border"})) {
        feature.near = true;
      }
      if (relative && place.places.size() == 1) {
        // "in the north of the forest" is inside, "north of the lake" is not.
        const bool inside =
            noted_.IsWord(place_at, "the") || (place_at > 0 && noted_.IsWord(place_at - 1, "the"));
        feature.shore = noted_.IsAnyWord(shore, {"shore", "shores", "bank", "banks"});
        feature.near = !inside || feature.shore;
        feature.on = HeadingOf(place.places.front().main);
      }
      if (place.tokens == 0) ReadOtherEnd(place_at, &feature, &at);
      *end = at;
      return feature;
    }
    if (noted_.IsAnyWord(at, {"edge", "edges", "shore", "shores", "bank", "banks", "fringe", "rim",
                              "border", "foot", "outskirts", "margin"})) {
      outside = true;
    } else if (words_.species.LengthAt(tokens_, at) > 0 || RoleAt(Role::kIn, at) > 0) {
      return {};
    }
    ++at;
  }
  return {};
}

std::optional<FeatureWord> AgentDiscourse::LandAt(std::size_t* at) const {
  constexpr std::size_t kAdjectives = 2;
  std::size_t next = *at;
  while (noted_.IsAnyWord(next, {"the", "a", "an", "its", "their", "this", "that", "our"})) ++next;
  for (std::size_t i = next; i <= next + kAdjectives && !noted_.IsPause(i); ++i) {
    const auto match = words_.features.At(tokens_, i);
    if (match.tokens == 0) continue;
    *at = i + match.tokens;
    return *match.rows.front();
  }
  return std::nullopt;
}

void AgentDiscourse::ReadOtherEnd(std::size_t first, FeaturePlace* feature,
                                  std::size_t* end) const {
  // The words before the land: "halfway between the", "from the".
  bool between = false, halfway = false, from = false;
  for (std::size_t i = first; i > 0 && i + 4 > first && !noted_.IsPause(i - 1); --i) {
    if (noted_.notes[i - 1].agent && !noted_.IsWord(i - 1, "from")) break;
    between = between || noted_.IsWord(i - 1, "between");
    from = from || noted_.IsWord(i - 1, "from");
  }
  for (std::size_t i = first; i > 0 && i + 6 > first && !noted_.IsPause(i - 1); --i) {
    halfway = halfway || noted_.IsAnyWord(i - 1, {"halfway", "midway"}) ||
              (noted_.IsWord(i - 1, "half") && noted_.IsWord(i, "way"));
  }
  if (!between && !from) return;
  std::size_t next = *end;
  if (!noted_.IsWord(next, between ? "and" : "to")) return;
  ++next;
  const auto other = LandAt(&next);
  if (!other.has_value() || other->name == feature->name) return;
  feature->way = halfway ? FeaturePlace::Way::kHalfway : FeaturePlace::Way::kBetween;
  feature->other_name = other->name;
  feature->other_suburb = other->suburb;
  feature->other_wild = other->wild;
  feature->near = false;
  *end = next;
}

bool AgentDiscourse::IsSharedOut(std::size_t at) const {
  for (std::size_t i = at; i > 0 && i + 4 > at && !noted_.IsPause(i - 1); --i) {
    if (noted_.IsAnyWord(i - 1,
                         {"split", "divided", "shared", "distributed", "spread", "halved"})) {
      return true;
    }
  }
  return false;
}

bool AgentReader::ShareOut(const FeaturePlace& feature, std::size_t index) {
  const int quantity = groups_[index].wish.quantity;
  if (feature.way != FeaturePlace::Way::kBetween || quantity < 2 || !IsSharedOut(at_)) return false;
  Group other = groups_[index];
  Group& group = groups_[index];
  FeaturePlace one = feature;
  one.way = FeaturePlace::Way::kNone;
  group.wish.feature = one;
  one.name = feature.other_name;
  one.suburb = feature.other_suburb;
  one.wild = feature.other_wild;
  other.wish.feature = one;
  const int half = quantity / 2;
  SetCount({half, half, half, 1}, &other);
  SetCount({quantity - half, quantity - half, quantity - half, 1}, &group);
  groups_.push_back(std::move(other));
  subject_ = {index, groups_.size() - 1};
  previous_ = subject_;
  return true;
}

std::optional<FeaturePlace> AgentDiscourse::ReadFarSide(std::size_t* at) const {
  std::size_t next = *at;
  if (!noted_.IsAnyWord(next, {"far", "other", "opposite"})) return std::nullopt;
  if (!noted_.IsAnyWord(next + 1, {"side", "shore", "bank", "end", "edge"}) ||
      !noted_.IsWord(next + 2, "of")) {
    return std::nullopt;
  }
  next += 3;
  const auto land = LandAt(&next);
  if (!land.has_value()) return std::nullopt;
  FeaturePlace feature{land->name, land->suburb, land->wild, true, {}};
  feature.way = FeaturePlace::Way::kBehind;
  feature.other_suburb = "B";  // where people look from, unless it is said
  *at = next;
  for (std::size_t i = next; i < next + kViewTokens && !noted_.IsEnd(i); ++i) {
    if (!noted_.IsWord(i, "from")) continue;
    std::size_t view = i + 1;
    const auto other = LandAt(&view);
    if (!other.has_value()) break;
    feature.other_suburb = other->suburb;
    feature.other_wild = other->wild;
    *at = view;
    break;
  }
  return feature;
}

bool AgentDiscourse::IsHeading(std::size_t at) const {
  const std::size_t feature = words_.features.LengthAt(tokens_, at);
  if (feature == 0 || words_.species.LengthAt(tokens_, at) > 0) return false;
  const auto is_colon = [&](std::size_t i) {
    return i < tokens_.size() && tokens_[i].kind == TokenKind::kComma && tokens_[i].text != ",";
  };
  if (is_colon(at + feature)) return true;
  // "The village is quiet: two dogs doze."
  std::size_t first = at;
  while (first > 0 && noted_.IsAnyWord(first - 1, {"the", "our", "this"})) --first;
  if (first > 0 && tokens_[first - 1].kind != TokenKind::kStop) return false;
  if (!noted_.IsAnyWord(at + feature, {"is", "are", "looks", "lies", "seems", "has"})) return false;
  std::size_t i = at + feature;
  while (i < at + feature + kHeadingTokens && !noted_.IsPause(i) &&
         words_.species.LengthAt(tokens_, i) == 0) {
    ++i;
  }
  return is_colon(i) && tokens_[i].text == ":";
}

bool AgentDiscourse::IsFilled(std::size_t at) const {
  const std::size_t feature = words_.features.LengthAt(tokens_, at);
  if (feature == 0 || words_.species.LengthAt(tokens_, at) > 0) return false;
  std::size_t next = at + feature;
  while (noted_.IsAnyWord(next, {"is", "are", "must", "should", "be", "will", "being", "all",
                                 "completely", "totally", "just", "now", "shall"})) {
    ++next;
  }
  const bool given =
      (noted_.IsAnyWord(next, {"belongs", "belong"}) && noted_.IsWord(next + 1, "to")) ||
      (lead_.set && next == at + feature && noted_.IsWord(next, "to"));
  const bool holds =
      given ||
      noted_.IsAnyWord(next, {"has", "have", "contains", "contain", "hosts", "houses", "gets"}) ||
      (noted_.IsAnyWord(next, {"full", "filled", "teeming", "crawling", "swarming", "packed",
                               "crowded", "home", "populated", "inhabited", "occupied", "bustling",
                               "overrun", "infested", "lively"}) &&
       noted_.IsAnyWord(next + 1, {"of", "with", "to", "by"}));
  return holds && AgentsAhead(next);
}

}  // namespace internal

}  // namespace latticeworld
