#ifndef LATTICEWORLD_ROS_SERVER_WORLD_SERVER_OPTIONS_H_
#define LATTICEWORLD_ROS_SERVER_WORLD_SERVER_OPTIONS_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/generation/bundle/load_language.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/sensing/sensor_suite.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld_ros/conversion/point_times.h"
#include "latticeworld_ros/node/message_size.h"
#include "latticeworld_ros/publishing/robot_frames.h"

namespace latticeworld {

// The parameters of world_server: launch_cfg/world_server.yaml has one entry a field, of the same
// name. docs there.
struct WorldServerOptions {
  // Time.
  double real_time_factor = 1.0;  // 0: as fast as possible; else [0.01, 1000]
  bool start_paused = false;
  // step_s, physics_threads, command_timeout_s, pursuit_distance_m, day_length_s, robot_species;
  // its catalogue is made from `species`.
  SimulatorOptions simulator;
  std::string species;  // "": the built-in ones, else a file or directory that adds to them

  // Sensors of robots.
  std::string sensors;                    // "": the built-in suites, else a file or directory
                                          // that adds to them; sensor_catalogue is made from it
  std::string sensor_suite = "standard";  // of sensor_catalogue: what every robot carries
  int sensor_threads = 0;                 // [1, 64] that trace rays; 0: as many as cores
  int sensor_seed = 0;                    // of their noise; 0: the simulation's, else above
  double longitude_deg = 9.0;             // [-180, 180] of worlds that lie nowhere on the earth;
                                          // zone 32 of UTM has its middle there
  double altitude_m = 0.0;                // [-1000, 9000] of them
  PointTimes point_times = PointTimes::kEnd;  // of `points`
  double geoid_undulation_m = 0.0;  // [-120, 100]: added to the altitude of every NavSatFix
  std::shared_ptr<const SensorCatalogue> sensor_catalogue = SensorCatalogue::BuiltIn();

  // Publishing, in Hz of simulated time.
  double clock_rate_hz = 100.0;     // [1, 1000]
  double state_rate_hz = 50.0;      // [1, 1000]: tf, agents, odometry
  double marker_rate_hz = 10.0;     // [0.1, 1000]: agents/markers
  double state_hash_rate_hz = 1.0;  // 0, or [0.001, 1000]: world/state_hash
  int marker_terrain_cells = 128;   // [16, 512] a side: ground of world/markers
  int marker_max_assets = 20000;    // [0, 500000]: assets of world/markers
  RobotFrameOptions frames;         // of /tf; names are never empty

  // Worlds.
  // Who reads and who answers where a request does not say: names of a LanguageStack, or "" for its
  // default.
  std::string reader;
  std::string generator;
  RemoteModelOptions remote;
  LocalModelOptions local;
  ReaderModelOptions reader_model;
  std::string worlds_directory = "~/.ros/latticeworld/worlds";
  std::vector<std::string> visual_directories = {"~/.ros/latticeworld/visuals"};
  std::string catalogue;     // "": the built-in one, else a file or directory that adds to it
  std::string sketch_model;  // "": sketches become land by the embedded method, else an ONNX file

  // Maps.
  double octomap_resolution_m = 0.0;  // 0: that of the world; else [0.05, 16]
  double octomap_thickness_m = 1.0;   // [0, 100]
  // [0, 10] of the robot below, or kRadiusOfSpecies.
  static constexpr double kRadiusOfSpecies = -1.0;
  double robot_radius_m = kRadiusOfSpecies;
  RobotLimits robot;  // for map and the traversability layer; its radius is that, as a length
  MapValues map_values = MapValues::kGraded;  // of map, static_map and bundles' map.pgm
  // The greatest size of maps, markers and bundles, [1e6, kMostMessageBytes], so that they can be
  // received.
  std::uint64_t most_message_bytes = kMostMessageBytes;
};

// Every violation, each with its parameter's name.
std::vector<Violation> Validate(const WorldServerOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_WORLD_SERVER_OPTIONS_H_
