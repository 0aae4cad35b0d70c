#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLACE_PHRASES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLACE_PHRASES_H_

#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/sense.h"
#include "latticeworld/language/places.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

// Small questions about places and the words that say them.

std::vector<Zone> ZonesOf(const std::vector<Place>& places);
bool SaysAnywhere(const std::vector<Place>& places);  // "everywhere"
// "half", "third", "quarter" among the words of a place: all of it is meant.
bool SaysExtent(std::string_view words);
// The same of a zone, where the word itself was left out.
bool IsExtent(const Zone& zone);
// Returns the zone where a course ends; where the words give a side alone, it is the map's edge
// there.
Zone EndZoneOf(const Zone& zone, std::string_view words);
// "along the south" is along the southern edge.
Zone AlongZone(const Zone& zone);
// "riverside village": kRiverside, kLakeside or kNone, from a class word itself.
Sense BesideOf(const ClassWord& noun);
// Whether the phrase ends with this word, and has others before it.
bool EndsWithWord(std::string_view phrase, std::string_view word);
bool IsOppositeHeading(Heading a, Heading b);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLACE_PHRASES_H_
