#include "latticeworld/terrain/cover.h"

#include <algorithm>
#include <array>
#include <cstddef>

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
    case 'A':
      return SurfaceClass::kFarmland;
    case 'B':
      return suburb ? SurfaceClass::kBuilding : SurfaceClass::kGrass;
    case 'D':
      return SurfaceClass::kBarren;
    case 'F':
      return SurfaceClass::kForestFloor;
    case 'R':
      return suburb ? SurfaceClass::kRoad : SurfaceClass::kRock;
    case 'S':
      return SurfaceClass::kSnow;
    case 'W':
      return SurfaceClass::kWaterBed;
    default:
      return SurfaceClass::kGrass;
  }
}

Grid<SurfaceClass> SurfacesOf(Vocabulary vocabulary, const Grid<char>& letters) {
  std::array<SurfaceClass, 256> table;
  for (int i = 0; i < 256; ++i) table[i] = SurfaceOf(vocabulary, static_cast<char>(i));
  Grid<SurfaceClass> surfaces(letters.rows(), letters.cols());
  std::transform(letters.begin(), letters.end(), surfaces.begin(),
                 [&table](char letter) { return table[static_cast<unsigned char>(letter)]; });
  return surfaces;
}

Grid<unsigned char> MaskOf(char letter, const Grid<char>& letters) {
  Grid<unsigned char> mask(letters.rows(), letters.cols());
  std::transform(letters.begin(), letters.end(), mask.begin(),
                 [letter](char value) { return static_cast<unsigned char>(value == letter); });
  return mask;
}

}  // namespace latticeworld::internal
