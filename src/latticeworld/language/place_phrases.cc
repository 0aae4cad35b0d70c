#include "latticeworld/language/place_phrases.h"

#include <initializer_list>
#include <string_view>
#include <utility>

namespace latticeworld {
namespace {

bool IsDeterminerOrPronoun(std::string_view word) {
  return IsOneOf(word, {"a", "an", "the", "this", "that", "its", "it", "them"});
}

bool TakeCornerNoun(PlaceCursor* cursor) { return cursor->Take({"corner", "corners", "angles"}); }

bool TakeEdgeNoun(PlaceCursor* cursor) {
  return cursor->Take({"edge",          "edges",    "border",     "borders",   "margin",
                       "margins",       "boundary", "boundaries", "rim",       "rims",
                       "fringe",        "fringes",  "periphery",  "perimeter", "outskirts",
                       "circumference", "outside",  "frontier",   "frontiers", "surroundings"});
}

void AddCorners(ReadPlace* read) {
  for (const Heading heading : kCornerHeadings) {
    Direction direction;
    direction.heading = heading;
    read->places.push_back(MakePlace(direction, {PlaceDepth::kCorner}));
  }
}

void AddSides(std::initializer_list<Heading> headings, PlaceDepth depth, ReadPlace* read) {
  for (const Heading heading : headings) {
    Direction direction;
    direction.heading = heading;
    read->places.push_back(MakePlace(direction, {depth}));
  }
}

// "edges" may be a verb ("a wood edges the lake"): it is a noun after a determiner, a preposition
// or a pause.
bool MayBeNoun(std::string_view previous) {
  return previous.empty() ||
         IsOneOf(previous,
                 {"the",       "all",     "its",     "along",   "at",   "around", "round",  "on",
                  "near",      "to",      "toward",  "towards", "from", "by",     "in",     "of",
                  "off",       "between", "and",     "or",      "map",  "whole",  "entire", "outer",
                  "outermost", "each",    "every",   "both",    "four", "these",  "this",   "my",
                  "hugging",   "lining",  "against", "onto",    "with"});
}

}  // namespace

ReadPlace FoundPlace(Place place) {
  ReadPlace read;
  read.places.push_back(std::move(place));
  return read;
}

bool TakeEverywhere(PlaceCursor* cursor, bool whole, ReadPlace* read) {
  if (cursor->Take({"everywhere", "anywhere", "wherever", "throughout"})) {
    TakeWholeMap(cursor);
    // "throughout the forest" is about the forest.
    if (cursor->word() == "of" || IsDeterminerOrPronoun(cursor->word())) return false;
  } else if (whole && IsMapWord(cursor->word()) && !IsOneOf(cursor->word(), {"whole"})) {
    cursor->Skip(1);
    if (cursor->word() == "of") return false;
  } else {
    return false;
  }
  *read = FoundPlace(Everywhere());
  return true;
}

bool TakeGroup(PlaceCursor* cursor, ReadPlace* read) {
  const std::size_t start = cursor->at();
  const std::string_view previous = cursor->previous();
  // Words before the noun say how many of them are meant: each, one or two.
  bool each = cursor->Take({"all", "each", "every", "any", "per"});
  bool one = false;
  bool two = false;
  if (!each && cursor->Take({"both", "either"})) two = true;
  if (!each && !two && cursor->Take({"one", "a", "some"})) one = true;
  cursor->Take({"of"});
  cursor->Take({"the", "its"});
  if (each && IsMapWord(cursor->word())) {  // "each of the map's edges"
    cursor->Skip(1);
    cursor->Take({"s"});
  }
  if (cursor->Take({"four", "4"})) each = true;
  if (cursor->Take({"two"})) two = true;
  const bool opposite = cursor->Take({"opposite", "opposing", "facing"});
  const bool outer = cursor->Take({"outer", "outermost", "extreme", "far", "very"});
  // If none of these words stands before the noun, the word before it must be one that a noun may
  // follow.
  const bool alone = cursor->at() == start;
  if (alone && !MayBeNoun(previous)) return false;
  const std::string_view noun = cursor->word();
  // The noun names corners, quadrants, sides, edges, the rim or the interior.
  if (TakeCornerNoun(cursor)) {
    if (opposite || (two && !each)) {
      AddSides({{-1, -1}, {1, 1}}, PlaceDepth::kCorner, read);
    } else if (one || (noun == "corner" && !each)) {
      read->places.push_back(AllCorners());
    } else {
      AddCorners(read);
    }
  } else if (each && cursor->Take({"quadrants", "quadrant", "quarters"})) {
    for (const Heading heading : kCornerHeadings) {
      Direction direction;
      direction.heading = heading;
      read->places.push_back(MakePlace(direction, {PlaceDepth::kQuarter}));
    }
  } else if (noun == "sides" || noun == "ends" || (noun == "side" && (each || two))) {
    cursor->Skip(1);
    if (two || opposite) {
      AddSides({{-1, 0}, {1, 0}}, PlaceDepth::kSide, read);
    } else {
      AddSides({{0, -1}, {-1, 0}, {1, 0}, {0, 1}}, PlaceDepth::kEdge, read);
    }
  } else if (TakeEdgeNoun(cursor)) {
    if (two || opposite) {
      AddSides({{-1, 0}, {1, 0}}, PlaceDepth::kEdge, read);
    } else if (each) {
      AddSides({{0, -1}, {-1, 0}, {1, 0}, {0, 1}}, PlaceDepth::kEdge, read);
    } else {
      read->places.push_back(AllEdges());
    }
  } else if (outer && cursor->Take({"ring", "part", "parts", "area", "areas", "zone", "band",
                                    "cells", "region", "regions", "belt", "frame", "strip"})) {
    read->places.push_back(AllEdges());
  } else if (alone && cursor->Take({"interior", "inland", "hinterland"})) {
    read->places.push_back(PlaceOfName("interior"));
  } else if (alone && cursor->Take({"inner"})) {
    if (!cursor->Take({"part", "parts", "area", "areas", "zone", "region", "cells", "land"})) {
      return false;
    }
    read->places.push_back(PlaceOfName("interior"));
  } else {
    return false;
  }
  // "of the map" may follow.
  TakeWholeMap(cursor);
  // "the edge of the forest" is no place of the map.
  return cursor->word() != "of";
}

bool TakeBesideCenter(PlaceCursor* cursor, ReadPlace* read) {
  const std::size_t start = cursor->at();
  if (cursor->Take({"a"})) {
    if (!cursor->Take({"little", "bit", "touch", "shade", "short", "few"})) return false;
    cursor->Take({"bit", "way", "distance", "cells"});
  } else {
    cursor->Take({"just", "slightly", "somewhat", "immediately", "directly", "right", "a", "little",
                  "closely", "shortly", "marginally"});
  }
  if (cursor->Take({"off"})) {
    if (!IsCenterWord(cursor->word())) return false;
    cursor->Skip(1);
    *read = FoundPlace(AroundCenter());
    return true;
  }
  cursor->Take({"to"});
  cursor->Take({"the"});
  const Direction direction = TakeDirection(cursor);
  if (!direction.found || direction.center) return false;
  cursor->Take({"side"});
  if (!cursor->Take({"of", "from"})) return false;
  cursor->Take({"the"});
  cursor->Take({"very", "exact", "dead", "map"});
  if (!cursor->Take({"center", "centre", "middle", "midpoint"})) return false;
  TakeWholeMap(cursor);
  if (cursor->word() == "of") {
    cursor->set_at(start);
    return false;
  }
  *read = FoundPlace(BesideCenter(direction.heading));
  return true;
}

bool TakePictureWord(PlaceCursor* cursor, bool determined, ReadPlace* read) {
  // In pictures north is far and south is near.
  if (cursor->Take({"far", "distant", "near", "immediate", "deep", "extreme"})) {
    const bool near = cursor->tokens()[cursor->at() - 1].text == "near" ||
                      cursor->tokens()[cursor->at() - 1].text == "immediate";
    if (cursor->Take({"background", "distance", "horizon"})) {
      *read = FoundPlace(PlaceOfName("northern quarter"));
    } else if (cursor->Take({"foreground"})) {
      *read = FoundPlace(PlaceOfName("southern quarter"));
    } else if (determined && cursor->Take({"end", "side"})) {
      *read = FoundPlace(PlaceOfName(near ? "southern third" : "northern third"));
    } else {
      return false;
    }
  } else if (cursor->Take({"background", "backdrop", "horizon", "skyline"})) {
    *read = FoundPlace(PlaceOfName("northern third"));
  } else if (cursor->Take({"foreground", "forefront"})) {
    *read = FoundPlace(PlaceOfName("southern third"));
  } else if (cursor->Take({"midground", "middleground"}) ||
             (cursor->word() == "middle" && IsOneOf(cursor->word(1), {"ground", "distance"}))) {
    if (cursor->word() == "middle") cursor->Skip(2);
    *read = FoundPlace(PlaceOfName("middle rows"));
  } else if (determined && cursor->Take({"back", "rear", "distance"})) {
    *read = FoundPlace(PlaceOfName("northern third"));
  } else if (determined && cursor->Take({"front"})) {
    *read = FoundPlace(PlaceOfName("southern third"));
  } else {
    // A diagonal falls unless it is said to rise.
    bool rising = cursor->Take({"rising", "other", "second", "anti", "secondary", "minor"});
    cursor->Take({"main", "falling", "first", "primary"});
    if (cursor->Take({"antidiagonal"})) {
      rising = true;
    } else if (!cursor->Take({"diagonal"})) {
      return false;
    }
    // "diagonal road": an adjective.
    if (!determined && !cursor->word().empty() &&
        !IsOneOf(cursor->word(), {"of", "from", "is", "to", "across"})) {
      return false;
    }
    *read = FoundPlace(Diagonal(!rising));
  }
  TakeWholeMap(cursor);
  return cursor->word() != "of" && cursor->word() != "yard" && cursor->word() != "garden";
}

}  // namespace latticeworld
