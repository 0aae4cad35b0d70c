#ifndef LATTICEWORLD_SCENE_VEGETATION_TREES_H_
#define LATTICEWORLD_SCENE_VEGETATION_TREES_H_

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/point_random.h"

namespace latticeworld {

// What growing in a crowd does to trees.
struct Stand {
  double slenderness = 40.0;  // height over diameter of the stem
  double height = 1.0;        // of a tree that grows by itself, (0, 1]
};

// Trees by themselves have stems of a fortieth of their height. The mean stem of a stand is at most
// what self-thinning leaves at its density, 700 stems a hectare of 25.4 cm and diameter^-1.605 as
// many of another (Reineke 1933, Perfecting a stand-density index for even-aged forests): the
// denser, the more slender, up to a hundred; what is denser still is lower too. Slenderness of 60
// to 100 in stands and 30 to 50 outside: Wang, Titus and LeMay 1998, Canadian Journal of Forest
// Research 28.
Stand StandOf(double mean_height_m, double stems_per_m2);

// Draws height, stem, crown and yaw of a tree of the model. vigour: (0, 1], 1 away from its limit
// of altitude. The crown's radius is exactly crown_per_trunk times the trunk's.
void SizeTree(const AssetModel& model, double vigour, double stems_per_m2, PointRandom* random,
              Asset* tree);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_VEGETATION_TREES_H_
