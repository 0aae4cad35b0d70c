#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "fuzz/seeds/seeds.h"
#include "generation/test_world.h"
#include "latticeworld/campaign/trial_result.h"
#include "latticeworld/episode/journal_json.h"
#include "latticeworld/generation/bundle/agents_json.h"
#include "latticeworld/generation/bundle/assets_csv.h"
#include "latticeworld/generation/bundle/bridges_json.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/props_json.h"
#include "latticeworld/generation/bundle/terrain_file.h"
#include "latticeworld/generation/bundle/things_json.h"
#include "latticeworld/navigation/tasks_json.h"

namespace latticeworld::fuzz {
namespace {

std::string Content(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

void BundleSeeds(const TakeSeed& take) {
  const TemporaryDirectory directory;
  const std::filesystem::path bundle = directory.path() / "world";
  (void)SaveBundle(*MakeTestWorld(), bundle);
  const std::vector<std::pair<std::string, const char*>> files = {
      {"a", "agents.json"},  {"b", "assets.csv"},  {"e", "elements.json"},
      {"f", "replies.json"}, {"g", "things.json"}, {"i", "fidelity.json"}};
  for (const auto& [letter, name] : files) {
    const std::string content = Content(bundle / name);
    if (!content.empty()) take("bundle_json", name, letter + content);
  }
  take("bundle_manifest", "world", Content(bundle / "world.json"));
  Bridge bridge;
  bridge.line = {{-10.0, 0.0}, {10.0, 0.0}};
  take("bundle_json", "bridges.json", "c" + EncodeBridges({bridge}));
}

std::string ExportFiles(const Scene& scene, const std::vector<Bridge>& bridges,
                        const ThingsFile& things) {
  const auto assets = EncodeAssets(scene.assets, *scene.catalogue);
  std::string files;
  for (const std::string& file :
       {EncodeAgents(scene.agents), EncodeProps(scene.props), EncodeBridges(bridges),
        assets.ok() ? *assets : std::string(), EncodeThings(things)}) {
    files += file + std::string(1, '\0');
  }
  return files;
}

// A byte of options, and the files that world_glb and world_sdf take: as the test world has them,
// and with one asset of each kind, which are exported in less time.
void ExportSeeds(const TakeSeed& take) {
  const auto world = MakeTestWorld();
  const Scene& scene = *world->scene;
  Bridge bridge;
  bridge.line = {{-10.0, 0.0}, {10.0, 0.0}};
  bridge.supports_m = {0.0, 20.0};
  const ThingsFile things = {"[]", {{"well_1", "well", 0, 3, {1.5, -2.0}, 0.25}}};
  const std::string files = ExportFiles(scene, {bridge}, things);
  for (const char* target : {"world_glb", "world_sdf"}) {
    take(target, "instances", " " + files);
    take(target, "expanded", "\x22" + files);
    for (const Asset& asset : scene.assets) {
      Scene alone = scene;
      alone.agents.resize(1);
      alone.props.clear();
      alone.assets = {asset};
      take(target, std::string(NameOf(asset.kind)), "$" + ExportFiles(alone, {}, {}));
    }
  }
}

// Level ground of 32 x 32 cells: elevation, water, surface and one class, not packed.
void TerrainSeeds(const TakeSeed& take) {
  constexpr std::size_t kCells = 32 * 32;
  std::string dry;  // NaN, in planes of bytes
  for (const char byte : {'\0', '\0', '\xc0', '\x7f'}) dry += std::string(kCells, byte);
  const std::string grids =
      std::string(4 * kCells, '\0') + dry + std::string(kCells, '\0') + std::string(kCells, '\xff');
  take("bundle_terrain", "level", "!" + grids);
}

void JournalSeeds(const TakeSeed& take) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  SpawnCall spawn;
  spawn.request.position = WorldPoint{1.0, 2.0};
  spawn.request.team = 3;
  spawn.answer = "sheep_1";
  const std::vector<JournalCall> calls = {CommandCall{"robot", {{1.0, 0.0, 0.0}, 0.5}},
                                          CommandJointsCall{"dog", {{"knee", 0.5, kNan, kNan}}},
                                          StrikeCall{"robot"},
                                          SetPolicyCall{{"robot", std::nullopt, "wander"}},
                                          spawn,
                                          RemoveCall{"sheep"},
                                          SpawnPropCall{Prop(), "crate_1"},
                                          RemovePropCall{"crate_1"},
                                          OpenGateCall{"gate", 1.4},
                                          SetWeatherCall{},
                                          ResetCall{7},
                                          SaveCall{1},
                                          RestoreCall{1}};
  for (const JournalCall& call : calls) {
    take("journal", "call_" + std::to_string(call.index()), "a" + EncodeCall(call));
  }
  take("journal", "options", "b" + EncodeSimulatorOptions(SimulatorOptions()));
}

void CampaignSeeds(const TakeSeed& take) {
  TaskSet tasks;
  tasks.world_id = "world-000000000000";
  NavigationTask task;
  task.goal = {5.0, 5.0};
  task.difficulty.length_m = 7.0;
  task.way.points_m = {{0.0, 0.0, 0.0}, {2.5, 2.0, 0.5}, {5.0, 5.0, 0.0}};
  tasks.tasks = {task};
  take("campaign_results", "tasks", "a" + EncodeTasks(tasks));
  TrialResult result;
  result.id = "lake.robot.t00.calm.s1";
  result.world_id = tasks.world_id;
  result.ended_by = "arrival";
  result.driven_m = {{0.0, 0.0}, {1.0, 2.0}};
  take("campaign_results", "result", "b" + EncodeTrialResult(result));
  result.error = "the world is not there";
  take("campaign_results", "error", "b" + EncodeTrialResult(result));
}

}  // namespace

void WorldSeeds(const TakeSeed& take) {
  BundleSeeds(take);
  ExportSeeds(take);
  TerrainSeeds(take);
  JournalSeeds(take);
  CampaignSeeds(take);
}

}  // namespace latticeworld::fuzz
