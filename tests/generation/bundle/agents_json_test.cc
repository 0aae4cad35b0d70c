#include "latticeworld/generation/bundle/agents_json.h"

#include <gtest/gtest.h>

#include "generation/test_world.h"
#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

const GridGeometry& TestGeometry() {
  static const GridGeometry geometry = *GridGeometry::Create(32.0, 0.5);
  return geometry;
}

std::string Replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t offset = text.find(what);
  EXPECT_NE(offset, std::string::npos) << what;
  return text.replace(offset, what.size(), with);
}

TEST(AgentsJsonTest, GivesBackTheSameAgents) {
  const auto agents = MakeTestWorld()->scene->agents;
  const auto decoded = DecodeAgents(EncodeAgents(agents), TestGeometry());
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  ASSERT_EQ(decoded->size(), 3u);
  EXPECT_EQ((*decoded)[1].name, "sheep_2");
  EXPECT_EQ((*decoded)[1].heading_rad, -1.0 / 3.0);
  EXPECT_EQ((*decoded)[2].category, AgentCategory::kWheeledRobot);
  EXPECT_TRUE((*decoded)[2].controllable);
  EXPECT_EQ(EncodeAgents(*decoded), EncodeAgents(agents));
}

TEST(AgentsJsonTest, TakesNoAgents) {
  const auto decoded = DecodeAgents(EncodeAgents({}), TestGeometry());
  ASSERT_TRUE(decoded.ok());
  EXPECT_TRUE(decoded->empty());
}

// A deep value once ended the program when its message was written.
TEST(AgentsJsonTest, HostileDocumentsEndInAnAnswer) {
  const std::string good = EncodeAgents(MakeTestWorld()->scene->agents);
  const std::string deep = std::string(1000000, '[') + std::string(1000000, ']');
  std::string wide = "[{";
  for (int i = 0; i < 100000; ++i) wide += "\"k" + std::to_string(i) + "\": 0, ";
  wide += "\"last\": 0}]";
  for (const std::string& content : {deep, Replaced(good, "\"sheep_1\"", deep), wide}) {
    const auto decoded = DecodeAgents(content, TestGeometry());
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
    EXPECT_LT(decoded.status().message().size(), 1000u);
  }
  RandomStream random(1, "damage");
  for (int i = 0; i < 1000; ++i) {
    std::string damaged = good;
    for (int k = random.UniformInt(1, 3); k > 0; --k) {
      const int at = random.UniformInt(0, static_cast<int>(damaged.size()) - 1);
      if (random.Chance(0.3)) {
        damaged.erase(at, random.UniformInt(1, 20));
      } else {
        damaged[at] = static_cast<char>(damaged[at] ^ 1 << random.UniformInt(0, 7));
      }
    }
    const auto decoded = DecodeAgents(damaged, TestGeometry());
    if (decoded.ok()) {
      for (const AgentStart& agent : *decoded) {
        ASSERT_TRUE(CanBe(agent.category, agent.state));
        ASSERT_TRUE(TestGeometry().Contains(agent.position));
      }
    } else {
      ASSERT_EQ(decoded.status().code(), StatusCode::kDataLoss) << i;
    }
  }
}

TEST(AgentsJsonTest, NamesWhatIsWrong) {
  const std::string good = EncodeAgents(MakeTestWorld()->scene->agents);
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"{}", "not an array"},
      {"[", "parse error"},
      {"[1]", "agent 0"},
      {Replaced(good, "\"sheep_1\"", "\"1 sheep\""), "name is"},
      {Replaced(good, "sheep_2", "sheep_1"), "agent 1: name is"},
      {Replaced(good, "\"category\": \"sheep\"", "\"category\": \"cow\""), "category is"},
      {Replaced(good, "grazing", "flying"), "one that a sheep can be in"},
      {Replaced(good, "\"team\": 0", "\"team\": 0.5"), "team is 0.5"},
      {Replaced(good, "\"team\": 0", "\"team\": -1"), "team is -1"},
      {Replaced(good, "\"x_m\": 7.1", "\"x_m\": 16.1"), "x_m is 16.1"},
      {Replaced(good, "\"x_m\": 7.1", "\"x_m\": \"7.1\""), "x_m is"},
      {Replaced(good, "\"x_m\": 7.1", "\"x_m\": 1e999"), "1e999"},
      {Replaced(good, "\"heading_rad\": 1.0", "\"heading_rad\": 1e300"), "heading_rad is 1e+300"},
      {Replaced(good, "\"x_m\"", "\"X_m\""), "x_m is missing"},
      {Replaced(good, "\"team\"", "\"extra\": 1, \"team\""), "is unknown"},
      {Replaced(good, "\"controllable\": false", "\"controllable\": 0"), "true or false"},
  };
  for (const auto& [content, message] : cases) {
    const auto decoded = DecodeAgents(content, TestGeometry());
    ASSERT_FALSE(decoded.ok()) << message;
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
    EXPECT_NE(decoded.status().message().find(message), std::string::npos)
        << message << " | " << decoded.status().message();
  }
}

TEST(AgentsJsonTest, RefusesADocumentTooLongToHoldAgents) {
  const auto decoded = DecodeAgents("[" + std::string(2 << 20, ' ') + "]", TestGeometry());
  EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
}

TEST(AgentsJsonTest, RefusesMoreAgentsThanAWorldMayHave) {
  std::vector<AgentStart> agents(kMaxAgentStarts + 1);
  for (std::size_t i = 0; i < agents.size(); ++i) agents[i].name = "sheep_" + std::to_string(i);
  EXPECT_FALSE(DecodeAgents(EncodeAgents(agents), TestGeometry()).ok());
  agents.pop_back();
  EXPECT_TRUE(DecodeAgents(EncodeAgents(agents), TestGeometry()).ok());
}

}  // namespace
}  // namespace latticeworld
