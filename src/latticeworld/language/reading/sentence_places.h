#ifndef LATTICEWORLD_LANGUAGE_READING_SENTENCE_PLACES_H_
#define LATTICEWORLD_LANGUAGE_READING_SENTENCE_PLACES_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/places.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

// The step of the compass that a heading's name says ("north-east").
Heading HeadingOfName(std::string_view name);

// The zones of a phrase of slot {zone} or {place}: "the north and the center". A side that is said
// loosely is a third of the map, or a ninth; "the corners" are four zones.
std::vector<Zone> ZonesOf(const Phrase& phrase);

// Where a line begins or ends that is said to come from a place: "the north" is the northern edge,
// "the north-west" the corner.
Zone EndZoneOf(const Phrase& phrase);

// The other way: what slot {heading} says of a step of the compass, {zone} and {place} of a zone,
// and {end} of the zone where a line ends. A zone that has no name in the small language is said as
// the ninth of its middle.
std::string HeadingName(Claim::Heading heading);
std::string PlaceName(const Zone& zone);
std::string EndName(const Zone& zone);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_SENTENCE_PLACES_H_
