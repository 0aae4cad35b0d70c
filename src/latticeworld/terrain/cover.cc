#include "latticeworld/terrain/cover.h"

#include <algorithm>
#include <cstddef>

#include "latticeworld/layout/class_letters.h"

namespace latticeworld::internal {

Grid<char> DominantLetters(const SmoothedMasks& masks) {
  const SmoothedMask& first = masks.classes.front();
  Grid<char> letters(first.weight.rows(), first.weight.cols(), first.letter);
  Grid<float> largest = first.weight;
  for (const SmoothedMask& entry : masks.classes) {
    const float* weight = entry.weight.data();
    float* best = largest.data();
    char* letter = letters.data();
    for (std::size_t i = 0; i < letters.size(); ++i) {
      const bool larger = weight[i] > best[i];
      best[i] = larger ? weight[i] : best[i];
      letter[i] = larger ? entry.letter : letter[i];
    }
  }
  return letters;
}

SurfaceClass SurfaceOf(Vocabulary vocabulary, char letter) {
  const bool suburb = vocabulary == Vocabulary::kSuburb;
  switch (letter) {
    case suburb_letter::kFarmland:
      return SurfaceClass::kFarmland;
    case suburb_letter::kBuilding:  // in wild: grassland
      return suburb ? SurfaceClass::kBuilding : SurfaceClass::kGrass;
    case suburb_letter::kBarren:
      return SurfaceClass::kBarren;
    case class_letter::kForest:
      return SurfaceClass::kForestFloor;
    case suburb_letter::kRoad:  // in wild: rocky land
      return suburb ? SurfaceClass::kRoad : SurfaceClass::kRock;
    case wild_letter::kSnow:
      return SurfaceClass::kSnow;
    case class_letter::kWater:
      return SurfaceClass::kWaterBed;
    default:
      return SurfaceClass::kGrass;
  }
}

Grid<unsigned char> MaskOf(char letter, const Grid<char>& letters) {
  Grid<unsigned char> mask(letters.rows(), letters.cols());
  std::transform(letters.begin(), letters.end(), mask.begin(),
                 [letter](char value) { return static_cast<unsigned char>(value == letter); });
  return mask;
}

}  // namespace latticeworld::internal
