#ifndef LATTICEWORLD_RENDERING_RAY_PRECIPITATION_H_
#define LATTICEWORLD_RENDERING_RAY_PRECIPITATION_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/sensing/camera/camera_model.h"
#include "latticeworld/sensing/sensed_world.h"

namespace latticeworld {

// Draws the drops or flakes near a camera into what it sees (RGB, row by row): streaks along the
// way that they fall and drift during its exposure, seen from the camera. Where they are depends on
// the world's time alone. Nothing in dry weather.
void DrawPrecipitation(const SensedWorld& world, const CameraModel& model, const RaySky& sky,
                       const Eigen::Isometry3d& map_from_optical, std::vector<std::uint8_t>* rgb);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_PRECIPITATION_H_
