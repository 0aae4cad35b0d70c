#include "latticeworld_ros/server/world_services.h"

#include <nav_msgs/GetMap.h>
#include <octomap_msgs/GetOctomap.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "latticeworld/environment/environment_config.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/conversion/status_conversion.h"
#include "latticeworld_ros/conversion/weather_conversion.h"
#include "latticeworld_ros/conversion/world_conversion.h"
#include "latticeworld_ros/server/bundle_name.h"
#include "latticeworld_ros/server/thing_query.h"

namespace latticeworld {
namespace {

Status NoWorld() {
  return FailedPrecondition("no world is running; call generate_world or load_world first");
}

// Returns the messages for services whose types have no status: as with octomap_server and
// map_server, the call itself fails while there is nothing to give. roscpp passes the words of an
// exception on to the caller.
const WorldMessages& MessagesOf(const PublishedWorld* current) {
  if (current == nullptr) throw std::runtime_error(NoWorld().message());
  return current->messages;
}

void OnGet(SimulationLoop* loop, const CurrentWorld& current,
           latticeworld_msgs::GetWorld::Response* response) {
  const Result<SimulationLoop::Moment> moment = loop->Inspect(/*hash=*/true);
  response->status = ToStatusMessage(moment.status());
  if (!moment.ok()) return;
  const World& world = *moment->world;
  response->info = ToWorldInfo(world);
  // The stamp belongs to the running world, which may be another one by now.
  const std::shared_ptr<const PublishedWorld> published = current.Get();
  if (published != nullptr && published->world == moment->world) {
    response->info.header.stamp = published->messages.info->header.stamp;
  }
  response->layout = ToText(world.layout);
  response->environment = ToJson(world.environment);
  response->environment_schema = EnvironmentSchema(*world.scene->catalogue);
  response->species = SpeciesNames(*moment->species);
  for (const std::string& name : response->species) {
    response->species_radii.push_back(moment->species->Find(name)->radius_m);
  }
  response->policies = PolicyNames();
  response->reading = ToReading(world);
  response->fidelity = ToClaimOutcomeMessages(world.fidelity.claims);
  response->not_understood = world.fidelity.not_understood;
  response->warnings = world.warnings;
  response->stages = ToStageTimeMessages(world.stages);
  response->step = moment->step;
  response->episode_step = moment->episode_step;
  response->paused = moment->paused;
  response->state_hash = moment->state_hash;
}

Status Save(const std::filesystem::path& worlds_directory, MapValues map_values,
            const CurrentWorld& current, const latticeworld_msgs::SaveWorld::Request& request,
            latticeworld_msgs::SaveWorld::Response* response) {
  const std::shared_ptr<const PublishedWorld> published = current.Get();
  if (published == nullptr) return NoWorld();
  const std::string name = request.name.empty() ? published->world->id : request.name;
  LW_RETURN_IF_ERROR(CheckBundleName(name));
  response->world_id = published->world->id;
  // A directory that cannot be made is told by SaveBundle, in its words.
  std::error_code ignored;
  std::filesystem::create_directories(worlds_directory, ignored);
  const std::filesystem::path path = worlds_directory / name;
  const Status saved = SaveBundle(*published->world, path, map_values);
  if (saved.ok() || saved.code() == StatusCode::kAlreadyExists) response->path = path.string();
  return saved;
}

void OnList(const std::filesystem::path& worlds_directory,
            latticeworld_msgs::ListWorlds::Response* response) {
  response->directory = worlds_directory.string();
  const Result<std::vector<BundleSummary>> bundles = ListBundles(worlds_directory);
  response->status = ToStatusMessage(bundles.status());
  if (!bundles.ok()) return;
  for (const BundleSummary& bundle : *bundles) {
    latticeworld_msgs::WorldBundle message;
    message.name = bundle.name;
    message.world_id = bundle.world_id;
    message.layout_instruction = bundle.layout_instruction;
    response->worlds.push_back(std::move(message));
  }
}

void OnQuery(SimulationLoop* loop, const latticeworld_msgs::QueryTerrain::Request& request,
             latticeworld_msgs::QueryTerrain::Response* response) {
  const Result<SimulationLoop::Moment> moment = loop->Inspect(/*hash=*/false);
  response->status = ToStatusMessage(moment.status());
  if (!moment.ok()) return;
  response->world_id = moment->world->id;
  const Scene& scene = *moment->world->scene;
  SceneChanges changes;
  changes.props = moment->state->standing;
  Result<std::vector<latticeworld_msgs::TerrainSample>> samples =
      SampleTerrain(scene, moment->atmosphere, PropsIn(scene, changes)->decks, request.points);
  response->status = ToStatusMessage(samples.status());
  if (samples.ok()) response->samples = std::move(samples).value();
}

void OnQueryThings(SimulationLoop* loop, const latticeworld_msgs::QueryThings::Request& request,
                   latticeworld_msgs::QueryThings::Response* response) {
  const Result<SimulationLoop::Moment> moment = loop->Inspect(/*hash=*/false);
  response->status = ToStatusMessage(moment.status());
  if (!moment.ok()) return;
  response->world_id = moment->world->id;
  AnswerQuery(*moment->world->scene, *moment->state, request, response);
}

Status SetWeather(SimulationLoop* loop, const latticeworld_msgs::SetWeather::Request& request,
                  latticeworld_msgs::SetWeather::Response* response) {
  LW_ASSIGN_OR_RETURN(const WeatherChange change, ToWeatherChange(request));
  LW_ASSIGN_OR_RETURN(const SimulationLoop::WeatherAnswer answer, loop->SetWeather(change));
  response->world_id = answer.world_id;
  response->weather = ToWeatherMessage(answer.target, 0.0, answer.now, answer.world_id);
  return Status();
}

}  // namespace

void AdvertiseWorldServices(const std::filesystem::path& worlds_directory, MapValues map_values,
                            SimulationLoop* loop, const CurrentWorld* current,
                            ServiceQueue* queue) {
  using latticeworld_msgs::GetWorld;
  using latticeworld_msgs::ListWorlds;
  using latticeworld_msgs::QueryTerrain;
  using latticeworld_msgs::QueryThings;
  using latticeworld_msgs::SaveWorld;
  using SetWeatherService = latticeworld_msgs::SetWeather;
  using nav_msgs::GetMap;
  using octomap_msgs::GetOctomap;

  // These tell and save the current world, and list those that are saved.
  queue->Advertise<GetWorld>("get_world",
                             [=](const GetWorld::Request&, GetWorld::Response* response) {
                               OnGet(loop, *current, response);
                             });
  queue->Advertise<SaveWorld>(
      "save_world", [=](const SaveWorld::Request& request, SaveWorld::Response* response) {
        response->status =
            ToStatusMessage(Save(worlds_directory, map_values, *current, request, response));
      });
  queue->Advertise<ListWorlds>("list_worlds",
                               [=](const ListWorlds::Request&, ListWorlds::Response* response) {
                                 OnList(worlds_directory, response);
                               });
  // These tell what is where, and change the weather.
  queue->Advertise<QueryTerrain>(
      "query_terrain", [=](const QueryTerrain::Request& request, QueryTerrain::Response* response) {
        OnQuery(loop, request, response);
      });
  queue->Advertise<QueryThings>(
      "query_things", [=](const QueryThings::Request& request, QueryThings::Response* response) {
        OnQueryThings(loop, request, response);
      });
  queue->Advertise<SetWeatherService>("set_weather", [=](const SetWeatherService::Request& request,
                                                         SetWeatherService::Response* response) {
    response->status = ToStatusMessage(SetWeather(loop, request, response));
  });
  // These give maps of the current world.
  queue->Advertise<GetOctomap>("octomap_full",
                               [=](const GetOctomap::Request&, GetOctomap::Response* response) {
                                 response->map = *MessagesOf(current->Get().get()).octomap_full;
                               });
  queue->Advertise<GetOctomap>("octomap_binary",
                               [=](const GetOctomap::Request&, GetOctomap::Response* response) {
                                 response->map = *MessagesOf(current->Get().get()).octomap_binary;
                               });
  queue->Advertise<GetMap>("static_map", [=](const GetMap::Request&, GetMap::Response* response) {
    response->map = *MessagesOf(current->Get().get()).map;
  });
}

}  // namespace latticeworld
