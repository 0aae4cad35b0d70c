#ifndef LATTICEWORLD_SENSING_MOTION_MOTION_SENSORS_H_
#define LATTICEWORLD_SENSING_MOTION_MOTION_SENSORS_H_

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "latticeworld/geometry/geo_origin.h"

namespace latticeworld {

// One axis of an inertial sensor: white noise, and a bias that wanders as a first-order
// Gauss-Markov process (IEEE Std 952-1997, Woodman 2007).
struct InertialNoise {
  double density = 0.0;           // of white noise, unit / sqrt(Hz)
  double bias = 0.0;              // standard deviation of the constant turn-on bias, unit
  double bias_instability = 0.0;  // standard deviation of the wandering bias, unit
  double bias_time_s = 300.0;     // its correlation time, > 0
};

struct ImuModel {
  InertialNoise gyroscope;                                      // rad/s
  InertialNoise accelerometer;                                  // m/s^2
  double max_rate_radps = 35.0, max_acceleration_mps2 = 160.0;  // readings are cut there
  bool gives_orientation = true;  // from the simulation, exact; false: covariance[0] = -1
};
// Rates and accelerations are means since the reading before. At rest and level the acceleration is
// (0, 0, g), in free fall 0.
struct ImuReading {
  double time_s = 0.0;
  Eigen::Quaterniond map_from_sensor = Eigen::Quaterniond::Identity();
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();  // sensor frame
  Eigen::Vector3d acceleration_mps2 = Eigen::Vector3d::Zero();       // specific force, sensor frame
};

// Position errors wander as a Gauss-Markov process, and jump by white noise.
struct GnssModel {
  double horizontal_noise_m = 0.0, vertical_noise_m = 0.0;  // white, one standard deviation
  double horizontal_wander_m = 0.0, vertical_wander_m = 0.0;
  double wander_time_s = 120.0;  // > 0
  double canopy_factor = 2.0;    // times the noise under trees; >= 1
};
struct GnssReading {
  double time_s = 0.0;
  double latitude_deg = 0.0, longitude_deg = 0.0, altitude_m = 0.0;
  Eigen::Vector3d stddev_m = Eigen::Vector3d::Zero();  // east, north, up
};

struct MagnetometerModel {
  double noise_t = 0.0;  // white, each axis [T]
  double bias_t = 0.0;   // standard deviation of a constant bias (hard iron) [T]
};
struct MagnetometerReading {
  double time_s = 0.0;
  Eigen::Vector3d field_t = Eigen::Vector3d::Zero();  // sensor frame [T]
};

// Dead reckoning from the wheels' encoders: it slips as the wheels do. Motion noise after Thrun,
// Burgard and Fox 2005 (section 5.4): variance of a turn a1 turn^2 + a2 way^2, of a way
// a3 way^2 + a4 turn^2. What the ground does to it is no noise of the sensor's but lasts: `slip`
// and `skid_radpm` say how much of that is expected, which readings state and do not add.
struct WheelOdometryModel {
  double ticks_per_revolution = 0.0;  // of an encoder; 0: exact angles
  double a1 = 0.0, a2 = 0.0, a3 = 0.0, a4 = 0.0;
  double slip = 0.06;  // standard deviation of the share of a way, and of a turn, that slipping
                       // wheels and slopes take, and of what goes sideways for it
  double skid_radpm = 0.08;  // standard deviation of the turn that wheels which skid lose a metre
                             // that they roll, against the way they turn
};
// The motion of base_link in the plane, reckoned from where it began. Covariances are of first
// order: they hold while the heading is known to half a radian or so.
struct WheelOdometryReading {
  double time_s = 0.0;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  double forward_mps = 0.0, sideways_mps = 0.0, yaw_rate_radps = 0.0;
  Eigen::Matrix3d pose_covariance = Eigen::Matrix3d::Zero();  // x, y [m], heading [rad]
  // Variances of forward and sideways speed [m^2/s^2] and of the yaw rate [rad^2/s^2].
  Eigen::Vector3d twist_variances = Eigen::Vector3d::Zero();
};

struct BumperModel {
  double threshold_n = 5.0;  // of a contact with what is not the ground
};
struct BumperReading {
  double time_s = 0.0;
  bool pressed = false;
  double force_n = 0.0;
  double bearing_rad = 0.0;  // of the contact, from x, counter-clockwise
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_MOTION_MOTION_SENSORS_H_
