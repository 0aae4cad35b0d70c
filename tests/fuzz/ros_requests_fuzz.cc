// Requests of world_server's services and of episodes, and messages of its robots' topics,
// serialized, through our conversions.

#include "fuzz/support/ros_message.h"
#include "generation/test_world.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/journal_conversion.h"
#include "latticeworld_ros/conversion/request_conversion.h"
#include "latticeworld_ros/conversion/scene_conversion.h"
#include "latticeworld_ros/conversion/weather_conversion.h"
#include "latticeworld_ros/conversion/world_conversion.h"
#include "latticeworld_ros/episode/episode_request.h"
#include "latticeworld_ros/server/bundle_name.h"
#include "latticeworld_ros/server/lockstep_request.h"
#include "latticeworld_ros/server/thing_query.h"

namespace {

using namespace latticeworld;
namespace msgs = latticeworld_msgs;
using fuzz::WithMessage;

const World& TestWorld() {
  static const std::shared_ptr<const World> world = MakeTestWorld();
  return *world;
}

// Services that are about agents.
void ReadAgentRequest(std::size_t choice, std::string_view bytes) {
  switch (choice) {
    case 0:
      WithMessage<msgs::SpawnAgent::Request>(
          bytes, [](const auto& message) { (void)ToSpawnRequest(message, SimulatorOptions()); });
      break;
    case 1:
      WithMessage<msgs::SetPolicy::Request>(
          bytes, [](const auto& message) { (void)ToPolicyChange(message); });
      break;
    case 2:
      WithMessage<msgs::Lockstep::Request>(bytes, [](const auto& message) {
        (void)CheckCommands(ToLockstepCommands(message), WorldState(),
                            *SpeciesCatalogue::BuiltIn());
      });
      break;
    case 3:
      WithMessage<geometry_msgs::Twist>(
          bytes, [](const auto& message) { (void)ToVelocityCommand(message); });
      break;
    default:
      WithMessage<sensor_msgs::JointState>(
          bytes, [](const auto& message) { (void)ToJointCommands(message); });
  }
}

// Services that are about the world and what stands in it.
void ReadWorldRequest(std::size_t choice, std::string_view bytes) {
  switch (choice) {
    case 0:
      WithMessage<msgs::GenerateWorld::Request>(bytes, [](const auto& message) {
        static const WorldGenerator generator = MakeDefaultWorldGenerator();
        (void)ToGenerationRequest(message, RequestDefaults{"", "grounded", {}}, generator, 1);
      });
      break;
    case 1:
      WithMessage<msgs::SpawnElement::Request>(bytes,
                                               [](const auto& message) { (void)ToProp(message); });
      break;
    case 2:
      WithMessage<msgs::OpenGate::Request>(bytes,
                                           [](const auto& message) { (void)OpeningOf(message); });
      break;
    case 3:
      WithMessage<msgs::SetWeather::Request>(
          bytes, [](const auto& message) { (void)ToWeatherChange(message); });
      break;
    case 4:
      WithMessage<msgs::QueryTerrain::Request>(bytes, [](const auto& message) {
        const Scene& scene = *TestWorld().scene;
        (void)SampleTerrain(scene, scene.atmosphere, {}, message.points);
      });
      break;
    case 5:
      WithMessage<msgs::QueryThings::Request>(bytes, [](const auto& message) {
        msgs::QueryThings::Response response;
        AnswerQuery(*TestWorld().scene, WorldState(), message, &response);
      });
      break;
    case 6:
      WithMessage<msgs::LoadWorld::Request>(
          bytes, [](const auto& message) { (void)CheckBundleName(message.name); });
      break;
    case 7:
      WithMessage<msgs::JournalEntry>(bytes,
                                      [](const auto& message) { (void)ToJournalEntry(message); });
      break;
    default:
      WithMessage<msgs::StartEpisode::Request>(bytes, [](const auto& message) {
        const auto request = ReadEpisodeRequest(message, "lz4");
        if (request.ok()) (void)request->filter.Matches("/robot/camera/image_raw");
      });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kAgentRequests = 5, kWorldRequests = 9;
  std::string_view bytes = fuzz::TextOf(data, size);
  const std::size_t choice = fuzz::TakeChoice(&bytes, kAgentRequests + kWorldRequests);
  if (choice < kAgentRequests) {
    ReadAgentRequest(choice, bytes);
  } else {
    ReadWorldRequest(choice - kAgentRequests, bytes);
  }
  return 0;
}
