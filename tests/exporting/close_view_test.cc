#include "latticeworld/exporting/close_view.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>
#include <set>

#include "../mapping/hand_made_scene.h"
#include "decode_picture.h"
#include "latticeworld/exporting/contact_sheet.h"

namespace latticeworld {
namespace {

constexpr PictureOptions kSmall = {96, true};

// A lake in the west, a street with houses in the east, trees in the north, a hill in the south.
Scene Land() {
  Scene scene =
      WithWater(MakeScene(128, 256.0,
                          [](double x_m, double y_m) {
                            return 3.0 + std::min(0.0, 0.2 * (x_m + 70.0)) +
                                   12.0 * std::exp(-(x_m * x_m + (y_m + 90) * (y_m + 90)) / 1500.0);
                          }),
                2.0f);
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  for (int row = 0; row < 128; ++row)
    for (int col = 93; col < 97; ++col) terrain->surface(row, col) = SurfaceClass::kRoad;
  scene.terrain = terrain;
  std::vector<Asset> assets;
  for (int i = 0; i < 6; ++i)
    for (const float side : {-1.0f, 1.0f})
      assets.push_back(MakeBuilding(62.0f + side * 14.0f, -30.0f + 16.0f * static_cast<float>(i),
                                    7.0f, 5.0f, 5.0f, 0.0f));
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 6; ++j)
      assets.push_back(MakeTree(-55.0f + 5.0f * static_cast<float>(i),
                                90.0f + 5.0f * static_cast<float>(j), 9.0f, 2.5f, 0.2f));
  return WithAssets(scene, assets);
}

TEST(CloseViewTest, IsHalfAgainAsWideAsHighAndTheSameEveryTime) {
  CloseView view;
  view.position = {10.0, 5.0};
  const auto png = DrawCloseView(Land(), view, kSmall);
  const cv::Mat picture = Decode(png);
  EXPECT_EQ(picture.cols, 96);
  EXPECT_EQ(picture.rows, 64);
  EXPECT_EQ(*png, *DrawCloseView(Land(), view, kSmall));
  view.heading_rad += 1.0;
  EXPECT_NE(*png, *DrawCloseView(Land(), view, kSmall));
}

TEST(CloseViewTest, EveryUnusableValueIsNamedAtOnce) {
  CloseView view;
  view.position = {1000.0, 5.0};
  view.eye_height_m = -1.0;
  view.heading_rad = std::numeric_limits<double>::quiet_NaN();
  view.pitch_rad = 2.0;
  view.field_of_view_rad = 0.0;
  const auto png = DrawCloseView(Land(), view, kSmall);
  ASSERT_FALSE(png.ok());
  EXPECT_EQ(png.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(png.status().violations().size(), 5u);
  const std::string text = png.status().ToString();
  for (const char* word : {"position x", "1000", "eye_height", "-1", "heading", "pitch", "field"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
  EXPECT_FALSE(DrawCloseView(Land(), CloseView(), {10, true}).ok());
  EXPECT_FALSE(DrawCloseViews(Land(), {}, kSmall).ok());
}

TEST(CloseViewTest, ChosenPlacesShowStreetShoreForestAndHill) {
  const Scene scene = Land();
  std::set<std::string> names;
  for (const CloseView& view : ChooseViews(scene)) {
    names.insert(view.name);
    EXPECT_TRUE(Validate(scene, view).empty()) << view.name;
    EXPECT_EQ(scene.terrain->WaterDepthAt(view.position), 0.0) << view.name;
    scene.index.ForEachNear(view.position, 1.0, [&](std::uint32_t asset) {
      EXPECT_FALSE(SolidContains(scene.assets[asset], view.position, 0.5)) << view.name;
    });
    const WorldPoint ahead = {view.position.x_m + 15.0 * std::cos(view.heading_rad),
                              view.position.y_m + 15.0 * std::sin(view.heading_rad)};
    if (view.name == "shore") EXPECT_GT(scene.terrain->WaterDepthAt(ahead), 0.0);
    if (view.name == "street") {
      EXPECT_EQ(scene.terrain->SurfaceAt(view.position), SurfaceClass::kRoad);
      EXPECT_EQ(scene.terrain->SurfaceAt(ahead), SurfaceClass::kRoad);
    }
  }
  EXPECT_EQ(names, (std::set<std::string>{"street", "shore", "forest", "hill"}));
}

TEST(CloseViewTest, AnEmptyPlainHasAViewToo) {
  const Scene plain = MakeScene(32, 32.0, [](double, double) { return 0.0; });
  EXPECT_FALSE(ChooseViews(plain).empty());
}

TEST(CloseViewTest, ACancelledPictureIsNotDrawn) {
  Progress cancelled;
  cancelled.Cancel();
  PictureOptions options = kSmall;
  options.progress = &cancelled;
  EXPECT_EQ(DrawCloseView(Land(), CloseView(), options).status().code(), StatusCode::kCancelled);
}

TEST(ContactSheetTest, ShowsEverySeasonStyleWeatherAndHour) {
  Scene scene = MakeScene(32, 64.0, [](double x_m, double) { return 0.1 * x_m; });
  PictureOptions options;
  options.width_px = 700;
  const cv::Mat sheet = Decode(DrawContactSheet(scene, 5, options));
  EXPECT_EQ(sheet.cols, 700);
  // Three rows of seven frames, no two of which are alike but for what is the same on purpose.
  EXPECT_GT(sheet.rows, 240);
  options.width_px = 600;
  const auto refused = DrawContactSheet(scene, 5, options);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.status().message().find("600"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
