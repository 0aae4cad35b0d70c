#include "latticeworld/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/random.h"
#include "latticeworld/scene/agents/agent_placement.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/props/things.h"
#include "latticeworld/scene/vegetation/fields.h"

namespace latticeworld {
namespace {

// Keeps the expected number of assets below kMaxAssets. The number that a world gets varies by its
// square root, far less than the margin.
void ThinToLimit(Placement* placement, std::vector<std::string>* warnings) {
  constexpr double kMargin = 0.9;
  const OfKinds expected = ExpectedAssets(*placement);
  const double sum = std::accumulate(expected.begin(), expected.end(), 0.0);
  if (sum <= kMargin * kMaxAssets) return;
  placement->thinning = Thinning(expected, kMargin * kMaxAssets);
  char text[300];
  std::snprintf(
      text, sizeof(text),
      "a world of %.0f m with these densities would hold about %.0f assets: bushes, grass "
      "tufts, flowers and crops are thinned to %.3g %% of their densities, trees, stones "
      "and dead branches to %.3g %%, at most %d assets",
      placement->terrain.geometry().size_m(), sum,
      100.0 * placement->thinning[AssetKind::kGrassTuft],
      100.0 * placement->thinning[AssetKind::kTree], kMaxAssets);
  warnings->push_back(text);
}

// A thing that was given the name of an agent gets another one.
void GiveOwnNames(Scene* scene, std::vector<std::string>* warnings) {
  for (SceneThing& thing : scene->things) {
    const bool taken =
        std::any_of(scene->agents.begin(), scene->agents.end(),
                    [&](const AgentStart& agent) { return agent.name == thing.name; });
    if (!taken) continue;
    const std::string name = thing.name + "_thing";
    warnings->push_back("the thing " + thing.name + " is called " + name +
                        ": an agent has its name");
    for (Prop& prop : scene->props) {
      if (prop.name == thing.name) prop.name = name;
    }
    thing.name = name;
  }
}

// Nothing grows or lies in the decks of bridges that lead over dry ground, which are those over
// gorges.
void KeepDecksClear(Placement* placement) {
  constexpr double kHigh_m = 4.0;  // above the ground: bridges over water lie lower
  const Terrain& terrain = placement->terrain;
  for (const Bridge& bridge : terrain.bridges) {
    const WorldPoint middle = PlaceOn(bridge, 0.5 * bridge.length_m()).point;
    const bool dry = terrain.WaterDepthAt(middle) <= 0.0;
    if (!dry || bridge.deck_z_m - terrain.ground.HeightAt(middle) < kHigh_m) continue;
    const double radius_m = 0.5 * bridge.width_m;
    for (double along_m = 0.0; along_m <= bridge.length_m(); along_m += radius_m) {
      placement->solids.Add(PlaceOn(bridge, along_m).point, radius_m);
    }
  }
}

}  // namespace

Result<SceneAnswer> BuildScene(const SceneRequest& request, const Progress& progress) {
  LW_CHECK(request.terrain != nullptr, "a scene stands on a terrain");
  const Terrain& terrain = *request.terrain;
  SceneAnswer answer;
  auto scene = std::make_shared<Scene>();
  scene->terrain = request.terrain;
  scene->catalogue = request.catalogue;
  scene->environment = request.environment;

  RandomStream wind(request.seed, "scene/wind");
  scene->atmosphere = DeriveAtmosphere(request.environment.coarse,
                                       request.environment.fine_of(AssetType::kDesert).wind_mps,
                                       wind.Uniform(-M_PI, M_PI), request.latitude_deg);

  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  Placement placement(terrain, *request.catalogue, request.environment, request.seed,
                      request.threads);
  placement.progress = &progress;
  placement.fields = std::make_shared<const FieldPlan>(placement);
  ThinToLimit(&placement, &answer.warnings);
  for (const auto& kind : EnumNames(AssetKind{})) {
    placement.tally.Of(kind.value).wanted =
        DensityFor(placement, kind.value).Expected(terrain.geometry());
  }
  double done = 0.0;
  const auto step = [&progress, &done]() {
    constexpr double kStages = 11.0;  // eight kinds, orchards, shores and the agents
    done += 1.0;
    progress.Report("scene", done / kStages);
    return progress.CheckCancelled();
  };
  PlaceBuildings(&placement);
  KeepDecksClear(&placement);
  LW_RETURN_IF_ERROR(step());
  if (!request.things.empty()) {
    PlacedThings placed = PlaceThings(request.things, &placement);
    scene->things = std::move(placed.things);
    scene->props = std::move(placed.props);
    for (std::string& warning : placed.warnings) answer.warnings.push_back(std::move(warning));
  }
  for (const auto place : {PlaceOrchards, PlaceTrees, PlaceStones}) {
    place(&placement);
    LW_RETURN_IF_ERROR(step());
  }
  placement.canopy = Canopy(terrain.geometry().size_m(), placement.assets, request.threads);
  // What follows is not solid, so that the index stays true.
  scene->index = AssetIndex(terrain.geometry().size_m(), placement.assets);
  for (const auto place : {PlaceShorePlants, PlaceBushes, PlaceDeadBranches, PlaceCrops,
                           PlaceFlowers, PlaceGrassTufts}) {
    place(&placement, scene->index);
    LW_RETURN_IF_ERROR(step());
  }
  scene->assets = std::move(placement.assets);
  scene->assets.shrink_to_fit();
  answer.counts = placement.tally.Count(scene->assets);
  for (std::string& warning : placement.tally.Shortfalls(answer.counts)) {
    answer.warnings.push_back(std::move(warning));
  }
  if (placement.left_out > 0) {
    answer.warnings.push_back("left out " + std::to_string(placement.left_out) +
                              " assets: a world holds at most " + std::to_string(kMaxAssets));
  }
  scene->agents = PlaceAgents(*scene, request.seed, &answer.warnings);
  GiveOwnNames(scene.get(), &answer.warnings);
  scene->props = PlaceProps(*scene, request.seed);
  LW_RETURN_IF_ERROR(step());
  answer.scene = std::move(scene);
  return answer;
}

}  // namespace latticeworld
