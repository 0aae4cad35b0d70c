#ifndef LATTICEWORLD_RENDERING_RAY_RAY_SKY_H_
#define LATTICEWORLD_RENDERING_RAY_RAY_SKY_H_

#include <Eigen/Core>

#include "latticeworld/environment/attributes.h"

namespace latticeworld {

struct Atmosphere;
struct Scene;

// Light of ray-traced pictures: linear RGB; a white thing square to the noon's sun under a clear
// sky sends about 2.
using Light = Eigen::Array3f;

// sRGB in [0, 1] to linear and back (IEC 61966-2-1).
float ToLinear(float srgb);
float FromLinear(float linear);
inline Light Blend(const Light& a, const Light& b, float share_of_b) {
  return a * (1.0f - share_of_b) + b * share_of_b;
}
inline float Brightness(const Light& light) {
  return 0.2126f * light[0] + 0.7152f * light[1] + 0.0722f * light[2];
}

// Sun or moon, the sky with its clouds and stars, and the air between. Fitted by eye to clear and
// overcast skies after the sun's height; not a model of scattering.
class RaySky {
 public:
  explicit RaySky(const Scene& scene);
  RaySky(const Atmosphere& atmosphere, ArtisticStyle style);

  // Unit, map frame, towards what throws shadows: the sun, at night the moon.
  const Eigen::Vector3f& sun_direction() const { return sun_direction_; }
  // What a white surface square to it sends, at the ground.
  const Light& sunlight() const { return sunlight_; }
  // What a white surface of that normal sends by the light of the open sky and of lit ground.
  Light Ambient(const Eigen::Vector3f& normal) const;
  // What is seen in a direction (unit), with sun, clouds and stars.
  Light At(const Eigen::Vector3f& direction) const;
  // The same without what is small: for mirror images in rough water.
  Light Smooth(const Eigen::Vector3f& direction) const;

  // What far things take the colour of, in a direction.
  Light Air(const Eigen::Vector3f& direction) const;
  // Share of a thing's own light that is left at a distance (Koschmieder 1924; contrast 0.05 at the
  // visibility, as WMO-No. 8 defines the meteorological optical range).
  float Clarity(float distance_m) const;

  bool lamps_are_lit() const { return lamps_are_lit_; }
  // Returns the factor by which the film multiplies: eyes get used to the dark, in part.
  float exposure() const { return exposure_; }

 private:
  float CloudAt(const Eigen::Vector3f& direction) const;  // cover, [0, 1]

  Eigen::Vector3f sun_direction_;
  Light sunlight_, zenith_, horizon_, glow_, cloud_, air_;
  float overcast_ = 0.0f;  // share of the sky's own colour that clouds take, [0, 1]
  float cover_ = 0.0f;     // of single clouds, [0, 1]
  float stars_ = 0.0f;     // [0, 1]
  float disc_ = 0.0f;      // of sun or moon: brightness
  float extinction_pm_ = 0.0f;
  float exposure_ = 1.0f;
  bool is_night_ = false;
  bool lamps_are_lit_ = false;
  ArtisticStyle style_ = ArtisticStyle::kRealistic;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_RAY_SKY_H_
