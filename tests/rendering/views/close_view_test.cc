#include "latticeworld/rendering/views/close_view.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>
#include <set>

#include "latticeworld/common/random.h"
#include "latticeworld/rendering/views/contact_sheet.h"
#include "mapping/hand_made_scene.h"
#include "rendering/decode_picture.h"

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
  for (int row = 0; row < 20; ++row)  // from y = 88 m on
    for (int col = 36; col < 88; ++col) terrain->surface(row, col) = SurfaceClass::kForestFloor;
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

// 625 trees a hectare on level ground of that class.
Scene Wood(SurfaceClass surface) {
  Scene scene = MakeScene(128, 256.0, [](double, double) { return 2.0; });
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  for (int row = 0; row < 128; ++row)
    for (int col = 0; col < 128; ++col) terrain->surface(row, col) = surface;
  scene.terrain = terrain;
  std::vector<Asset> trees;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const auto shift_m = [&](int stream) { return 3.8 * HashToUnit(stream, i, j) - 1.9; };
      trees.push_back(MakeTree(static_cast<float>(-126.0 + 4.0 * i + shift_m(1)),
                               static_cast<float>(-126.0 + 4.0 * j + shift_m(2)), 12.0f, 2.0f,
                               0.2f));
    }
  }
  return WithAssets(scene, trees);
}

std::set<std::string> NamesOf(const std::vector<CloseView>& views) {
  std::set<std::string> names;
  for (const CloseView& view : views) names.insert(view.name);
  return names;
}

bool IsInCrown(const Scene& scene, const CloseView& view) {
  for (const Asset& tree : scene.assets) {
    if (std::hypot(tree.x_m - view.position.x_m, tree.y_m - view.position.y_m) < tree.half_length_m)
      return true;
  }
  return false;
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
    if (view.name == "shore") {
      EXPECT_GT(scene.terrain->WaterDepthAt(ahead), 0.0);
    }
    if (view.name == "street") {
      EXPECT_EQ(scene.terrain->SurfaceAt(view.position), SurfaceClass::kRoad);
      EXPECT_EQ(scene.terrain->SurfaceAt(ahead), SurfaceClass::kRoad);
    }
  }
  EXPECT_EQ(names, (std::set<std::string>{"street", "shore", "forest", "hill"}));
}

TEST(CloseViewTest, AForestEverywhereHasAViewOfItFromBetweenTheCrowns) {
  const Scene scene = Wood(SurfaceClass::kForestFloor);
  const std::vector<CloseView> views = ChooseViews(scene);
  ASSERT_EQ(NamesOf(views), std::set<std::string>{"forest"});
  EXPECT_FALSE(IsInCrown(scene, views.front()));
}

TEST(CloseViewTest, TreesOnOtherGroundAreNoForestAndLevelGroundIsNoHill) {
  const Scene scene = Wood(SurfaceClass::kGrass);
  const std::vector<CloseView> views = ChooseViews(scene);
  ASSERT_EQ(NamesOf(views), std::set<std::string>{"middle"});
  const CloseView& middle = views.front();
  EXPECT_FALSE(IsInCrown(scene, middle));
  EXPECT_LT(middle.eye_height_m, 2.0);
  // Open ahead: no trunk within 8 m of the way that it looks.
  for (double away_m = 0.0; away_m <= 8.0; away_m += 0.5) {
    const WorldPoint at = {middle.position.x_m + away_m * std::cos(middle.heading_rad),
                           middle.position.y_m + away_m * std::sin(middle.heading_rad)};
    scene.index.ForEachNear(at, 0.5, [&](std::uint32_t) { ADD_FAILURE() << away_m; });
  }
}

TEST(CloseViewTest, NobodyLooksOutOfAWall) {
  const Scene scene = WithAssets(MakeScene(32, 64.0, [](double x_m, double) { return 0.1 * x_m; }),
                                 {MakeBuilding(0.0f, 0.0f, 6.0f, 5.0f, 4.0f, 0.5f)});
  CloseView view;
  view.position = {1.0, 1.0};
  const std::vector<Violation> violations = Validate(scene, view);
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations.front().pointer, "position");
  view.eye_height_m = 7.0;  // above the roof
  EXPECT_TRUE(Validate(scene, view).empty());
  view.eye_height_m = 1.7;
  view.position = {0.0, 10.0};
  EXPECT_TRUE(Validate(scene, view).empty());
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

TEST(ContactSheetTest, KeepsTheEnvironmentsOwnValuesWhereTheyStayLegal) {
  const Catalogue& catalogue = *Catalogue::BuiltIn();
  EnvironmentConfig environment;
  environment.fine = DeriveFineAttributes(environment.coarse, catalogue);
  environment.fine_of(AssetType::kGrass).density = 0.07;
  environment.fine_of(AssetType::kForest).density = 0.91;
  EXPECT_EQ(ToJson(ChangedEnvironment(environment, environment.coarse, catalogue)),
            ToJson(environment));
  for (const auto& season : EnumNames(Season{})) {
    for (const auto& weather : EnumNames(Weather{})) {
      CoarseAttributes coarse = environment.coarse;
      coarse.season = season.value;
      coarse.weather = weather.value;
      const EnvironmentConfig changed = ChangedEnvironment(environment, coarse, catalogue);
      const FineAttributes usual = DeriveFineAttributes(coarse, catalogue);
      EXPECT_TRUE(Validate(changed, catalogue).empty()) << season.name << " " << weather.name;
      EXPECT_LT(changed.fine_of(AssetType::kGrass).density, 0.2);
      EXPECT_NE(changed.fine_of(AssetType::kGrass).density,
                usual[static_cast<int>(AssetType::kGrass)].density);
    }
  }
}

}  // namespace
}  // namespace latticeworld
