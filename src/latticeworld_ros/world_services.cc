#include "latticeworld_ros/world_services.h"

#include <memory>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "latticeworld/environment/environment_config.h"
#include "latticeworld/generation/bundle.h"
#include "latticeworld_ros/agent_conversion.h"
#include "latticeworld_ros/bundle_name.h"
#include "latticeworld_ros/status_conversion.h"
#include "latticeworld_ros/weather_conversion.h"
#include "latticeworld_ros/world_conversion.h"

namespace latticeworld {
namespace {

Status NoWorld() {
  return FailedPrecondition("no world is running; call generate_world or load_world first");
}

const WorldMessages& MessagesOf(const PublishedWorld* current) {
  if (current == nullptr) throw std::runtime_error(NoWorld().message());
  return current->messages;
}

}  // namespace

WorldServices::WorldServices(ros::NodeHandle node, std::filesystem::path worlds_directory,
                             SimulationLoop* loop, RobotTopics* robots, const CurrentWorld* current)
    : worlds_directory_(std::move(worlds_directory)),
      loop_(loop),
      robots_(robots),
      current_(current),
      node_(std::move(node)) {
  node_.setCallbackQueue(&queue_);
  Advertise<latticeworld_msgs::GetWorld>("get_world", &WorldServices::OnGet);
  Advertise<latticeworld_msgs::SaveWorld>("save_world", &WorldServices::OnSave);
  Advertise<latticeworld_msgs::ListWorlds>("list_worlds", &WorldServices::OnList);
  Advertise<latticeworld_msgs::QueryTerrain>("query_terrain", &WorldServices::OnQuery);
  Advertise<latticeworld_msgs::SpawnAgent>("spawn_agent", &WorldServices::OnSpawn);
  Advertise<latticeworld_msgs::RemoveAgent>("remove_agent", &WorldServices::OnRemove);
  Advertise<latticeworld_msgs::SetWeather>("set_weather", &WorldServices::OnSetWeather);
  Advertise<latticeworld_msgs::ResetWorld>("reset_world", &WorldServices::OnReset);
  Advertise<latticeworld_msgs::Step>("step", &WorldServices::OnStep);
  Advertise<std_srvs::Trigger>("pause", &WorldServices::OnPause);
  Advertise<std_srvs::Trigger>("unpause", &WorldServices::OnUnpause);
  Advertise<octomap_msgs::GetOctomap>("octomap_full", &WorldServices::OnOctomapFull);
  Advertise<octomap_msgs::GetOctomap>("octomap_binary", &WorldServices::OnOctomapBinary);
  Advertise<nav_msgs::GetMap>("static_map", &WorldServices::OnStaticMap);
}

WorldServices::~WorldServices() { Stop(); }

template <typename Service>
void WorldServices::Advertise(const char* name, Handler<Service> handler) {
  servers_.push_back(node_.advertiseService(name, handler, this));
}

void WorldServices::Start() { spinner_.start(); }

void WorldServices::Stop() {
  for (ros::ServiceServer& server : servers_) server.shutdown();
  spinner_.stop();
}

bool WorldServices::OnGet(latticeworld_msgs::GetWorld::Request&,
                          latticeworld_msgs::GetWorld::Response& response) {
  const Result<SimulationLoop::Snapshot> snapshot = loop_->Inspect(/*hash=*/true);
  response.status = ToRos(snapshot.status());
  if (!snapshot.ok()) return true;
  const World& world = *snapshot->world;
  response.info = ToInfo(world);
  // The stamp belongs to the running world, which may be another one by now.
  const std::shared_ptr<const PublishedWorld> current = current_->Get();
  if (current != nullptr && current->world == snapshot->world) {
    response.info.header.stamp = current->messages.info->header.stamp;
  }
  response.layout = ToText(world.layout);
  response.environment = ToJson(world.environment);
  response.environment_schema = EnvironmentSchema(*world.scene->catalogue);
  response.fidelity = ToRos(world.fidelity.claims);
  response.not_understood = world.fidelity.not_understood;
  response.warnings = world.warnings;
  response.stages = ToRos(world.stages);
  response.step = snapshot->step;
  response.episode_step = snapshot->episode_step;
  response.paused = snapshot->paused;
  response.state_hash = snapshot->state_hash;
  return true;
}

bool WorldServices::OnSave(latticeworld_msgs::SaveWorld::Request& request,
                           latticeworld_msgs::SaveWorld::Response& response) {
  const auto save = [&]() -> Status {
    const std::shared_ptr<const PublishedWorld> current = current_->Get();
    if (current == nullptr) return NoWorld();
    const std::string name = request.name.empty() ? current->world->id : request.name;
    LW_RETURN_IF_ERROR(CheckBundleName(name));
    response.world_id = current->world->id;
    // A directory that cannot be made is told by SaveBundle, in its words.
    std::error_code ignored;
    std::filesystem::create_directories(worlds_directory_, ignored);
    const std::filesystem::path path = worlds_directory_ / name;
    const Status saved = SaveBundle(*current->world, path);
    if (saved.ok() || saved.code() == StatusCode::kAlreadyExists) response.path = path.string();
    return saved;
  };
  response.status = ToRos(save());
  return true;
}

bool WorldServices::OnList(latticeworld_msgs::ListWorlds::Request&,
                           latticeworld_msgs::ListWorlds::Response& response) {
  response.directory = worlds_directory_.string();
  const Result<std::vector<BundleSummary>> bundles = ListBundles(worlds_directory_);
  response.status = ToRos(bundles.status());
  if (!bundles.ok()) return true;
  for (const BundleSummary& bundle : *bundles) {
    latticeworld_msgs::WorldBundle message;
    message.name = bundle.name;
    message.world_id = bundle.world_id;
    message.layout_instruction = bundle.layout_instruction;
    response.worlds.push_back(std::move(message));
  }
  return true;
}

bool WorldServices::OnQuery(latticeworld_msgs::QueryTerrain::Request& request,
                            latticeworld_msgs::QueryTerrain::Response& response) {
  const Result<SimulationLoop::Snapshot> snapshot = loop_->Inspect(/*hash=*/false);
  response.status = ToRos(snapshot.status());
  if (!snapshot.ok()) return true;
  response.world_id = snapshot->world->id;
  Result<std::vector<latticeworld_msgs::TerrainSample>> samples =
      SampleTerrain(*snapshot->world->scene, snapshot->atmosphere, request.points);
  response.status = ToRos(samples.status());
  if (samples.ok()) response.samples = std::move(samples).value();
  return true;
}

bool WorldServices::OnSpawn(latticeworld_msgs::SpawnAgent::Request& request,
                            latticeworld_msgs::SpawnAgent::Response& response) {
  const auto spawn = [&]() -> Status {
    LW_ASSIGN_OR_RETURN(const SpawnRequest core_request, FromRos(request));
    LW_ASSIGN_OR_RETURN(const SimulationLoop::Agent agent, loop_->Spawn(core_request));
    robots_->WaitUntilReady();
    response.world_id = agent.world_id;
    response.name = agent.name;
    return Status();
  };
  response.status = ToRos(spawn());
  return true;
}

bool WorldServices::OnRemove(latticeworld_msgs::RemoveAgent::Request& request,
                             latticeworld_msgs::RemoveAgent::Response& response) {
  const Result<SimulationLoop::Agent> agent = loop_->Remove(request.name);
  response.status = ToRos(agent.status());
  if (agent.ok()) {
    robots_->WaitUntilReady();
    response.world_id = agent->world_id;
  }
  return true;
}

bool WorldServices::OnSetWeather(latticeworld_msgs::SetWeather::Request& request,
                                 latticeworld_msgs::SetWeather::Response& response) {
  const auto set = [&]() -> Status {
    LW_ASSIGN_OR_RETURN(const WeatherChange change, FromRos(request));
    LW_ASSIGN_OR_RETURN(const SimulationLoop::WeatherAnswer answer, loop_->SetWeather(change));
    response.world_id = answer.world_id;
    response.weather = ToRos(answer.target, 0.0, answer.now, answer.world_id);
    return Status();
  };
  response.status = ToRos(set());
  return true;
}

bool WorldServices::OnReset(latticeworld_msgs::ResetWorld::Request& request,
                            latticeworld_msgs::ResetWorld::Response& response) {
  const Result<SimulationLoop::Snapshot> snapshot = loop_->Reset(request.seed);
  response.status = ToRos(snapshot.status());
  if (!snapshot.ok()) return true;
  robots_->WaitUntilReady();
  response.world_id = snapshot->world->id;
  response.seed = snapshot->seed;
  response.state_hash = snapshot->state_hash;
  return true;
}

bool WorldServices::OnStep(latticeworld_msgs::Step::Request& request,
                           latticeworld_msgs::Step::Response& response) {
  const std::uint32_t steps = request.steps == 0 ? 1 : request.steps;
  const Result<SimulationLoop::Snapshot> snapshot = loop_->Step(steps, request.hash);
  response.status = ToRos(snapshot.status());
  if (!snapshot.ok()) return true;
  response.world_id = snapshot->world->id;
  response.step = snapshot->step;
  response.episode_step = snapshot->episode_step;
  response.stamp = snapshot->now;
  response.state_hash = snapshot->state_hash;
  return true;
}

bool WorldServices::OnPause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const Status status = loop_->SetPaused(true);
  response.success = status.ok();
  response.message = status.ok() ? "paused" : status.ToString();
  return true;
}

bool WorldServices::OnUnpause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const Status status = loop_->SetPaused(false);
  response.success = status.ok();
  response.message = status.ok() ? "running" : status.ToString();
  return true;
}

// These three types have no status: as with octomap_server and map_server, the call itself fails
// while there is nothing to give. roscpp passes the words of an exception on to the caller.
bool WorldServices::OnOctomapFull(octomap_msgs::GetOctomap::Request&,
                                  octomap_msgs::GetOctomap::Response& response) {
  const std::shared_ptr<const PublishedWorld> current = current_->Get();
  response.map = *MessagesOf(current.get()).octomap_full;
  return true;
}

bool WorldServices::OnOctomapBinary(octomap_msgs::GetOctomap::Request&,
                                    octomap_msgs::GetOctomap::Response& response) {
  const std::shared_ptr<const PublishedWorld> current = current_->Get();
  response.map = *MessagesOf(current.get()).octomap_binary;
  return true;
}

bool WorldServices::OnStaticMap(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
  const std::shared_ptr<const PublishedWorld> current = current_->Get();
  response.map = *MessagesOf(current.get()).map;
  return true;
}

}  // namespace latticeworld
