#include "latticeworld/language/grounded/places.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace latticeworld {
namespace {

enum class Extent { kThird, kHalf, kEdge };

struct DirectionWord {
  std::string_view word;
  Heading heading;
  bool is_center;
};
constexpr std::array<DirectionWord, 54> kDirections = {{
    {"north", {0, -1}, false},
    {"northern", {0, -1}, false},
    {"northward", {0, -1}, false},
    {"northwards", {0, -1}, false},
    {"northernmost", {0, -1}, false},
    {"top", {0, -1}, false},
    {"upper", {0, -1}, false},
    {"uppermost", {0, -1}, false},
    {"topmost", {0, -1}, false},
    {"south", {0, 1}, false},
    {"southern", {0, 1}, false},
    {"southward", {0, 1}, false},
    {"southwards", {0, 1}, false},
    {"southernmost", {0, 1}, false},
    {"bottom", {0, 1}, false},
    {"lower", {0, 1}, false},
    {"lowermost", {0, 1}, false},
    {"west", {-1, 0}, false},
    {"western", {-1, 0}, false},
    {"westward", {-1, 0}, false},
    {"westwards", {-1, 0}, false},
    {"westernmost", {-1, 0}, false},
    {"left", {-1, 0}, false},
    {"leftmost", {-1, 0}, false},
    {"lefthand", {-1, 0}, false},
    {"east", {1, 0}, false},
    {"eastern", {1, 0}, false},
    {"eastward", {1, 0}, false},
    {"eastwards", {1, 0}, false},
    {"easternmost", {1, 0}, false},
    {"right", {1, 0}, false},
    {"rightmost", {1, 0}, false},
    {"righthand", {1, 0}, false},
    {"northeast", {1, -1}, false},
    {"northeastern", {1, -1}, false},
    {"northwest", {-1, -1}, false},
    {"northwestern", {-1, -1}, false},
    {"southeast", {1, 1}, false},
    {"southeastern", {1, 1}, false},
    {"southwest", {-1, 1}, false},
    {"southwestern", {-1, 1}, false},
    {"ne", {1, -1}, false},
    {"nw", {-1, -1}, false},
    {"se", {1, 1}, false},
    {"sw", {-1, 1}, false},
    {"center", {0, 0}, true},
    {"centre", {0, 0}, true},
    {"central", {0, 0}, true},
    {"middle", {0, 0}, true},
    {"mid", {0, 0}, true},
    {"heart", {0, 0}, true},
    {"midst", {0, 0}, true},
    {"centermost", {0, 0}, true},
    {"centered", {0, 0}, true},
}};

bool IsOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class Cursor {
 public:
  Cursor(const std::vector<Token>& tokens, std::size_t at) : tokens_(tokens), at_(at) {}

  // "" at the end and at punctuation.
  std::string_view word(std::size_t ahead = 0) const {
    const std::size_t i = at_ + ahead;
    return i < tokens_.size() && tokens_[i].kind == TokenKind::kWord ? tokens_[i].text
                                                                     : std::string_view();
  }
  bool Take(std::initializer_list<std::string_view> words) {
    if (!IsOneOf(word(), words)) return false;
    ++at_;
    return true;
  }
  void Skip(std::size_t count) { at_ += count; }
  std::size_t at() const { return at_; }
  void set_at(std::size_t at) { at_ = at; }

 private:
  const std::vector<Token>& tokens_;
  std::size_t at_;
};

const DirectionWord* FindDirection(std::string_view word) {
  for (const DirectionWord& direction : kDirections) {
    if (direction.word == word) return &direction;
  }
  return nullptr;
}

struct Direction {
  Heading heading;
  bool center = false;  // a word for the middle was among the words
  bool found = false;
};

// "upper left", "left top", "middle right", "far north", "center": at most one word per axis.
Direction TakeDirection(Cursor* cursor) {
  Direction direction;
  cursor->Take({"far", "extreme", "very"});
  while (const DirectionWord* word = FindDirection(cursor->word())) {
    const Heading& step = word->heading;
    if (word->is_center ? direction.center
                        : (step.east != 0 && direction.heading.east != 0) ||
                              (step.south != 0 && direction.heading.south != 0)) {
      break;
    }
    // "right next to" and "right beside" are no places.
    if (word->word == "right" && IsOneOf(cursor->word(1), {"next", "beside", "by", "behind"})) {
      break;
    }
    direction.found = true;
    direction.center = direction.center || word->is_center;
    direction.heading.east += step.east;
    direction.heading.south += step.south;
    cursor->Skip(1);
    if (cursor->word() == "hand" && step.east != 0) cursor->Skip(1);
  }
  return direction;
}

void TakeWholeMap(Cursor* cursor) {
  const std::size_t start = cursor->at();
  if (!cursor->Take({"of", "in", "on"})) return;
  cursor->Take({"the", "this", "our", "my"});
  cursor->Take({"whole", "entire"});
  if (!cursor->Take({"map", "world", "scene", "image", "picture", "layout", "landscape", "land",
                     "terrain", "area", "region", "grid", "place", "country", "valley", "site"})) {
    cursor->set_at(start);
  }
}

// Bounds along one axis: step -1 is the low side, 1 the high side, 0 the middle or, where nothing
// was said of this axis, all of it.
void SetBounds(int step, bool said, Extent extent, double* low, double* high) {
  const double depth = extent == Extent::kHalf ? 0.5 : extent == Extent::kEdge ? 0.17 : 1.0 / 3.0;
  *low = 0.0;
  *high = 1.0;
  if (step < 0) *high = depth;
  if (step > 0) *low = 1.0 - depth;
  if (step == 0 && said) {
    *low = 1.0 / 3.0;
    *high = 2.0 / 3.0;
  }
}

Place MakePlace(const Direction& direction, Extent extent) {
  const Heading heading = direction.heading;
  const bool corner = heading.east != 0 && heading.south != 0;
  const bool middle = heading.east == 0 && heading.south == 0;
  // "middle left" names one ninth, "left" a whole side.
  const bool one_ninth = corner || middle || direction.center;
  Place place;
  place.main = RegionOf(heading);
  SetBounds(heading.east, one_ninth, extent, &place.box.u_min, &place.box.u_max);
  SetBounds(heading.south, one_ninth, extent, &place.box.v_min, &place.box.v_max);
  for (int south = -1; south <= 1; ++south) {
    for (int east = -1; east <= 1; ++east) {
      const bool column = heading.east == east || (!one_ninth && heading.east == 0);
      const bool row = heading.south == south || (!one_ninth && heading.south == 0);
      if (column && row) place.regions.push_back(RegionOf({east, south}));
    }
  }
  return place;
}

void AddHeadings(std::initializer_list<Heading> headings, Extent extent,
                 std::vector<Place>* places) {
  for (const Heading heading : headings) {
    places->push_back(MakePlace({heading, false, true}, extent));
  }
}

// "corners", "all four edges", "everywhere".
bool TakeGroupOfPlaces(Cursor* cursor, std::vector<Place>* places) {
  const std::size_t start = cursor->at();
  cursor->Take({"all", "each", "every", "both"});
  cursor->Take({"of"});
  cursor->Take({"the"});
  cursor->Take({"four", "sides"});
  if (cursor->word().empty() && cursor->at() > start) cursor->set_at(start);
  if (cursor->Take({"corner", "corners"})) {
    AddHeadings({{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}, Extent::kThird, places);
  } else if (cursor->Take({"edge", "edges", "border", "borders", "margin", "margins", "outskirts",
                           "periphery", "perimeter", "sides", "rim"})) {
    AddHeadings({{0, -1}, {-1, 0}, {1, 0}, {0, 1}}, Extent::kEdge, places);
  } else {
    cursor->set_at(start);
    return false;
  }
  TakeWholeMap(cursor);
  // "the edge of the forest" is no place of the map.
  if (cursor->word() != "of") return true;
  places->clear();
  cursor->set_at(start);
  return false;
}

bool TakePlace(Cursor* cursor, std::vector<Place>* places) {
  const std::size_t start = cursor->at();
  cursor->Take({"the", "its"});
  if (TakeGroupOfPlaces(cursor, places)) return true;
  Direction direction = TakeDirection(cursor);
  if (!direction.found) {
    cursor->set_at(start);
    return false;
  }
  Extent extent = Extent::kThird;
  if (cursor->Take({"half"})) {
    extent = Extent::kHalf;
  } else if (cursor->Take({"edge", "border", "margin", "boundary", "rim", "shore", "coast"})) {
    extent = direction.heading.east != 0 && direction.heading.south != 0 ? Extent::kThird
                                                                         : Extent::kEdge;
  } else {
    cursor->Take({"part", "parts", "side", "corner", "third", "quarter", "area", "region",
                  "section", "portion", "zone", "end", "sector", "quadrant", "strip"});
  }
  // "the middle of the right side": one ninth of the side.
  if (direction.center && direction.heading.east == 0 && direction.heading.south == 0) {
    const std::size_t after = cursor->at();
    if (cursor->Take({"of", "on", "to"})) {
      cursor->Take({"the"});
      Direction side = TakeDirection(cursor);
      if (side.found && !side.center) {
        cursor->Take({"edge", "side", "half", "part", "third", "border", "area"});
        direction.heading = side.heading;
      } else {
        cursor->set_at(after);
      }
    }
  }
  TakeWholeMap(cursor);
  places->push_back(MakePlace(direction, extent));
  return true;
}

}  // namespace

PlaceMatch MatchPlace(const std::vector<Token>& tokens, std::size_t at) {
  PlaceMatch match;
  Cursor cursor(tokens, at);
  if (!TakePlace(&cursor, &match.places)) return match;
  match.tokens = cursor.at() - at;
  return match;
}

HeadingMatch MatchHeading(const std::vector<Token>& tokens, std::size_t at) {
  Cursor cursor(tokens, at);
  cursor.Take({"the"});
  const Direction direction = TakeDirection(&cursor);
  if (!direction.found || direction.center) return {};
  cursor.Take({"side"});
  return {direction.heading, cursor.at() - at};
}

Place PlaceOf(Region region) {
  if (region == Region::kAnywhere) return {BoxOf(region), {}, region};
  return MakePlace({HeadingOf(region), true, true}, Extent::kThird);
}

Region RegionOf(Heading heading) {
  constexpr std::array<Region, 9> kRegions = {
      Region::kUpperLeft,  Region::kUpper,  Region::kUpperRight,
      Region::kMiddleLeft, Region::kCenter, Region::kMiddleRight,
      Region::kLowerLeft,  Region::kLower,  Region::kLowerRight};
  const int col = std::clamp(heading.east, -1, 1) + 1;
  const int row = std::clamp(heading.south, -1, 1) + 1;
  return kRegions[static_cast<std::size_t>(row * 3 + col)];
}

Heading HeadingOf(Region region) {
  if (region == Region::kAnywhere) return {};
  const int index = static_cast<int>(region);
  return {index % 3 - 1, index / 3 - 1};
}

}  // namespace latticeworld
