#include "latticeworld/mapping/traversability_window.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/props/standing_props.h"
#include "mapping/scene_of_everything.h"

namespace latticeworld {
namespace {

RobotLimits Limits(double radius_m) {
  RobotLimits limits;
  limits.radius_m = radius_m;
  limits.clearance_m = 0.0;
  return limits;
}

// Crates, posts, gates and bridges anywhere.
StandingProps SomeProps(RandomStream* random) {
  StandingProps props;
  for (int i = 0; i < 12; ++i) {
    Prop prop = UsualProp(static_cast<PropKind>(random->UniformInt(0, 4)));
    prop.position = {random->Uniform(-17.0, 17.0), random->Uniform(-17.0, 17.0)};
    prop.yaw_rad = random->Uniform(-3.0, 3.0);
    prop.z_m = random->Uniform(-1.0, 3.0);
    const StandingProps one = StandingAtBegin({prop});
    props.blocks.insert(props.blocks.end(), one.blocks.begin(), one.blocks.end());
    props.decks.insert(props.decks.end(), one.decks.begin(), one.decks.end());
  }
  return props;
}

// Some trees lie, some assets of any kind are gone.
SceneChanges SomeChanges(const Scene& scene, RandomStream* random) {
  SceneChanges changes;
  for (std::uint32_t i = 0; i < scene.assets.size(); ++i) {
    const Asset& asset = scene.assets[i];
    const int fate = random->UniformInt(0, 3);
    if (fate == 0) changes.gone.push_back(i);
    if (fate != 1 || asset.kind != AssetKind::kTree) continue;
    const double heading_rad = random->Uniform(-3.0, 3.0);
    const Eigen::Vector3d foot(asset.x_m, asset.y_m, asset.z_m + asset.trunk_radius_m);
    const Eigen::Vector3d way(std::cos(heading_rad), std::sin(heading_rad), 0.0);
    changes.fallen.push_back({i, foot, foot + asset.height_m * way});
  }
  return changes;
}

TEST(TraversabilityWindowTest, HoldsWhatTheWholeMapHoldsThere) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene = SceneOfEverything(seed);
    RandomStream random(seed, "windows");
    SceneChanges changes = seed % 2 == 0 ? SceneChanges() : SomeChanges(scene, &random);
    if (seed % 3 != 0) {
      changes.props = std::make_shared<const StandingProps>(SomeProps(&random));
    }
    if (seed % 2 != 0) changes.ground = GroundState{random.Uniform(), random.Uniform(), 0.0};
    const RobotLimits limits = Limits(random.Uniform(0.0, 2.0));
    const Grid<float> whole = BuildTraversability(scene, limits, changes);
    const TraversabilityWindow part(scene, limits);
    for (int i = 0; i < 20; ++i) {
      CellWindow window;
      window.row_begin = random.UniformInt(0, whole.rows() - 1);
      window.row_end = random.UniformInt(window.row_begin + 1, whole.rows());
      window.col_begin = random.UniformInt(0, whole.cols() - 1);
      window.col_end = random.UniformInt(window.col_begin + 1, whole.cols());
      std::vector<float> values(static_cast<std::size_t>(window.rows() * window.cols()));
      part.Fill(window, changes, values.data());
      for (int row = 0; row < window.rows(); ++row) {
        for (int col = 0; col < window.cols(); ++col)
          ASSERT_EQ(values[static_cast<std::size_t>(row * window.cols() + col)],
                    whole(window.row_begin + row, window.col_begin + col))
              << "seed " << seed << ", window " << i << ", " << row << " " << col;
      }
    }
  }
}

}  // namespace
}  // namespace latticeworld
