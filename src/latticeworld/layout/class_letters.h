#ifndef LATTICEWORLD_LAYOUT_CLASS_LETTERS_H_
#define LATTICEWORLD_LAYOUT_CLASS_LETTERS_H_

#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// The letters of the classes, by name. Those of water and forest are the same in both vocabularies;
// of the others some stand for one class in suburb and for another in wild, so each has its own
// name.
namespace class_letter {
inline constexpr char kForest = 'F';
inline constexpr char kWater = 'W';
}  // namespace class_letter

namespace suburb_letter {
inline constexpr char kFarmland = 'A';
inline constexpr char kBuilding = 'B';
inline constexpr char kBarren = 'D';
inline constexpr char kGrassland = 'G';
inline constexpr char kRoad = 'R';
}  // namespace suburb_letter

namespace wild_letter {
inline constexpr char kGrassland = 'B';
inline constexpr char kRock = 'R';
inline constexpr char kSnow = 'S';
}  // namespace wild_letter

constexpr bool IsRoad(Vocabulary vocabulary, char letter) {
  return vocabulary == Vocabulary::kSuburb && letter == suburb_letter::kRoad;
}
constexpr bool IsBuilding(Vocabulary vocabulary, char letter) {
  return vocabulary == Vocabulary::kSuburb && letter == suburb_letter::kBuilding;
}
// Roads, buildings and farmland.
constexpr bool IsManMade(Vocabulary vocabulary, char letter) {
  return IsRoad(vocabulary, letter) || IsBuilding(vocabulary, letter) ||
         (vocabulary == Vocabulary::kSuburb && letter == suburb_letter::kFarmland);
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CLASS_LETTERS_H_
