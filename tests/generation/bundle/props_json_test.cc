#include "latticeworld/generation/bundle/props_json.h"

#include <gtest/gtest.h>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/props/props.h"

namespace latticeworld {
namespace {

const GridGeometry& TestGeometry() {
  static const GridGeometry geometry = *GridGeometry::Create(32.0, 0.5);
  return geometry;
}

std::vector<Prop> OneOfEach() {
  std::vector<Prop> props;
  for (const auto& entry : EnumNames(PropKind{})) {
    Prop prop = UsualProp(entry.value);
    prop.name = "thing_" + std::to_string(props.size());
    prop.position = {1.0 / 3.0 + static_cast<double>(props.size()), -2.0 / 7.0};
    prop.z_m = 0.1;
    prop.yaw_rad = -1.0 / 3.0;
    props.push_back(prop);
  }
  return props;
}

std::string Replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t offset = text.find(what);
  EXPECT_NE(offset, std::string::npos) << what;
  return text.replace(offset, what.size(), with);
}

TEST(PropsJsonTest, GivesBackTheSameProps) {
  const std::vector<Prop> props = OneOfEach();
  const auto decoded = DecodeProps(EncodeProps(props), TestGeometry(), {});
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  ASSERT_EQ(decoded->size(), props.size());
  for (std::size_t i = 0; i < props.size(); ++i) {
    EXPECT_EQ((*decoded)[i].kind, props[i].kind);
    EXPECT_EQ((*decoded)[i].position.x_m, props[i].position.x_m);
    EXPECT_EQ((*decoded)[i].size_m, props[i].size_m);
    EXPECT_EQ((*decoded)[i].mass_kg, props[i].mass_kg);
    EXPECT_EQ((*decoded)[i].strength, props[i].strength);
  }
  EXPECT_EQ(EncodeProps(*decoded), EncodeProps(props));
  EXPECT_TRUE(DecodeProps(EncodeProps({}), TestGeometry(), {})->empty());
}

TEST(PropsJsonTest, NamesWhatIsWrong) {
  const std::string good = EncodeProps(OneOfEach());
  for (const auto& [what, with] : std::vector<std::pair<std::string, std::string>>{
           {"\"thing_1\"", "\"thing_0\""},
           {"\"thing_1\"", "\"1thing\""},
           {"\"crate\"", "\"create\""},
           {"\"z_m\"", "\"z\""},
           {"\"yaw_rad\": -0.3", "\"yaw_rad\": \"north\", \"x\": -0.3"},
           {"\"x_m\": 0.3", "\"x_m\": 1000.3"},
           {"\"mass_kg\": ", "\"mass_kg\": -1"}}) {
    const auto decoded = DecodeProps(Replaced(good, what, with), TestGeometry(), {});
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss) << with;
    EXPECT_NE(decoded.status().message().find("element "), std::string::npos) << with;
  }
  Prop crate = OneOfEach().front();
  crate.size_m.y() = 50.0;
  crate.mass_kg = -1.0;
  const std::string message =
      DecodeProps(EncodeProps({crate}), TestGeometry(), {}).status().message();
  for (const char* word : {"width_m", "50", "mass_kg", "-1"}) {
    EXPECT_NE(message.find(word), std::string::npos) << message;
  }
  AgentStart robot;
  robot.name = "thing_2";
  EXPECT_EQ(DecodeProps(good, TestGeometry(), {robot}).status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(DecodeProps("{}", TestGeometry(), {}).status().code(), StatusCode::kDataLoss);
}

TEST(PropsJsonTest, DamageEndsInAnAnswer) {
  const std::string good = EncodeProps(OneOfEach());
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
    const auto decoded = DecodeProps(damaged, TestGeometry(), {});
    if (!decoded.ok()) {
      EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
    }
  }
}

}  // namespace
}  // namespace latticeworld
