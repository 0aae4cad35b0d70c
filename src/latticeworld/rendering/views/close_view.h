#ifndef LATTICEWORLD_RENDERING_VIEWS_CLOSE_VIEW_H_
#define LATTICEWORLD_RENDERING_VIEWS_CLOSE_VIEW_H_

#include <string>
#include <vector>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/rendering/picture.h"

namespace latticeworld {

// What somebody in the world sees.
struct CloseView {
  std::string name;                 // what it shows: "street", "shore", "forest", "hill"
  WorldPoint position;              // inside the world, not inside a solid asset
  double eye_height_m = 1.7;        // above the ground or the water, [0.1, 500]
  double heading_rad = 0.0;         // 0 east, counter-clockwise; finite
  double pitch_rad = -0.04;         // up from level, [-1.4, 1.4]
  double field_of_view_rad = 1.13;  // of the width, [0.2, 2.4]
};
std::vector<Violation> Validate(const Scene& scene, const CloseView& view);

// PNG, half again as wide as it is high, ray-traced in the light of the scene's weather and hour,
// without marks. Beyond the world's edge it goes on by mirror images. Errors: INVALID_ARGUMENT with
// everything that is wrong with options and view, RESOURCE_EXHAUSTED, INTERNAL, CANCELLED.
Result<std::string> DrawCloseView(const Scene& scene, const CloseView& view,
                                  const PictureOptions& options);

// The same for several, two in a row, in the order given.
Result<std::string> DrawCloseViews(const Scene& scene, const std::vector<CloseView>& views,
                                   const PictureOptions& options);

// Places worth a picture: along a street of a settlement, over water from its shore, a forest's
// edge, a far look from high ground; those of them that the world has, else "middle", any free
// place.
std::vector<CloseView> ChooseViews(const Scene& scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_CLOSE_VIEW_H_
