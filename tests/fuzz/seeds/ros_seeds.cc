#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <ros/serialization.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <visualization_msgs/MarkerArray.h>

#include <fstream>
#include <iterator>
#include <vector>

#include "fuzz/seeds/seeds.h"
#include "generation/test_world.h"
#include "latticeworld/episode/journal_json.h"
#include "latticeworld_ros/conversion/lockstep_messages.h"
#include "latticeworld_ros/episode/bag_file.h"
#include "latticeworld_ros/episode/bag_message.h"
#include "latticeworld_ros/episode/episode_recording.h"
#include "latticeworld_ros/server/thing_query.h"

namespace latticeworld::fuzz {
namespace {

namespace msgs = latticeworld_msgs;

template <typename Message>
std::string Serialized(char letter, const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return letter + std::string(bytes.begin(), bytes.end());
}

// Of the target ros_requests, in the order of its choices.
void AgentRequestSeeds(const TakeSeed& take) {
  msgs::SpawnAgent::Request spawn;
  spawn.species = "sheep";
  spawn.name = "dolly";
  take("ros_requests", "spawn_agent", Serialized('a', spawn));
  msgs::SetPolicy::Request policy;
  policy.agent = "dolly";
  policy.policy = "wander";
  take("ros_requests", "set_policy", Serialized('b', policy));
  msgs::Lockstep::Request lockstep;
  lockstep.commands.resize(1);
  lockstep.strikes = {"robot"};
  take("ros_requests", "lockstep", Serialized('c', lockstep));
  take("ros_requests", "cmd_vel", Serialized('d', geometry_msgs::Twist()));
  sensor_msgs::JointState joints;
  joints.name = {"knee", "hip"};
  joints.position = {0.1, 0.2};
  take("ros_requests", "joint_commands", Serialized('e', joints));
}

void WorldRequestSeeds(const TakeSeed& take) {
  msgs::GenerateWorld::Request generate;
  generate.layout_instruction = "a lake in the center";
  generate.visual_kind = 1;
  generate.visual.format = "pgm";
  generate.visual.data = {'P', '5', ' ', '2', ' ', '2', ' ', '9', '\n', 0, 1, 2, 3};
  take("ros_requests", "generate_world", Serialized('f', generate));
  msgs::SpawnElement::Request element;
  element.kind = "crate";
  take("ros_requests", "spawn_element", Serialized('g', element));
  take("ros_requests", "open_gate", Serialized('h', msgs::OpenGate::Request()));
  msgs::SetWeather::Request weather;
  weather.weather = "rain";
  take("ros_requests", "set_weather", Serialized('i', weather));
  msgs::QueryTerrain::Request terrain;
  terrain.points.resize(2);
  take("ros_requests", "query_terrain", Serialized('j', terrain));
  msgs::QueryThings::Request things;
  things.names = {"bench_1"};
  take("ros_requests", "query_things", Serialized('k', things));
  msgs::LoadWorld::Request load;
  load.name = "lake";
  take("ros_requests", "load_world", Serialized('l', load));
  msgs::JournalEntry entry;
  entry.call = EncodeCall(StrikeCall{"robot"});
  take("ros_requests", "journal_entry", Serialized('m', entry));
  msgs::StartEpisode::Request episode;
  episode.name = "first";
  episode.topics = {"/robot/(scan|points)", "/camera_[0-9]{2}/.*"};
  take("ros_requests", "start_episode", Serialized('n', episode));
}

// Of the target viewer_messages, in the order of its choices.
void ViewerSeeds(const TakeSeed& take) {
  msgs::AgentStates agents;
  agents.agents.resize(1);
  agents.agents[0].name = "robot";
  take("viewer_messages", "agent_states", Serialized('a', agents));
  msgs::ElementStates elements;
  elements.elements.resize(1);
  take("viewer_messages", "element_states", Serialized('b', elements));
  take("viewer_messages", "weather", Serialized('c', msgs::Weather()));
  msgs::SceneChanges changes;
  changes.felled.resize(1);
  take("viewer_messages", "scene_changes", Serialized('d', changes));
  visualization_msgs::MarkerArray markers;
  markers.markers.resize(1);
  markers.markers[0].ns = "falling";
  take("viewer_messages", "markers", Serialized('e', markers));
  diagnostic_msgs::DiagnosticArray diagnostics;
  diagnostics.status.resize(1);
  diagnostics.status[0].name = "world_server: simulation";
  diagnostics.status[0].values.resize(1);
  diagnostics.status[0].values[0].key = "real_time_factor";
  diagnostics.status[0].values[0].value = "1.0";
  take("viewer_messages", "diagnostics", Serialized('f', diagnostics));
  nav_msgs::Path path;
  path.poses.resize(2);
  take("viewer_messages", "path", Serialized('g', path));
}

void SensorSeeds(const TakeSeed& take) {
  nav_msgs::OccupancyGrid map;
  map.info.resolution = 0.5f;
  map.info.width = map.info.height = 32;
  map.info.origin.position.x = map.info.origin.position.y = -8.0;
  map.info.origin.orientation.w = 1.0;
  map.data.assign(32 * 32, 0);
  take("viewer_messages", "map", Serialized('h', map));
  sensor_msgs::LaserScan scan;
  scan.header.stamp = ros::Time(10.0);
  scan.angle_min = -1.0f;
  scan.angle_max = 1.0f;
  scan.angle_increment = 0.25f;
  scan.time_increment = 0.01f;
  scan.range_max = 30.0f;
  scan.ranges = {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f, 9.0f};
  take("viewer_messages", "scan", Serialized('i', scan));
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = ros::Time(10.0);
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2Fields(
      4, "x", 1, sensor_msgs::PointField::FLOAT32, "y", 1, sensor_msgs::PointField::FLOAT32, "z", 1,
      sensor_msgs::PointField::FLOAT32, "time", 1, sensor_msgs::PointField::FLOAT32);
  modifier.resize(3);
  take("viewer_messages", "cloud", Serialized('j', cloud));
  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = "map";
  goal.pose.orientation.w = 1.0;
  take("viewer_messages", "goal", Serialized('k', goal));
}

msgs::EpisodeStart EpisodeStartMessage() {
  msgs::EpisodeStart start;
  start.header.stamp = ros::Time(1.0);
  start.format = kEpisodeFormat;
  start.name = "a";
  start.world_id = "world-000000000000";
  start.run = 1;
  start.state_hash = "00";
  start.options = EncodeSimulatorOptions(SimulatorOptions());
  start.journal_complete = true;
  return start;
}

// compression: a bag that has none leaves out the texts of its message definitions, which no reader
// of episodes looks at and which would be nine tenths of what is mutated byte by byte.
std::string EpisodeBag(BagCompression compression) {
  const TemporaryDirectory directory;
  const std::filesystem::path path = directory.path() / "a.bag";
  const ros::Time time(1.0);
  auto file = *BagFile::Create(path, compression);
  const auto write = [&](const BagMessage& message) {
    if (compression == BagCompression::kNone) (*message.header)["message_definition"].clear();
    (void)file->Write(message);
  };
  write(ToBag(kEpisodeStartTopic, time, EpisodeStartMessage(), true));
  msgs::AgentEvent event;
  event.kind = "spawned";
  event.agent = "robot";
  event.header.stamp = time;
  write(ToBag("/agent_events", time, event));
  for (int step = 1; step <= 3; ++step) {
    const ros::Time stamp(1.0 + 0.1 * step);
    msgs::AgentStates states;
    states.header.stamp = stamp;
    states.step = states.episode_step = step;
    states.episode_time = 0.1 * step;
    states.agents.resize(1);
    states.agents[0].name = "robot";
    states.agents[0].pose.position.x = 0.2 * step;
    write(ToBag("/agents", stamp, states));
    sensor_msgs::JointState joints;
    joints.header.stamp = stamp;
    joints.name = {"knee"};
    joints.position = {0.1 * step};
    joints.velocity = joints.effort = {1.0};
    write(ToBag("/robot/joint_states", stamp, joints));
  }
  msgs::JournalEntry entry;
  entry.run = entry.number = 1;
  entry.call = EncodeCall(StrikeCall{"robot"});
  write(ToBag("/world/journal", time, entry));
  msgs::StateHash hash;
  hash.run = hash.calls = 1;
  write(ToBag("/world/state_hash", time, hash));
  msgs::WorldFiles files;
  files.files.resize(1);
  files.files[0].path = "world.json";
  write(ToBag(kEpisodeWorldTopic, time, files, true));
  msgs::EpisodeEnd end;
  end.header.stamp = ros::Time(2.0);
  end.reason = "done";
  write(ToBag(kEpisodeEndTopic, end.header.stamp, end));
  (void)file->Finish();
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

}  // namespace

void RosSeeds(const TakeSeed& take) {
  AgentRequestSeeds(take);
  WorldRequestSeeds(take);
  ViewerSeeds(take);
  SensorSeeds(take);
  take("episode_bag", "plain", EpisodeBag(BagCompression::kNone));
  take("episode_bag", "lz4", EpisodeBag(BagCompression::kLz4));
  take("episode_bag", "bz2", EpisodeBag(BagCompression::kBz2));
}

}  // namespace latticeworld::fuzz
