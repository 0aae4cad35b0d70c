#ifndef LATTICEWORLD_RENDERING_LOOKS_BACKDROP_H_
#define LATTICEWORLD_RENDERING_LOOKS_BACKDROP_H_

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "latticeworld/rendering/ray/picture_light.h"

namespace latticeworld {

struct Scene;

// A painted sky, with clouds of the land's own and stars, behind a block of land (CV_8UC3). Where
// clouds or what blows cover all of it, there is no single cloud.
void PaintBackdrop(const Scene& scene, const PictureSky& sky, cv::Mat* bgr);
// The shade below the block, whose lower edge runs between the two [px].
void PaintBlockShade(const Eigen::Vector2f& left_px, const Eigen::Vector2f& right_px, cv::Mat* bgr);
// Rain and snow in the air before everything.
void PaintPrecipitation(const Scene& scene, cv::Mat* bgr);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_BACKDROP_H_
