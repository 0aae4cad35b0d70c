#ifndef LATTICEWORLD_RENDERING_LOOKS_PICTURE_STYLE_H_
#define LATTICEWORLD_RENDERING_LOOKS_PICTURE_STYLE_H_

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/rendering/ray/picture_light.h"

namespace latticeworld {

// The palette of a style: what becomes of a natural colour.
Color InStyle(ArtisticStyle style, const Color& natural);
// The same for the sky.
void ApplyStyle(ArtisticStyle style, PictureSky* sky);

// How much wider and higher than they are things are drawn in views from the side. Styles are of
// pictures only: bodies, rays of sensors and maps meet things as they are.
struct Proportions {
  float width = 1.0f, height = 1.0f;
};
Proportions ProportionsOf(ArtisticStyle style, const AssetModel& model);

// Lamplight behind a window; draw in [0, 1) picks one where the style has several.
Color WindowLight(ArtisticStyle style, double draw);
// The rim of a road beside its surface.
Color RoadRim(ArtisticStyle style, const Color& road);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_PICTURE_STYLE_H_
