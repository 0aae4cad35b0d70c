#include "latticeworld/generation/fidelity/fidelity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "generation/test_world.h"
#include "latticeworld/generation/bundle/replies_json.h"
#include "latticeworld/generation/fidelity/fidelity_json.h"
#include "latticeworld/language/reading/relief/relief_reading.h"

namespace latticeworld {
namespace {

SymbolicLayout Uniform(char letter) {
  return {Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, letter)};
}

EnvironmentConfig Autumn() {
  EnvironmentConfig environment;
  environment.coarse.season = Season::kAutumn;
  environment.fine = DeriveFineAttributes(environment.coarse);
  return environment;
}

// The instructions as the rules read them.
FidelityReport Assess(const std::string& layout_instruction,
                      const std::string& environment_instruction, const SymbolicLayout& layout,
                      const EnvironmentConfig& environment) {
  const std::unique_ptr<InstructionReader> reader = MakeRuleReader();
  std::vector<ModelReply> replies;
  LayoutRequest layout_request;
  layout_request.instruction = layout_instruction;
  layout_request.vocabulary = layout.vocabulary;
  const auto layout_reading = reader->ReadLayout(layout_request, Progress(), &replies);
  EnvironmentRequest environment_request;
  environment_request.instruction = environment_instruction;
  environment_request.layout = &layout;
  environment_request.catalogue = Catalogue::BuiltIn();
  const auto environment_reading =
      reader->ReadEnvironment(environment_request, Progress(), &replies);
  EXPECT_TRUE(layout_reading.ok()) << layout_reading.status().ToString();
  EXPECT_TRUE(environment_reading.ok()) << environment_reading.status().ToString();
  return AssessFidelity(*layout_reading, *environment_reading, layout, environment);
}

TEST(FidelityTest, MeasuresWhatTheWordsSayAndNotWhoAnswered) {
  const std::string layout = "The map is mostly forest. A lake lies in the center.";
  const FidelityReport forest = Assess(layout, "autumn", Uniform('F'), Autumn());
  ASSERT_GE(forest.claims.size(), 3u);
  bool dominance = false, lake = false, season = false;
  for (const ClaimOutcome& claim : forest.claims) {
    EXPECT_EQ(claim.satisfied, claim.distance == 0.0);
    EXPECT_FALSE(claim.words.empty());
    EXPECT_FALSE(claim.explanation.empty());
    if (claim.part == InstructionPart::kEnvironment) {
      season = season || claim.satisfied;
    } else {
      EXPECT_NE(layout.find(claim.words), std::string::npos) << claim.words;
      dominance = dominance || (claim.kind == "dominant" && claim.satisfied);
      lake = lake || (claim.words.find("lake") != std::string::npos && !claim.satisfied);
    }
  }
  EXPECT_TRUE(dominance);
  EXPECT_TRUE(lake);
  EXPECT_TRUE(season);
  EXPECT_LT(forest.satisfied(), static_cast<int>(forest.claims.size()));
}

// "By the village" is where the layout has it.
TEST(FidelityTest, MeasuresPlacesThatTheLayoutNames) {
  SymbolicLayout layout = Uniform('G');
  for (int row = 24; row < 30; ++row) {
    for (int column = 24; column < 30; ++column) layout.cells(row, column) = 'B';
  }
  const auto holds = [&](Region position) {
    EnvironmentConfig environment = Autumn();
    environment.agents = {{AgentCategory::kSheep, 10, AgentState::kGrazing, position}};
    const FidelityReport report =
        Assess("", "Ten sheep graze by the village.", layout, environment);
    const auto sheep =
        std::find_if(report.claims.begin(), report.claims.end(),
                     [](const ClaimOutcome& claim) { return claim.kind == "agents"; });
    return sheep != report.claims.end() && sheep->satisfied;
  };
  EXPECT_TRUE(holds(Region::kLowerRight));
  EXPECT_FALSE(holds(Region::kUpperLeft));
}

TEST(FidelityTest, MeasuresTheLandsFormOnTheFinishedGround) {
  const std::string words = "A hill in the center. The hill is 25 m high.";
  LayoutReading reading;
  reading.sentences = {"A hill in the center", "The hill is 25 m high"};
  ReadRelief(words, &reading);
  ASSERT_EQ(reading.plan.reliefs.size(), 1u);
  const SymbolicLayout layout = Uniform('G');
  TerrainRequest request;
  request.geometry = GridGeometry::FromCells(256, 190.0);
  request.layout = &layout;
  request.seed = 3;
  const auto satisfied = [&](const std::vector<ReliefWish>& laid) {
    request.reliefs = laid;
    FidelityReport report;
    AssessReliefFidelity(reading, layout, BuildTerrain(request, Progress()).value(), &report);
    EXPECT_EQ(report.claims.size(), 2u);
    EXPECT_EQ(report.claims.back().words, "The hill is 25 m high");
    return report.satisfied();
  };
  EXPECT_EQ(satisfied(reading.plan.reliefs), 2);
  EXPECT_EQ(satisfied({}), 0);
}

TEST(FidelityTest, WarnsOfEveryMissAndOfWhatWasNotUnderstood) {
  const FidelityReport report =
      Assess("A lake in the north and a zorblax.", "a herd of quxes", Uniform('G'), Autumn());
  const std::vector<std::string> warnings = WarningsOf(report, {});
  ASSERT_GE(warnings.size(), 2u);
  EXPECT_EQ(warnings.front().rfind("not satisfied: ", 0), 0u) << warnings.front();
  EXPECT_EQ(warnings.back().rfind("not understood: ", 0), 0u) << warnings.back();
  EXPECT_NE(warnings.back().find("zorblax"), std::string::npos) << warnings.back();
  EXPECT_NE(warnings.back().find("quxes"), std::string::npos) << warnings.back();
}

TEST(FidelityTest, WarnsOfNothingTwice) {
  const FidelityReport report =
      Assess("A lake in the north and a zorblax.", "", Uniform('G'), Autumn());
  const std::vector<std::string> once = WarningsOf(report, {});
  EXPECT_FALSE(once.empty());
  EXPECT_TRUE(WarningsOf(report, once).empty());
}

// A place that no claim has, within words that a claim quotes.
TEST(FidelityTest, NoReportIsWholeWhereAKnownWordIsLost) {
  const FidelityReport report =
      Assess("The town is squeezed between the river to the west and the wooded hills to the east.",
             "", Uniform('G'), Autumn());
  EXPECT_EQ(report.not_understood, std::vector<std::string>{"west"});
  EXPECT_LT(report.words_read, report.words);
}

TEST(FidelityTest, SaysNothingOfNoWords) {
  const FidelityReport report = Assess("", "", Uniform('G'), Autumn());
  EXPECT_TRUE(report.claims.empty());
  EXPECT_TRUE(report.not_understood.empty());
  EXPECT_TRUE(WarningsOf(report, {}).empty());
}

TEST(FidelityJsonTest, IsReadBackAsWritten) {
  const FidelityReport report = MakeTestWorld()->fidelity;
  const auto decoded = DecodeFidelity(EncodeFidelity(report));
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  EXPECT_EQ(EncodeFidelity(*decoded), EncodeFidelity(report));
  EXPECT_EQ(decoded->claims.size(), report.claims.size());
  EXPECT_EQ(decoded->claims[1].distance, report.claims[1].distance);
}

// content with the first `from` replaced.
std::string Forged(std::string content, const std::string& from, const std::string& to) {
  const std::size_t at = content.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return content.replace(at, from.size(), to);
}

TEST(FidelityJsonTest, RefusesWhatIsNoReport) {
  const std::string content = EncodeFidelity(MakeTestWorld()->fidelity);
  for (const std::string& forged :
       {Forged(content, "\"satisfied\": 1", "\"satisfied\": 2"),
        Forged(content, "\"layout\"", "\"terrain\""), Forged(content, "\"kind\"", "\"sort\""),
        Forged(content, "\"satisfied\": true", "\"satisfied\": 1"),
        Forged(content, "\"distance\": 0.0", "\"distance\": 7"), std::string("[]"),
        std::string("{"), content.substr(0, content.size() / 2)}) {
    const auto decoded = DecodeFidelity(forged);
    ASSERT_FALSE(decoded.ok()) << forged;
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
  }
}

TEST(RepliesJsonTest, AreReadBackAsWritten) {
  const std::vector<ModelReply> replies = MakeTestWorld()->replies;
  const auto decoded = DecodeReplies(EncodeReplies(replies));
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  ASSERT_EQ(decoded->size(), replies.size());
  EXPECT_EQ((*decoded)[0].text, replies[0].text);
  EXPECT_EQ((*decoded)[1].seconds, replies[1].seconds);
  EXPECT_TRUE((*decoded)[1].failure.ok());
  EXPECT_EQ((*decoded)[2].purpose, "environment");
  EXPECT_EQ((*decoded)[2].failure.ToString(), replies[2].failure.ToString());
  EXPECT_TRUE(DecodeReplies("[]")->empty());
}

TEST(RepliesJsonTest, WarningsOfTheServerAreReadBackAndNotWrittenWhereThereAreNone) {
  std::vector<ModelReply> replies = {{"layout", "m", "FFF", "stop"}};
  EXPECT_EQ(EncodeReplies(replies).find("warnings"), std::string::npos);
  replies[0].warnings = {"the chat server has cut the prompt: 7", "another"};
  const auto decoded = DecodeReplies(EncodeReplies(replies));
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  EXPECT_EQ((*decoded)[0].warnings, replies[0].warnings);
}

// A world is made again by it: how sure the model was decides whose reading counts.
TEST(RepliesJsonTest, HowSureTheModelWasIsReadBackToTheBit) {
  std::vector<ModelReply> replies = {{"layout_words", "m", "A lake.", "stop"}};
  EXPECT_EQ(EncodeReplies(replies).find("log_probability"), std::string::npos);
  replies[0].log_probability = -1.0 / 3.0;
  const auto decoded = DecodeReplies(EncodeReplies(replies));
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  EXPECT_EQ((*decoded)[0].log_probability, -1.0 / 3.0);
}

// As bundles had them before failures were recorded.
TEST(RepliesJsonTest, ARecordingWithoutFailuresIsRead) {
  const auto decoded = DecodeReplies(
      R"([{"purpose": "layout", "model": "m", "text": "FFF", "finish_reason": "stop",
           "prompt_tokens": 7, "completion_tokens": 8, "retries": 0, "seconds": 0.5}])");
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  ASSERT_EQ(decoded->size(), 1u);
  EXPECT_EQ((*decoded)[0].text, "FFF");
  EXPECT_TRUE((*decoded)[0].failure.ok());
}

TEST(RepliesJsonTest, EveryErrorIsAFailureThatIsReadBack) {
  for (int code = 1; code <= 16; ++code) {
    ModelReply failed;
    failed.purpose = "layout";
    failed.failure = Status(static_cast<StatusCode>(code), "why");
    const auto decoded = DecodeReplies(EncodeReplies({failed}));
    ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
    EXPECT_EQ((*decoded)[0].failure.ToString(), failed.failure.ToString());
  }
}

TEST(RepliesJsonTest, RefusesWhatIsNoRecording) {
  const std::string content = EncodeReplies(MakeTestWorld()->replies);
  for (const std::string& forged :
       {Forged(content, "\"text\"", "\"txet\""),
        Forged(content, "\"retries\": 1", "\"retries\": -1"),
        Forged(content, "\"prompt_tokens\": 700", "\"prompt_tokens\": \"700\""), std::string("{}"),
        Forged(content, "\"failure\": \"UNAVAILABLE\"", "\"failure\": \"OK\""),
        Forged(content, "\"failure\": \"UNAVAILABLE\"", "\"failure\": \"NO SUCH ERROR\""),
        Forged(content, "\"failure\": \"UNAVAILABLE\"", "\"failure\": 14"),
        Forged(content, "\"message\"", "\"massage\""), std::string("[1]")}) {
    const auto decoded = DecodeReplies(forged);
    ASSERT_FALSE(decoded.ok()) << forged;
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
  }
}

}  // namespace
}  // namespace latticeworld
