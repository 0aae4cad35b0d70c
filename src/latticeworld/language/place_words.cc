#include "latticeworld/language/place_words.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>

namespace latticeworld {
namespace {

struct DirectionWord {
  std::string_view word;
  Heading heading;
  bool is_center = false;
  bool is_extreme = false;
};

constexpr Heading kNorth = {0, -1};
constexpr Heading kSouth = {0, 1};
constexpr Heading kWest = {-1, 0};
constexpr Heading kEast = {1, 0};
constexpr Heading kNorthEast = {1, -1};
constexpr Heading kNorthWest = {-1, -1};
constexpr Heading kSouthEast = {1, 1};
constexpr Heading kSouthWest = {-1, 1};

constexpr DirectionWord kDirections[] = {
    {"north", kNorth},
    {"northern", kNorth},
    {"northerly", kNorth},
    {"northward", kNorth},
    {"northwards", kNorth},
    {"northernmost", kNorth, false, true},
    {"northmost", kNorth, false, true},
    {"n", kNorth},
    {"top", kNorth},
    {"upper", kNorth},
    {"uppermost", kNorth, false, true},
    {"topmost", kNorth, false, true},
    {"south", kSouth},
    {"southern", kSouth},
    {"southerly", kSouth},
    {"southward", kSouth},
    {"southwards", kSouth},
    {"southernmost", kSouth, false, true},
    {"southmost", kSouth, false, true},
    {"s", kSouth},
    {"bottom", kSouth},
    {"lower", kSouth},
    {"lowermost", kSouth, false, true},
    {"lowest", kSouth, false, true},
    {"bottommost", kSouth, false, true},
    {"west", kWest},
    {"western", kWest},
    {"westerly", kWest},
    {"westward", kWest},
    {"westwards", kWest},
    {"westernmost", kWest, false, true},
    {"westmost", kWest, false, true},
    {"w", kWest},
    {"left", kWest},
    {"leftward", kWest},
    {"leftwards", kWest},
    {"leftmost", kWest, false, true},
    {"lefthand", kWest},
    {"east", kEast},
    {"eastern", kEast},
    {"easterly", kEast},
    {"eastward", kEast},
    {"eastwards", kEast},
    {"easternmost", kEast, false, true},
    {"eastmost", kEast, false, true},
    {"e", kEast},
    {"right", kEast},
    {"rightward", kEast},
    {"rightwards", kEast},
    {"rightmost", kEast, false, true},
    {"righthand", kEast},
    {"northeast", kNorthEast},
    {"northeastern", kNorthEast},
    {"northeasterly", kNorthEast},
    {"northeastward", kNorthEast},
    {"northeastwards", kNorthEast},
    {"northeasternmost", kNorthEast, false, true},
    {"ne", kNorthEast},
    {"northwest", kNorthWest},
    {"northwestern", kNorthWest},
    {"northwesterly", kNorthWest},
    {"northwestward", kNorthWest},
    {"northwestwards", kNorthWest},
    {"northwesternmost", kNorthWest, false, true},
    {"nw", kNorthWest},
    {"southeast", kSouthEast},
    {"southeastern", kSouthEast},
    {"southeasterly", kSouthEast},
    {"southeastward", kSouthEast},
    {"southeastwards", kSouthEast},
    {"southeasternmost", kSouthEast, false, true},
    {"se", kSouthEast},
    {"southwest", kSouthWest},
    {"southwestern", kSouthWest},
    {"southwesterly", kSouthWest},
    {"southwestward", kSouthWest},
    {"southwestwards", kSouthWest},
    {"southwesternmost", kSouthWest, false, true},
    {"sw", kSouthWest},
    {"topleft", kNorthWest},
    {"topright", kNorthEast},
    {"bottomleft", kSouthWest},
    {"bottomright", kSouthEast},
    {"upperleft", kNorthWest},
    {"upperright", kNorthEast},
    {"lowerleft", kSouthWest},
    {"lowerright", kSouthEast},
    {"center", {}, true},
    {"centre", {}, true},
    {"central", {}, true},
    {"centrally", {}, true},
    {"middle", {}, true},
    {"mid", {}, true},
    {"heart", {}, true},
    {"midst", {}, true},
    {"midpoint", {}, true},
    {"core", {}, true},
    {"centermost", {}, true},
    {"centremost", {}, true},
    {"centered", {}, true},
    {"centred", {}, true},
};

// The winds between the eight: "NNW" lies between north and north-west.
struct WindWord {
  std::string_view word;
  Heading diagonal;
  Heading nearer;
};
constexpr WindWord kWinds[] = {
    {"nne", kNorthEast, kNorth}, {"ene", kNorthEast, kEast},  {"ese", kSouthEast, kEast},
    {"sse", kSouthEast, kSouth}, {"ssw", kSouthWest, kSouth}, {"wsw", kSouthWest, kWest},
    {"wnw", kNorthWest, kWest},  {"nnw", kNorthWest, kNorth},
};

const DirectionWord* FindDirection(std::string_view word) {
  static const std::unordered_map<std::string_view, const DirectionWord*> by_word = [] {
    std::unordered_map<std::string_view, const DirectionWord*> built;
    for (const DirectionWord& direction : kDirections) built.emplace(direction.word, &direction);
    return built;
  }();
  const auto found = by_word.find(word);
  return found == by_word.end() ? nullptr : found->second;
}

bool IsCardinal(const Heading& heading) { return (heading.east != 0) != (heading.south != 0); }

// "right now", "left over", "the land that is left": words of direction that are none.
bool IsNoDirection(const PlaceCursor& cursor) {
  const std::string_view word = cursor.word();
  const std::string_view next = cursor.word(1);
  const std::string_view previous = cursor.previous();
  if (word == "right") {
    // "left and right along the road" names both sides.
    const bool sides = cursor.at() >= 2 && IsOneOf(cursor.tokens()[cursor.at() - 2].text,
                                                   {"left", "top", "bottom", "upper", "lower"});
    if (IsOneOf(previous, {"and", "or"}) &&
        (IsOneOf(next, {"in", "at", "by", "on", "next", "beside", "near", "under"}) ||
         (!sides && IsOneOf(next, {"beneath", "below", "above", "underneath", "behind", "around",
                                   "through", "along"})))) {
      return true;
    }
    if (IsOneOf(previous, {"the", "on", "upper", "lower", "top", "bottom", "far", "its", "middle",
                           "center", "centre", "central", "mid", "and", "or", "to", "from"})) {
      return false;
    }
    return IsOneOf(next,
                   {"next",   "beside",  "by",        "behind", "in",     "at",      "through",
                    "along",  "across",  "on",        "up",     "down",   "under",   "above",
                    "around", "after",   "now",       "away",   "here",   "there",   "near",
                    "inside", "into",    "over",      "to",     "and",    "before",  "outside",
                    "amid",   "among",   "below",     "beyond", "close",  "where",   "against",
                    "past",   "between", "alongside", "onto",   "within", "beneath", "underneath",
                    "atop",   "amidst",  "opposite"}) &&
           !(next == "and" && IsOneOf(cursor.word(2), {"left", "top", "bottom", "the"}));
  }
  if (word == "left") {
    if (IsOneOf(previous, {"the", "on", "upper", "lower", "top", "bottom", "far", "its", "middle",
                           "to", "from", "and", "center", "centre", "central", "mid"})) {
      return false;
    }
    if (IsOneOf(next, {"over", "free", "empty", "blank", "bare", "alone", "untouched", "fallow",
                       "open", "wild", "by", "unfilled", "unused", "without", "as"})) {
      return true;
    }
    return next != "of" &&
           IsOneOf(previous,
                   {"is",       "are",        "be",   "was",   "were", "nothing", "whatever",
                    "anything", "everything", "what", "still", "all",  "space",   "room",
                    "s",        "has",        "been", "land",  "area", "ground"});
  }
  // "a south-facing slope", "the north-bound lane", "lower than the lake".
  if (IsOneOf(next, {"facing", "bound"})) return true;
  if (word == "lower" || word == "upper") return next == "than";
  if (word == "top") return next == "it" || next == "up";
  if (word == "core") return next != "of" && !IsOneOf(previous, {"the", "very"});
  return false;
}

}  // namespace

bool IsOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string_view PlaceCursor::word(std::size_t ahead) const {
  const std::size_t i = at_ + ahead;
  return i < tokens_.size() && tokens_[i].kind == TokenKind::kWord ? tokens_[i].text
                                                                   : std::string_view();
}

std::string_view PlaceCursor::previous() const {
  return at_ > 0 && tokens_[at_ - 1].kind == TokenKind::kWord ? tokens_[at_ - 1].text
                                                              : std::string_view();
}

bool PlaceCursor::Take(std::initializer_list<std::string_view> words) {
  const std::string_view here = word();
  if (here.empty() || !IsOneOf(here, words)) return false;
  ++at_;
  return true;
}

bool IsCenterWord(std::string_view word) {
  const DirectionWord* direction = FindDirection(word);
  return direction != nullptr && direction->is_center;
}

Direction TakeDirection(PlaceCursor* cursor) {
  const std::size_t start = cursor->at();
  Direction direction;
  if (cursor->Take({"far", "extreme", "furthest", "farthest", "utmost"})) direction.extreme = true;
  if (cursor->Take({"very", "exact", "dead", "geometric", "precise", "true"})) {
    // "the very north" is far, "the very centre" is the centre.
    direction.extreme = !IsCenterWord(cursor->word());
  }
  const auto fail = [&] {
    cursor->set_at(start);
    return Direction();
  };
  // Winds between a cardinal and a diagonal have words of their own.
  for (const WindWord& wind : kWinds) {
    if (cursor->word() != wind.word) continue;
    cursor->Skip(1);
    direction.heading = wind.diagonal;
    direction.between = true;
    direction.nearer = wind.nearer;
    direction.found = true;
    return direction;
  }
  // Words add up, "upper" and "left", as long as they do not clash.
  while (const DirectionWord* word = FindDirection(cursor->word())) {
    const Heading& step = word->heading;
    const bool clash = word->is_center ? direction.center
                                       : (step.east != 0 && direction.heading.east != 0) ||
                                             (step.south != 0 && direction.heading.south != 0);
    if (clash) {
      const bool opposite = !word->is_center && (step.east * direction.heading.east < 0 ||
                                                 step.south * direction.heading.south < 0);
      if (opposite) return fail();
      break;
    }
    if (IsNoDirection(*cursor)) break;
    direction.found = true;
    direction.center = direction.center || word->is_center;
    direction.extreme = direction.extreme || word->is_extreme;
    direction.heading.east += step.east;
    direction.heading.south += step.south;
    cursor->Skip(1);
    if (step.east != 0) cursor->Take({"hand"});
    if (!word->is_center && cursor->Take({"most"})) direction.extreme = true;
  }
  if (!direction.found) return fail();
  // "north-north-west", "west by north-west": a cardinal, then a diagonal that holds it.
  if (IsCardinal(direction.heading) && !direction.center) {
    const std::size_t before = cursor->at();
    cursor->Take({"by"});
    Heading second;
    std::size_t words = 0;
    while (const DirectionWord* word = FindDirection(cursor->word())) {
      if (word->is_center || words == 2) break;
      second.east += word->heading.east;
      second.south += word->heading.south;
      cursor->Skip(1);
      ++words;
    }
    const bool holds =
        std::abs(second.east) == 1 && std::abs(second.south) == 1 &&
        (second.east == direction.heading.east || second.south == direction.heading.south);
    if (holds) {
      direction.between = true;
      direction.nearer = direction.heading;
      direction.heading = second;
    } else {
      cursor->set_at(before);
    }
  }
  return direction;
}

bool IsMapWord(std::string_view word) {
  return IsOneOf(
      word,
      {"map",         "world",   "scene",   "image",    "picture",     "layout",      "landscape",
       "land",        "terrain", "area",    "region",   "grid",        "place",       "country",
       "valley",      "site",    "square",  "frame",    "canvas",      "board",       "plot",
       "page",        "screen",  "sheet",   "tile",     "level",       "territory",   "view",
       "environment", "arena",   "drawing", "painting", "composition", "countryside", "plan",
       "whole",       "zone",    "setting", "space",    "sector",      "property",    "wild",
       "wilderness",  "wilds",   "parcel",  "biome",    "realm",       "kingdom",     "parish",
       "cells"});
}

bool TakeWholeMap(PlaceCursor* cursor) {
  const std::size_t start = cursor->at();
  if (cursor->Take({"of", "in", "on", "to"})) {
    cursor->Take({"the", "this", "our", "my", "your"});
    cursor->Take({"whole", "entire", "full", "overall"});
    if (IsMapWord(cursor->word())) {
      cursor->Skip(1);
      return true;
    }
  }
  cursor->set_at(start);
  return false;
}

}  // namespace latticeworld
