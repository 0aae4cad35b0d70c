#include "latticeworld_ros/server/world_server.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "latticeworld_ros/node/parameters.h"
#include "latticeworld_ros/server/agent_services.h"
#include "latticeworld_ros/server/lockstep_service.h"
#include "latticeworld_ros/server/time_services.h"
#include "latticeworld_ros/server/world_services.h"

namespace latticeworld {
namespace {

ros::NodeHandle WithQueue(ros::NodeHandle node, ros::CallbackQueue* queue) {
  node.setCallbackQueue(queue);
  return node;
}

SimulationLoopOptions LoopOptions(const WorldServerOptions& options) {
  SimulationLoopOptions loop;
  loop.step_s = options.simulator.step_s;
  loop.real_time_factor = options.real_time_factor;
  loop.start_paused = options.start_paused;
  return loop;
}

// The worlds directory, made where it can be. One that cannot be made is no reason not to start:
// save_world says so when it is asked.
std::filesystem::path WorldsDirectory(const WorldServerOptions& options) {
  const std::filesystem::path directory = ExpandHome(options.worlds_directory);
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    ROS_WARN_STREAM("worlds_directory " << directory << " cannot be made: " << error.message());
  }
  return directory;
}

GenerationService::Options GenerationOptions(const WorldServerOptions& options) {
  GenerationService::Options generation;
  generation.defaults.reader = options.reader;
  generation.defaults.generator = options.generator;
  for (const std::string& directory : options.visual_directories) {
    generation.defaults.visual_directories.push_back(ExpandHome(directory));
  }
  generation.worlds_directory = ExpandHome(options.worlds_directory);
  return generation;
}

SensorThreadOptions SensorOptions(const WorldServerOptions& options) {
  SensorThreadOptions sensors;
  sensors.threads = options.sensor_threads;
  sensors.seed = static_cast<std::uint64_t>(options.sensor_seed);
  sensors.longitude_deg = options.longitude_deg;
  sensors.altitude_m = options.altitude_m;
  sensors.point_times = options.point_times;
  sensors.geoid_undulation_m = options.geoid_undulation_m;
  return sensors;
}

// The options are valid: there is such a suite.
const SensorSuite& SuiteOf(const WorldServerOptions& options) {
  return *options.sensor_catalogue->FindSuite(options.sensor_suite);
}

}  // namespace

WorldServer::WorldServer(ros::NodeHandle node, const WorldServerOptions& options,
                         LoadedLanguage language, SketchTranslator sketches,
                         std::shared_ptr<const Catalogue> catalogue)
    : maps_(node, &current_),
      follower_(options, &current_, &maps_),
      sensor_topics_(WithQueue(node, &command_queue_),
                     std::make_shared<const SensorSuite>(SuiteOf(options)),
                     options.simulator.species),
      sensors_(SensorOptions(options), &sensor_topics_),
      robots_(WithQueue(node, &command_queue_),
              {[this](const std::string& agent, const VelocityCommand& command) {
                 loop_.Command(agent, command);
               },
               [this](const std::string& agent, std::vector<JointCommand> commands) {
                 loop_.CommandJoints(agent, std::move(commands));
               },
               [this](const std::string& agent) { loop_.Strike(agent); }},
              [this](const std::vector<RobotWish>& robots) { sensor_topics_.Apply(robots); }),
      states_(node, options, &robots_, &follower_, &sensors_, language.server, &master_),
      loop_(LoopOptions(options), &states_),
      launcher_(options, &loop_, &robots_, &maps_),
      generation_(
          node, GenerationOptions(options),
          WorldGenerator(std::move(language.stack), std::move(sketches), std::move(catalogue)),
          &launcher_),
      services_(node),
      bundles_(&loop_, options.most_message_bytes, &services_) {
  AdvertiseWorldServices(WorldsDirectory(options), options.map_values, &loop_, &current_,
                         &services_);
  AdvertiseAgentServices(options.simulator, &loop_, &robots_, &services_);
  AdvertiseTimeServices(&loop_, &robots_, &services_);
  AdvertiseLockstep(&loop_, &states_, &sensors_, &services_);
  loop_.Start();
  command_spinner_.start();
  services_.Start();
  generation_.Start();
  std::vector<std::string> offered = services_.names();
  for (std::string& name : generation_.services()) offered.push_back(std::move(name));
  master_.Start(std::move(offered));
}

WorldServer::~WorldServer() {
  // The order is from outside in: nothing is asked any more, then nothing runs any more. The
  // sensors come first, for whom the loop may wait, then the loop, for whoever waits for it is let
  // go.
  master_.Stop();
  command_spinner_.stop();
  sensors_.Stop();
  loop_.Stop();
  follower_.Stop();
  generation_.Stop();
  services_.Stop();
}

}  // namespace latticeworld
