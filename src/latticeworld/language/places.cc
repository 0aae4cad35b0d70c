#include "latticeworld/language/places.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/place_phrases.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/place_zones.h"

namespace latticeworld {
namespace {

// Places within places ("the north of the middle of the ...") are followed so deep.
constexpr int kMaxDepth = 2;

ReadPlace TakePlace(PlaceCursor* cursor, int depth);

// "halfway between the centre and the northern edge".
bool TakeBetween(PlaceCursor* cursor, int depth, ReadPlace* read) {
  if (!cursor->Take({"halfway", "midway"})) {
    const bool half_way = IsOneOf(cursor->word(), {"half", "mid"}) && cursor->word(1) == "way";
    if (half_way) cursor->Skip(2);
  }
  if (!cursor->Take({"between"})) return false;
  const ReadPlace first = TakePlace(cursor, depth);
  if (first.places.size() != 1 || first.of_other) return false;
  if (!cursor->Take({"and"})) return false;
  const ReadPlace second = TakePlace(cursor, depth);
  if (second.places.size() != 1 || second.of_other) return false;
  *read = FoundPlace(Between(first.places.front(), second.places.front()));
  return true;
}

// "halfway down the left side", "midway along the northern edge".
bool TakeHalfway(PlaceCursor* cursor, int depth, ReadPlace* read) {
  if (!cursor->Take({"halfway", "midway"})) {
    const bool half_way = IsOneOf(cursor->word(), {"half", "mid"}) && cursor->word(1) == "way";
    if (!half_way) return false;
    cursor->Skip(2);
  }
  if (!cursor->Take({"down", "up", "along", "across"})) return false;
  const ReadPlace side = TakePlace(cursor, depth);
  const Heading& heading = side.direction.heading;
  const bool one = side.places.size() == 1 && !side.of_other && side.direction.found;
  if (!one || side.direction.center || (heading.east != 0) == (heading.south != 0)) return false;
  Direction middle = side.direction;
  middle.center = true;
  *read = FoundPlace(MakePlace(middle, side.extent));
  return true;
}

// "a strip along the southern edge", "a narrow band across the middle".
bool TakeBand(PlaceCursor* cursor, int depth, ReadPlace* read) {
  cursor->Take({"a", "one"});
  // Adjectives say how wide the band is, and whether it runs down the map.
  bool narrow = false;
  bool wide = false;
  bool vertical = false;
  while (true) {
    if (cursor->Take({"narrow", "thin", "slim", "small", "slender"})) {
      narrow = true;
    } else if (cursor->Take({"wide", "broad", "thick", "large", "big"})) {
      wide = true;
    } else if (cursor->Take({"vertical", "upright"})) {
      vertical = true;
    } else if (!cursor->Take({"horizontal", "long", "continuous", "single", "straight"})) {
      break;
    }
  }
  if (!cursor->Take({"band", "strip", "stripe", "belt", "swathe", "swath", "ribbon", "zone",
                     "stretch", "border", "margin", "fringe"})) {
    return false;
  }
  if (!IsOneOf(cursor->word(), {"along", "across", "down", "at", "in", "on", "near", "against",
                                "through", "over", "up"})) {
    return false;
  }
  // The place behind the preposition is where the band lies.
  const std::string_view preposition = cursor->word();
  cursor->Skip(1);
  *read = TakePlace(cursor, depth);
  if (read->places.size() != 1 || read->of_other) return false;
  const Direction& direction = read->direction;
  if (!direction.found) return true;
  // If that place says no depth, adjectives and preposition give it.
  PlaceExtent extent = read->extent;
  if (extent.depth == PlaceDepth::kUnsaid || extent.depth == PlaceDepth::kSide) {
    const bool middle = direction.heading.east == 0 && direction.heading.south == 0;
    const bool columns = vertical || IsOneOf(preposition, {"down", "up"});
    if (middle) {
      extent.depth = columns ? PlaceDepth::kColumns : PlaceDepth::kRows;
    } else {
      extent.depth = wide                                               ? PlaceDepth::kThird
                     : narrow                                           ? PlaceDepth::kEdge
                     : IsOneOf(preposition, {"along", "at", "against"}) ? PlaceDepth::kEdge
                                                                        : PlaceDepth::kBand;
    }
    read->extent = extent;
    read->places = {MakePlace(direction, extent)};
  }
  return true;
}

bool BendsToBand(PlaceDepth depth) {
  return depth == PlaceDepth::kUnsaid || depth == PlaceDepth::kSide;
}

// "of the northern half" after a part of it.
bool TakeWholeOfPart(PlaceCursor* cursor, int depth, ReadPlace* read) {
  const std::size_t start = cursor->at();
  if (depth <= 0 || !cursor->Take({"of", "on"})) return false;
  const ReadPlace whole = TakePlace(cursor, depth - 1);
  const bool fits =
      whole.places.size() == 1 && !whole.of_other && !whole.places.front().zone.is_anywhere() &&
      !(whole.direction.found && whole.direction.center && whole.direction.heading.east == 0 &&
        whole.direction.heading.south == 0 && BendsToBand(whole.extent.depth));
  if (!fits) {
    cursor->set_at(start);
    return false;
  }
  const Direction& part = read->direction;
  const bool middle = part.center && part.heading.east == 0 && part.heading.south == 0;
  // "the middle of the right side": the ninth of that side, or of that edge.
  if (middle && whole.direction.found && !whole.direction.heading.IsDiagonal() &&
      (BendsToBand(whole.extent.depth) || whole.extent.depth == PlaceDepth::kEdge ||
       whole.extent.depth == PlaceDepth::kThird)) {
    Direction both = whole.direction;
    both.center = true;
    read->places = {MakePlace(both, whole.extent)};
  } else {
    read->places = {PartOf(part, read->places.front(), whole.places.front())};
  }
  read->direction = Direction();
  return true;
}

// "upper left", "the southern half", "northern and southern edges", "the top corners".
bool TakeDirectional(PlaceCursor* cursor, int depth, ReadPlace* read) {
  const std::string_view before = cursor->previous();
  const bool each = before == "each" || before == "every" || before == "per";
  // "both northern corners", "the two western quarters".
  if (cursor->Take({"both"})) cursor->Take({"the"});
  cursor->Take({"two"});
  std::vector<Direction> directions = {TakeDirection(cursor)};
  if (!directions.front().found) return false;
  // "north and south edges": one noun for all, which only a plural can be.
  const std::size_t after_first = cursor->at();
  while (cursor->Take({"and", "or"})) {
    cursor->Take({"the"});
    Direction next = TakeDirection(cursor);
    if (!next.found) break;
    directions.push_back(next);
  }
  if (directions.size() > 1 && !IsPluralOfPlace(cursor->word())) {
    directions.resize(1);
    cursor->set_at(after_first);
  } else if (directions.size() == 1) {
    cursor->set_at(after_first);
  }
  // The noun gives the extent, which is that of all directions.
  const Direction first = directions.front();
  const std::size_t noun_at = cursor->at();
  const PlaceExtent extent = TakeExtent(first, cursor);
  const bool plural =
      cursor->at() == noun_at + 1 && IsPluralOfPlace(cursor->tokens()[noun_at].text);
  const Heading& heading = first.heading;
  const bool cardinal = !heading.IsDiagonal() && (heading.east != 0 || heading.south != 0);
  read->direction = first;
  read->extent = extent;
  if (extent.depth == PlaceDepth::kCorner && cardinal && !first.center) {
    // "the top corners", "the western corner": the corners of that side.
    for (const Heading corner : kCornerHeadings) {
      if ((heading.east != 0 && corner.east != heading.east) ||
          (heading.south != 0 && corner.south != heading.south)) {
        continue;
      }
      Direction direction;
      direction.heading = corner;
      read->places.push_back(MakePlace(direction, extent));
    }
    if (!plural && !each) {
      // One of the two, whichever: both are its zone.
      std::vector<UnitBox> boxes;
      for (const Place& place : read->places) boxes.push_back(place.box);
      Place either = PlaceOfBoxes("corner of the " + MakePlace(first, {}).zone.name, boxes);
      either.main = RegionOf(heading);
      read->places = {std::move(either)};
    }
  } else {
    for (const Direction& direction : directions) {
      read->places.push_back(MakePlace(direction, extent));
    }
  }
  // "of the map", or of another part of it, may follow.
  if (directions.size() > 1 || read->places.size() > 1) read->direction = Direction();
  if (TakeWholeMap(cursor)) return true;
  if (read->places.size() == 1 && TakeWholeOfPart(cursor, depth, read)) {
    TakeWholeMap(cursor);
    return true;
  }
  read->of_other = cursor->word() == "of";
  return true;
}

ReadPlace TakePlace(PlaceCursor* cursor, int depth) {
  if (cursor->word().empty()) return {};
  const std::size_t start = cursor->at();
  ReadPlace read;
  // Each form is tried from the same place; what fails leaves nothing behind.
  const auto attempt = [&](std::size_t at, auto&& take) {
    cursor->set_at(at);
    if (take() && !read.places.empty()) return true;
    if (!read.places.empty()) read = ReadPlace();
    cursor->set_at(start);
    return false;
  };
  if (depth > 0 && attempt(start, [&] { return TakeBetween(cursor, depth - 1, &read); })) {
    return read;
  }
  if (depth > 0 && attempt(start, [&] { return TakeHalfway(cursor, depth - 1, &read); })) {
    return read;
  }
  if (attempt(start, [&] { return TakeBesideCenter(cursor, &read); })) return read;
  if (depth > 0 && attempt(start, [&] { return TakeBand(cursor, depth - 1, &read); })) return read;

  cursor->set_at(start);
  bool determined = cursor->Take({"the", "its", "our", "this", "that", "my", "your", "their"});
  // "all of the north", "the whole of the south" and "the entire northern half".
  const std::size_t before_whole = cursor->at();
  bool whole = cursor->Take({"whole", "entire", "complete", "full", "all"});
  if (whole) {
    cursor->Take({"of"});
    determined = cursor->Take({"the"}) || determined;
  }
  // "the map's northern edge".
  if (IsMapWord(cursor->word())) {
    const std::size_t before_map = cursor->at();
    cursor->Skip(1);
    PlaceCursor ahead = *cursor;
    if (!TakeDirection(&ahead).found &&
        !IsOneOf(cursor->word(), {"corners", "edges", "edge", "margins", "borders", "rim"})) {
      cursor->set_at(before_map);
    }
  }
  const std::size_t core = cursor->at();
  if (attempt(core, [&] { return TakeEverywhere(cursor, whole, &read); })) {
    read.whole = whole;
    return read;
  }
  // "all four corners" and "all corners" keep their "all".
  if (attempt(before_whole, [&] { return TakeGroup(cursor, &read); })) return read;
  if (attempt(core, [&] { return TakeGroup(cursor, &read); })) {
    read.whole = whole;
    return read;
  }
  if (attempt(core, [&] { return TakePictureWord(cursor, determined, &read); }) ||
      attempt(core, [&] { return TakeDirectional(cursor, depth, &read); })) {
    read.whole = whole;
    return read;
  }
  cursor->set_at(start);
  return {};
}

PlaceMatch MatchOf(ReadPlace read, std::size_t tokens) {
  PlaceMatch match;
  if (read.places.empty()) return match;
  match.places = std::move(read.places);
  match.tokens = tokens;
  match.of_other = read.of_other;
  match.whole = read.whole;
  return match;
}

}  // namespace

PlaceMatch MatchPlace(const std::vector<Token>& tokens, std::size_t at) {
  PlaceCursor cursor(tokens, at);
  ReadPlace read = TakePlace(&cursor, kMaxDepth);
  return MatchOf(std::move(read), cursor.at() - at);
}

PlaceMatch MatchPlaceAfter(std::string_view preposition, const std::vector<Token>& tokens,
                           std::size_t at) {
  PlaceCursor cursor(tokens, at);
  ReadPlace read = TakePlace(&cursor, kMaxDepth);
  if (read.direction.found && read.places.size() == 1 && !read.of_other &&
      BendsToBand(read.extent.depth)) {
    const Heading& heading = read.direction.heading;
    const bool middle = heading.east == 0 && heading.south == 0;
    PlaceDepth depth = read.extent.depth;
    if (IsOneOf(preposition, {"along", "alongside", "against", "skirting", "lining", "hugging",
                              "bordering", "fringing", "edging"})) {
      depth = middle ? PlaceDepth::kRows : PlaceDepth::kEdge;
    } else if (middle && preposition == "across") {
      depth = PlaceDepth::kRows;
    } else if (middle && IsOneOf(preposition, {"down", "up"})) {
      depth = PlaceDepth::kColumns;
    }
    if (depth != read.extent.depth) read.places = {MakePlace(read.direction, {depth})};
  }
  return MatchOf(std::move(read), cursor.at() - at);
}

HeadingMatch MatchHeading(const std::vector<Token>& tokens, std::size_t at) {
  PlaceCursor cursor(tokens, at);
  cursor.Take({"the", "its"});
  const Direction direction = TakeDirection(&cursor);
  if (!direction.found || direction.center) return {};
  cursor.Take({"side", "shore", "bank", "edge", "end", "flank", "coast", "margin", "border", "rim",
               "fringe", "shores", "banks", "slope", "slopes", "foot", "tip"});
  return {direction.heading, cursor.at() - at};
}

AxisMatch MatchAxis(const std::vector<Token>& tokens, std::size_t at) {
  const auto heading_at = [&](std::size_t i, std::size_t count) {
    // One word, or two for a diagonal: read alone, so that an opposite after it does not matter.
    Heading heading;
    if (i + count > tokens.size()) return heading;
    const std::string_view word = tokens[i].text;
    const bool between = (i > 0 && IsOneOf(tokens[i - 1].text, {"to"})) ||
                         (i + 1 < tokens.size() && tokens[i + 1].text == "to");
    if (count == 1 && between) {
      // "from up to down", "front to back"
      if (IsOneOf(word, {"up", "above", "back", "rear"})) return Heading{0, -1};
      if (IsOneOf(word, {"down", "below", "front"})) return Heading{0, 1};
    }
    const std::vector<Token> words(tokens.begin() + static_cast<std::ptrdiff_t>(i),
                                   tokens.begin() + static_cast<std::ptrdiff_t>(i + count));
    PlaceCursor cursor(words, 0);
    const Direction direction = TakeDirection(&cursor);
    if (direction.found && !direction.center && !direction.between && cursor.at() == count) {
      heading = direction.heading;
    }
    return heading;
  };
  for (const std::size_t first : {std::size_t{2}, std::size_t{1}}) {
    const Heading from = heading_at(at, first);
    if (from.east == 0 && from.south == 0) continue;
    std::size_t next = at + first;
    const auto is = [&](std::string_view word) {
      return next < tokens.size() && tokens[next].kind == TokenKind::kWord &&
             tokens[next].text == word;
    };
    if (is("to") || is("towards") || is("toward")) {
      ++next;
      if (is("the")) ++next;
    }
    for (const std::size_t second : {std::size_t{2}, std::size_t{1}}) {
      const Heading to = heading_at(next, second);
      const bool opposite = to.east == -from.east && to.south == -from.south;
      if (opposite && (to.east != 0 || to.south != 0)) return {from, to, next + second - at};
    }
  }
  return {};
}

Place PlaceOf(Region region) {
  if (region == Region::kAnywhere) return Everywhere();
  Direction direction;
  direction.heading = HeadingOf(region);
  direction.center = true;
  direction.found = true;
  return MakePlace(direction, {});
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

Zone ZoneOf(Heading heading) {
  Direction direction;
  direction.heading = heading;
  direction.center = heading.east == 0 && heading.south == 0;
  return MakePlace(direction, {}).zone;
}

Zone RimZoneOf(Heading heading) {
  Direction direction;
  direction.heading = heading;
  direction.center = heading.east == 0 && heading.south == 0;
  const bool middle = direction.center;
  return MakePlace(direction, {middle ? PlaceDepth::kUnsaid : PlaceDepth::kEdge}).zone;
}

}  // namespace latticeworld
