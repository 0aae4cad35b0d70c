#include "latticeworld/rendering/views/footer.h"

#include <gtest/gtest.h>

#include <set>

#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

// `count` agents of every category, and words as long as they get.
Scene Crowded(int count) {
  Scene scene = MakeScene(32, 4096.0, [](double, double) { return 0.0; });
  scene.environment.coarse.season = Season::kSummer;
  scene.environment.coarse.weather = Weather::kSandstorm;
  scene.environment.coarse.time_of_day = TimeOfDay::kAfternoon;
  scene.environment.coarse.artistic_style = ArtisticStyle::kCyberpunk;
  for (const auto& category : EnumNames(AgentCategory{})) {
    AgentStart agent;
    agent.category = category.value;
    scene.agents.insert(scene.agents.end(), static_cast<std::size_t>(count), agent);
  }
  return scene;
}

TEST(FooterTest, EveryCategoryFitsOnTheSheetAtAnyWidth) {
  const Scene scene = Crowded(100);
  for (const int width_px : {200, 256, 300, 512, 700, 1200, 4096}) {
    SCOPED_TRACE(width_px);
    const Footer footer = LayOutFooter(scene, width_px, true);
    const Sheet sheet(width_px, footer.lines);
    EXPECT_EQ(footer.legend.size(), EnumNames(AgentCategory{}).size());
    std::vector<FooterLabel> labels = footer.legend;
    labels.push_back(footer.caption);
    for (const FooterLabel& label : labels) {
      EXPECT_GE(label.x_px, sheet.margin) << label.text;
      EXPECT_LE(label.end_px(), width_px - sheet.margin + 1.0f) << label.text;
      EXPECT_GT(sheet.baseline(label.line) - label.letter_px, sheet.height - sheet.footer);
      EXPECT_LT(sheet.baseline(label.line), sheet.height) << label.text;
    }
    for (const FooterLabel& a : labels) {
      for (const FooterLabel& b : labels) {
        if (&a == &b || a.line != b.line) continue;
        EXPECT_TRUE(a.end_px() < b.x_px || b.end_px() < a.x_px) << a.text << ", " << b.text;
      }
    }
  }
}

TEST(FooterTest, CountsEveryCategoryOnce) {
  Scene scene = Crowded(3);
  const Footer footer = LayOutFooter(scene, 800, true);
  std::set<std::string> texts;
  for (const FooterLabel& label : footer.legend) texts.insert(label.text);
  EXPECT_EQ(texts.size(), footer.legend.size());
  EXPECT_EQ(texts.count("3 sheep"), 1u);
}

TEST(FooterTest, WithoutAgentsOrOnTinySheetsThereIsNoLegend) {
  EXPECT_TRUE(LayOutFooter(Crowded(1), 800, false).legend.empty());
  EXPECT_TRUE(LayOutFooter(Crowded(0), 800, true).legend.empty());
  EXPECT_EQ(LayOutFooter(Crowded(1), 100, true).lines, 0);
}

}  // namespace
}  // namespace latticeworld
