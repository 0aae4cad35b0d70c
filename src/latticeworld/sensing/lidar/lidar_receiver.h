#ifndef LATTICEWORLD_SENSING_LIDAR_LIDAR_RECEIVER_H_
#define LATTICEWORLD_SENSING_LIDAR_LIDAR_RECEIVER_H_

#include <cstdint>

#include "latticeworld/sensing/lidar/lidar_model.h"

namespace latticeworld {

struct Atmosphere;

// What one beam brings back. Range as in LidarSweep: infinity, NaN or -infinity without an echo.
struct LidarEcho {
  float range_m = 0.0f;
  float intensity = 0.0f;  // [0, 255]
};

// A pulse's way through the air and its echoes (the lidar equation of Rasshofer, Spies and Spies
// 2011). A diffuse surface of reflectance r met under the cosine c at d sends back r c exp(-2 a d)
// / d^2; the receiver takes the strongest echo over the threshold, which is what a surface of
// max_range_reflectivity sends back from max_range_m in clear air. What the air itself sends back:
//  - fog: the echo of a soft target, b L exp(-2 a r) / max(r, R)^2 with b = 0.046 / V (Hahner et
//  al.
//    2021), the pulse's length L and the crossover R of a biaxial receiver; times an exponential
//    draw for uneven fog.
//  - single drops, flakes and grains: with the probability of ConditionsIn a beam is lost to one
//    within the first metres; its own echo is told where it is strong enough (Hasirlioglu and
//    Riener 2017, Heinzler et al. 2019: such points lie within a few metres, and snow makes most of
//    them).
class LidarReceiver {
 public:
  LidarReceiver(const LidarModel& model, const Atmosphere& atmosphere);

  // distance_m: to what the beam meets; infinity: nothing. returned: LidarSurfaces::Return. key and
  // beam: of its noise.
  LidarEcho Receive(float distance_m, float returned, std::uint64_t key, std::uint64_t beam) const;
  // Returns from where on nothing that sends back so much at the most changes what is received.
  float Reach(float most_returned) const;

 private:
  // What a surface sends back, in the lidar equation's unit [1/m^2].
  float StrengthAt(float distance_m, float returned) const;
  // Returns the noisy range and the intensity of an echo. strength: in the lidar equation's unit
  // [1/m^2].
  LidarEcho EchoAt(float distance_m, float strength, std::uint64_t noise_bits) const;
  // What the air in front sends back; strength 0: nothing that could be told.
  struct AirEcho {
    float distance_m = 0.0f;
    float strength = 0.0f;
  };
  AirEcho FogEcho(std::uint64_t bits) const;
  AirEcho ParticleEcho(std::uint64_t bits) const;

  float min_range_m_, max_range_m_, noise_m_, range_step_m_, dropout_probability_;
  float threshold_;   // weakest echo that is told [1/m^2]
  float full_scale_;  // echo of intensity 255 [1/m^2]
  float extinction_per_m_;
  float lost_probability_;             // to the air near the sensor
  float fog_backscatter_ = 0.0f;       // pi b L; 0: no fog
  float particle_reflectance_ = 0.0f;  // 0: none of that size
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_LIDAR_LIDAR_RECEIVER_H_
