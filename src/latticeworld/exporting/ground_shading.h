#ifndef LATTICEWORLD_EXPORTING_GROUND_SHADING_H_
#define LATTICEWORLD_EXPORTING_GROUND_SHADING_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/exporting/ground_colors.h"
#include "latticeworld/exporting/picture_light.h"

namespace latticeworld {

struct Scene;

// The ground of a picture, one pixel a cell, row 0 north.
struct ShadedGround {
  cv::Mat color;  // CV_32FC3, lit, with water
  cv::Mat
      surface_m;  // CV_32FC1, drawn height: ground or water, above the lowest ground, exaggerated
  cv::Mat water;  // CV_32FC1, 0 dry .. 1 open water
  float exaggeration = 1.0f;
  float base_m = 0.0f;  // lowest ground
};

// How much heights are stretched so that gentle land still shows its shape: 1 for mountains.
float ReliefExaggeration(const Scene& scene);

// Lit relief with cast shadows of land and standing assets. largest_exaggeration caps the stretch
// of what is drawn; the shading itself always uses ReliefExaggeration.
ShadedGround ShadeGround(const Scene& scene, const GroundMaterials& materials,
                         const PictureLight& light, float largest_exaggeration);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_GROUND_SHADING_H_
