#ifndef LATTICEWORLD_RENDERING_VIEWS_THEMATIC_MAP_H_
#define LATTICEWORLD_RENDERING_VIEWS_THEMATIC_MAP_H_

#include <array>
#include <cstdint>
#include <string>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/result.h"
#include "latticeworld/rendering/picture.h"

namespace latticeworld {

// One layer of the terrain as a map.
enum class MapTheme : std::uint8_t {
  kHeight,     // hypsometric tints over shaded relief, water in blue
  kHillshade,  // shaded relief alone, grey, the bed below the water
  kClasses,    // colours of the layout's classes, blended by Psi_L's weights
  kSketch      // the strokes that a person might draw of the land: blue valleys, black ridges
};
constexpr std::array<EnumName<MapTheme>, 4> EnumNames(MapTheme) {
  return {{{MapTheme::kHeight, "height"},
           {MapTheme::kHillshade, "hillshade"},
           {MapTheme::kClasses, "classes"},
           {MapTheme::kSketch, "sketch"}}};
}

// PNG of the world from above, north up, on a sheet with scale and caption; a sketch comes without
// one, as a visual instruction is given. Errors: INVALID_ARGUMENT (options).
Result<std::string> DrawThematicMap(const Scene& scene, MapTheme theme,
                                    const PictureOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_THEMATIC_MAP_H_
