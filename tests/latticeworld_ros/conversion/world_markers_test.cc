#include "latticeworld_ros/conversion/world_markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "latticeworld/generation/world_generator.h"
#include "latticeworld_ros/conversion/marker_pieces.h"

namespace latticeworld {
namespace {

using visualization_msgs::Marker;

std::shared_ptr<const World> ForestWithALake(double size_m) {
  GenerationRequest request;
  request.layout_instruction = "Dense forest everywhere, a lake in the center.";
  request.environment_instruction = "A sunny summer noon.";
  request.seed = 3;
  request.size_m = size_m;
  return MakeDefaultWorldGenerator().Generate(request, Progress()).value();
}

std::map<std::string, std::size_t> TrianglesByNamespace(
    const visualization_msgs::MarkerArray& array) {
  std::map<std::string, std::size_t> triangles;
  for (const Marker& marker : array.markers) triangles[marker.ns] += marker.colors.size();
  return triangles;
}

TEST(WorldMarkersTest, PiecesAreBoundedAndNamedOnce) {
  const auto world = ForestWithALake(256.0);
  const auto array = ToMarkerArray(*world->scene, WorldMarkerOptions());
  ASSERT_GT(array.markers.size(), 20u);
  EXPECT_EQ(array.markers.front().action, static_cast<int>(Marker::DELETEALL));
  std::set<std::pair<std::string, int>> names;
  for (auto marker = array.markers.begin() + 1; marker != array.markers.end(); ++marker) {
    EXPECT_TRUE(names.emplace(marker->ns, marker->id).second) << marker->ns << marker->id;
    ASSERT_FALSE(marker->points.empty());
    EXPECT_EQ(marker->points.size(), 3 * marker->colors.size());
    EXPECT_LE(marker->colors.size(), MarkerPieces::kMaxTriangles);
    // A piece covers its tile and what leans over its border, not the world.
    const auto [west, east] =
        std::minmax_element(marker->points.begin(), marker->points.end(),
                            [](const auto& a, const auto& b) { return a.x < b.x; });
    constexpr double kWidestCrown_m = 16.0;
    EXPECT_LE(east->x - west->x, MarkerPieces::kTile_m + 2.0 * kWidestCrown_m) << marker->ns;
  }
}

TEST(WorldMarkersTest, EveryDrawnAssetIsThereOnce) {
  const auto world = ForestWithALake(128.0);
  const auto triangles = TrianglesByNamespace(ToMarkerArray(*world->scene, WorldMarkerOptions()));
  std::map<AssetKind, std::size_t> counts;
  for (const Asset& asset : world->scene->assets) ++counts[asset.kind];
  EXPECT_EQ(triangles.at("trees"), 10 * counts[AssetKind::kTree]);
  EXPECT_EQ(triangles.at("bushes"), 8 * counts[AssetKind::kBush]);
  EXPECT_EQ(triangles.at("ground"), 2u * 128u * 128u);
  EXPECT_GT(triangles.at("water"), 0u);
}

TEST(WorldMarkersTest, MoreThanTheLimitIsThinnedOutToIt) {
  const auto world = ForestWithALake(128.0);
  WorldMarkerOptions options;
  options.max_assets = 100;
  auto triangles = TrianglesByNamespace(ToMarkerArray(*world->scene, options));
  EXPECT_EQ(triangles["trees"] / 10 + triangles["bushes"] / 8 + triangles["stones"] / 8, 100u);
}

TEST(MarkerPiecesTest, ATileThatOverflowsGoesOnInFurtherMarkers) {
  MarkerPieces pieces("trees", 128.0);
  pieces.MoveTo({10.0, 10.0});
  for (std::size_t i = 0; i < MarkerPieces::kMaxTriangles + 7; ++i) pieces.Add({}, {}, {}, {});
  pieces.MoveTo({-10.0, 10.0});
  pieces.Add({}, {}, {}, {});
  const auto markers = pieces.Take();
  ASSERT_EQ(markers.size(), 3u);
  EXPECT_EQ(markers[0].colors.size(), 1u);
  EXPECT_EQ(markers[1].colors.size(), MarkerPieces::kMaxTriangles);
  EXPECT_EQ(markers[2].colors.size(), 7u);
}

}  // namespace
}  // namespace latticeworld
