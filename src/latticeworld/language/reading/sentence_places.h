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

// Returns the step of the compass that a heading's name says ("north-east").
Heading HeadingOfName(std::string_view name);

// Returns the zones that a phrase of slot {zone} or {place} names: "the north and the center". A
// side that is named loosely is a third of the map, or a ninth; "the corners" are four zones.
std::vector<Zone> ZonesOf(const Phrase& phrase);

// Returns the zone where a line begins or ends that is said to come from a place: "the north" is
// the northern edge, "the north-west" the corner.
Zone EndZoneOf(const Phrase& phrase);

// These go the other way. They return what slot {heading} says of a step of the compass, what
// {zone} and {place} say of a zone, and what {end} says of the zone where a line ends. A zone that
// has no name in the small language is named as the ninth of its middle.
std::string HeadingName(Claim::Heading heading);
std::string PlaceName(const Zone& zone);
std::string EndName(const Zone& zone);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_SENTENCE_PLACES_H_
