#ifndef LATTICEWORLD_DATASET_CAPTIONS_RELIEF_WORDS_H_
#define LATTICEWORLD_DATASET_CAPTIONS_RELIEF_WORDS_H_

#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/dataset/captions/phrase_book.h"
#include "latticeworld/geometry/region.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// What words can say of a relief.
struct ReliefFacts {
  double low_m = 0.0, high_m = 0.0;  // lowest and highest sample
  Region highest = Region::kCenter;  // the ninth with the highest mean
  Region lowest = Region::kCenter;   // the ninth with the lowest mean
  double means_m = 0.0;              // between the means of these two
  // A plane laid through the heights (least squares): the way it rises, and how much of the
  // heights' variance it explains. No heading: level.
  int rise_east = 0, rise_south = 0;  // a unit step of the compass
  double rise_m = 0.0;                // of the plane, from one side of the land to the other
  double rise_share = 0.0;            // [0, 1]
  bool middle_high = false;           // the middle ninth lies above all of the others
  bool middle_low = false;            // or below them
};
ReliefFacts FactsOf(const Relief& relief);

// The relief in words of a voice: where the land is high and low, which way it rises or falls and
// by how much. Regions are compass or picture words.
std::string WordRelief(const ReliefFacts& facts, Voice voice, bool picture, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_RELIEF_WORDS_H_
