#include "latticeworld/layout/vocabulary.h"

#include "latticeworld/layout/class_letters.h"

namespace latticeworld {

const std::vector<LayoutClass>& ClassesOf(Vocabulary vocabulary) {
  static const std::vector<LayoutClass> kSuburb = {
      {suburb_letter::kFarmland, "farmland", "farmland: fields, orchards, crops", {255, 194, 128}},
      {suburb_letter::kBuilding, "building", "buildings: houses, villages, towns", {255, 0, 0}},
      {suburb_letter::kBarren,
       "barren land",
       "barren land: bare earth, sand, gravel",
       {157, 127, 183}},
      {class_letter::kForest, "forest", "forest: woodland, dense trees", {34, 139, 34}},
      {suburb_letter::kGrassland,
       "grassland",
       "grassland: meadows, lawns, pasture",
       {144, 238, 144}},
      {suburb_letter::kRoad, "road", "roads: streets, lanes, paths", {255, 255, 0}},
      {class_letter::kWater, "water", "water: lakes, rivers, ponds", {0, 0, 255}},
  };
  static const std::vector<LayoutClass> kWild = {
      {wild_letter::kGrassland, "grassland", "low bushes or grassland", {0, 128, 0}},
      {class_letter::kForest, "forest", "forest: woodland, dense trees", {0, 0, 0}},
      {wild_letter::kRock, "rocky land", "rocky land: bare rock, scree, cliffs", {128, 128, 128}},
      {wild_letter::kSnow, "snow", "snow-capped land: peaks, glaciers", {255, 255, 255}},
      {class_letter::kWater, "water", "water: lakes, rivers, ponds", {0, 0, 255}},
  };
  return vocabulary == Vocabulary::kSuburb ? kSuburb : kWild;
}

const LayoutClass* FindClass(Vocabulary vocabulary, char letter) {
  for (const LayoutClass& entry : ClassesOf(vocabulary)) {
    if (entry.letter == letter) return &entry;
  }
  return nullptr;
}

std::string_view LegalLetters(Vocabulary vocabulary) {
  return vocabulary == Vocabulary::kSuburb ? "A, B, D, F, G, R, W" : "B, F, R, S, W";
}

}  // namespace latticeworld
