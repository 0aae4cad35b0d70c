#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_BAND_WORDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_BAND_WORDS_H_

#include <optional>
#include <string>
#include <string_view>

#include "latticeworld/language/places.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

// One of equal bands across the whole map, as a word that no instruction holds: "band#2/4e" is the
// second of four from the west to the east. What rewrites tokens names bands so, and the lexer
// reads them as places.
struct Band {
  static constexpr int kMost = 12;

  int nth = 1;  // 1 .. of
  int of = 2;   // 2 .. kMost
  Heading way;  // the order that they are counted in: to the east, west, north or south
};

std::string WordOf(const Band& band);
// nullopt: no such word.
std::optional<Band> BandNamed(std::string_view word);

// The part of the map from `low` to `high` of the way along the heading, 0 .. 1.
Zone BandZone(Heading way, double low, double high, const std::string& name);
// Halves, thirds and outer quarters have the names that FindZone knows.
Zone ZoneOfBand(const Band& band);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_BAND_WORDS_H_
