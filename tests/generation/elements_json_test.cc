#include "latticeworld/generation/elements_json.h"

#include <gtest/gtest.h>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/elements.h"

namespace latticeworld {
namespace {

const GridGeometry& TestGeometry() {
  static const GridGeometry geometry = *GridGeometry::Create(32.0, 0.5);
  return geometry;
}

std::vector<Element> OneOfEach() {
  std::vector<Element> elements;
  for (const auto& entry : EnumNames(ElementKind{})) {
    Element element = UsualElement(entry.value);
    element.name = "thing_" + std::to_string(elements.size());
    element.position = {1.0 / 3.0 + static_cast<double>(elements.size()), -2.0 / 7.0};
    element.z_m = 0.1;
    element.yaw_rad = -1.0 / 3.0;
    elements.push_back(element);
  }
  return elements;
}

std::string Replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t offset = text.find(what);
  EXPECT_NE(offset, std::string::npos) << what;
  return text.replace(offset, what.size(), with);
}

TEST(ElementsJsonTest, GivesBackTheSameElements) {
  const std::vector<Element> elements = OneOfEach();
  const auto decoded = DecodeElements(EncodeElements(elements), TestGeometry(), {});
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  ASSERT_EQ(decoded->size(), elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    EXPECT_EQ((*decoded)[i].kind, elements[i].kind);
    EXPECT_EQ((*decoded)[i].position.x_m, elements[i].position.x_m);
    EXPECT_EQ((*decoded)[i].size_m, elements[i].size_m);
    EXPECT_EQ((*decoded)[i].mass_kg, elements[i].mass_kg);
    EXPECT_EQ((*decoded)[i].strength, elements[i].strength);
  }
  EXPECT_EQ(EncodeElements(*decoded), EncodeElements(elements));
  EXPECT_TRUE(DecodeElements(EncodeElements({}), TestGeometry(), {})->empty());
}

TEST(ElementsJsonTest, NamesWhatIsWrong) {
  const std::string good = EncodeElements(OneOfEach());
  for (const auto& [what, with] : std::vector<std::pair<std::string, std::string>>{
           {"\"thing_1\"", "\"thing_0\""},
           {"\"thing_1\"", "\"1thing\""},
           {"\"crate\"", "\"create\""},
           {"\"z_m\"", "\"z\""},
           {"\"yaw_rad\": -0.3", "\"yaw_rad\": \"north\", \"x\": -0.3"},
           {"\"x_m\": 0.3", "\"x_m\": 1000.3"},
           {"\"mass_kg\": ", "\"mass_kg\": -1"}}) {
    const auto decoded = DecodeElements(Replaced(good, what, with), TestGeometry(), {});
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss) << with;
    EXPECT_NE(decoded.status().message().find("element "), std::string::npos) << with;
  }
  AgentStart robot;
  robot.name = "thing_2";
  EXPECT_EQ(DecodeElements(good, TestGeometry(), {robot}).status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(DecodeElements("{}", TestGeometry(), {}).status().code(), StatusCode::kDataLoss);
}

TEST(ElementsJsonTest, DamageEndsInAnAnswer) {
  const std::string good = EncodeElements(OneOfEach());
  RandomStream random(1, "damage");
  for (int i = 0; i < 1000; ++i) {
    std::string damaged = good;
    for (int k = random.UniformInt(1, 3); k > 0; --k) {
      const int at = random.UniformInt(0, static_cast<int>(damaged.size()) - 1);
      if (random.Chance(0.3)) {
        damaged.erase(static_cast<std::size_t>(at), 7);
      } else {
        damaged[static_cast<std::size_t>(at)] = static_cast<char>(random.UniformInt(1, 127));
      }
    }
    const auto decoded = DecodeElements(damaged, TestGeometry(), {});
    if (!decoded.ok()) {
      EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
    }
  }
}

}  // namespace
}  // namespace latticeworld
