#ifndef LATTICEWORLD_RENDERING_LOOKS_SENSOR_COLOURS_H_
#define LATTICEWORLD_RENDERING_LOOKS_SENSOR_COLOURS_H_

#include <memory>

#include "latticeworld/sensing/sensor_rig.h"

namespace latticeworld {

struct Scene;

// What a robot's colour camera sees of a running world: ground, water, plants, houses, bodies and
// props in the light of its sun or moon, with shadows, under its sky and through its air, wet or
// under snow as the weather has made it. A sample a pixel, an open shutter of no length; the
// lenses' distortion is the camera model's. Colours are those of `latticeworld picture`, by the
// scene's artistic style. Beyond the world's edge the land goes on as a plain of its mean colour.
class SceneColours : public ColourRenderer {
 public:
  // threads: that draw, 0: as many as cores; pictures are the same with any. What things look like
  // is found out with the first picture: about 0.5 s for 1 km.
  SceneColours(std::shared_ptr<const Scene> scene, int threads);
  ~SceneColours() override;

  void Render(const SensorScene& rays, const SensedWorld& world, const CameraModel& model,
              const Eigen::Isometry3d& map_from_optical, std::uint32_t except_agent,
              CameraFrame* frame) const override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_SENSOR_COLOURS_H_
