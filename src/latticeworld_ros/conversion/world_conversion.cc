#include "latticeworld_ros/conversion/world_conversion.h"

#include <algorithm>
#include <limits>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/mapping/bridge_decks.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/scene/weather/water_depth.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"
#include "latticeworld_ros/conversion/same_fields.h"

namespace latticeworld {
namespace {

using Response = latticeworld_msgs::GenerateWorld::Response;
using TaskResult = latticeworld_msgs::GenerateWorldTaskResult;

static_assert(HaveSameFields<Response, TaskResult>(),
              "srv/GenerateWorld.srv and action/GenerateWorldTask.action answer the same");

// below_m: height of the ground or of the water that stands on it. deck: null where there is none.
void FillDeck(const PropDeck* deck, double below_m, latticeworld_msgs::TerrainSample* sample) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  sample->deck_height = deck != nullptr ? deck->top_m : kNone;
  sample->deck_clearance = deck != nullptr ? std::max(0.0, deck->bottom_m - below_m) : kNone;
  sample->deck_load = deck != nullptr ? deck->carries_kg : kNone;
}

}  // namespace

latticeworld_msgs::WorldInfo ToWorldInfo(const World& world) {
  const Scene& scene = *world.scene;
  latticeworld_msgs::WorldInfo message;
  message.header.frame_id = kMapFrame;
  message.world_id = world.id;
  message.seed = world.request.seed;
  message.generator = world.request.generator;
  message.vocabulary = std::string(NameOf(world.layout.vocabulary));
  message.layout_instruction = world.request.layout_instruction;
  message.environment_instruction = world.request.environment_instruction;
  message.size = scene.geometry().size_m();
  message.resolution = scene.geometry().resolution_m();
  message.min_height = scene.terrain->ground.min_m();
  message.max_height = scene.terrain->ground.max_m();
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  message.latitude = world.geo ? world.geo->latitude_deg : kNowhere;
  message.longitude = world.geo ? world.geo->longitude_deg : kNowhere;
  message.altitude = world.geo ? world.geo->altitude_m : kNowhere;
  message.agents = static_cast<std::uint32_t>(scene.agents.size());
  message.assets = static_cast<std::uint32_t>(scene.assets.size());
  return message;
}

latticeworld_msgs::Layout ToLayout(const World& world) {
  latticeworld_msgs::Layout message;
  message.header.frame_id = kMapFrame;
  message.world_id = world.id;
  message.vocabulary = std::string(NameOf(world.layout.vocabulary));
  message.layout = ToText(world.layout);
  return message;
}

latticeworld_msgs::Environment ToEnvironment(const World& world) {
  latticeworld_msgs::Environment message;
  message.header.frame_id = kMapFrame;
  message.world_id = world.id;
  message.environment = ToJson(world.environment);
  return message;
}

std::vector<latticeworld_msgs::ClaimOutcome> ToClaimOutcomeMessages(
    const std::vector<ClaimOutcome>& claims) {
  std::vector<latticeworld_msgs::ClaimOutcome> messages(claims.size());
  for (std::size_t i = 0; i < claims.size(); ++i) {
    messages[i].part = std::string(NameOf(claims[i].part));
    messages[i].kind = claims[i].kind;
    messages[i].words = claims[i].words;
    messages[i].satisfied = claims[i].satisfied;
    messages[i].distance = claims[i].distance;
    messages[i].explanation = claims[i].explanation;
  }
  return messages;
}

latticeworld_msgs::Reading ToReading(const World& world) {
  latticeworld_msgs::Reading message;
  message.reader = world.request.reader;
  message.layout = world.fidelity.layout_sentences;
  message.environment = world.fidelity.environment_sentences;
  message.words = static_cast<std::uint32_t>(world.fidelity.words);
  message.words_read = static_cast<std::uint32_t>(world.fidelity.words_read);
  message.second = ToClaimOutcomeMessages(world.fidelity.second);
  return message;
}

std::vector<latticeworld_msgs::StageTime> ToStageTimeMessages(
    const std::vector<StageTime>& stages) {
  std::vector<latticeworld_msgs::StageTime> messages(stages.size());
  for (std::size_t i = 0; i < stages.size(); ++i) {
    messages[i].name = stages[i].name;
    messages[i].seconds = stages[i].seconds;
  }
  return messages;
}

template <typename Answer>
Answer ToGenerationAnswer(const World& world, const std::vector<StageTime>& stages) {
  Answer answer;
  answer.world_id = world.id;
  answer.seed = world.request.seed;
  answer.layout = ToText(world.layout);
  answer.vocabulary = std::string(NameOf(world.layout.vocabulary));
  answer.environment = ToJson(world.environment);
  answer.generator = world.request.generator;
  answer.reading = ToReading(world);
  answer.fidelity = ToClaimOutcomeMessages(world.fidelity.claims);
  answer.not_understood = world.fidelity.not_understood;
  answer.warnings = world.warnings;
  answer.stages = ToStageTimeMessages(stages);
  return answer;
}
template Response ToGenerationAnswer(const World&, const std::vector<StageTime>&);
template TaskResult ToGenerationAnswer(const World&, const std::vector<StageTime>&);

Result<std::vector<latticeworld_msgs::TerrainSample>> SampleTerrain(
    const Scene& scene, const Atmosphere& atmosphere, const std::vector<PropDeck>& decks,
    const std::vector<geometry_msgs::Point>& points) {
  if (points.size() > kMaxTerrainPoints) {
    return ResourceExhausted(std::to_string(points.size()) + " points are given; at most " +
                             std::to_string(kMaxTerrainPoints) + " are legal in one call");
  }
  const Terrain& terrain = *scene.terrain;
  const SurfaceTable surfaces(scene, atmosphere.ground());
  const BridgeDecks bridges(terrain.geometry(), decks);
  const double half_m = terrain.geometry().half_size_m();
  std::vector<latticeworld_msgs::TerrainSample> samples;
  samples.reserve(points.size());
  for (const geometry_msgs::Point& given : points) {
    const WorldPoint point{given.x, given.y};
    if (!terrain.geometry().Contains(point)) {
      return Status(StatusCode::kOutOfRange,
                    "point " + std::to_string(samples.size()) + " (" + FormatDouble(given.x) +
                        ", " + FormatDouble(given.y) +
                        ") m is outside the world, whose x and y go "
                        "from " +
                        FormatDouble(-half_m) + " to " + FormatDouble(half_m) + " m");
    }
    const SurfaceClass surface = terrain.SurfaceAt(point);
    latticeworld_msgs::TerrainSample sample;
    sample.height = terrain.ground.HeightAt(point);
    sample.slope = terrain.ground.SlopeAt(point);
    sample.surface = std::string(NameOf(surface));
    sample.letter = std::string(1, terrain.weights.DominantAt(terrain.geometry().CellAt(point)));
    sample.water_depth = WaterDepthAt(terrain, atmosphere, point);
    const SurfaceProperties& properties = surfaces.Of(surface);
    sample.friction = properties.friction;
    sample.rolling_resistance = properties.rolling_resistance;
    sample.cone_index_kpa = properties.cone_index_kpa;
    FillDeck(bridges.At(point), sample.height + sample.water_depth, &sample);
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace latticeworld
