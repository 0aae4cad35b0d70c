#include "latticeworld/generation/fidelity/fidelity_benchmark.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <set>

#include "generation/test_world.h"
#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

void Write(const fs::path& file, const std::string& content) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << content;
}

constexpr char kLayouts[] = R"([
  {"id": "a", "vocabulary": "suburb", "voice": "plain", "instruction": "Only forest.", "claims": [
    {"kind": "dominant", "subject": "F", "words": "Only forest"},
    {"kind": "present", "subject": "W", "zone": "upper left", "words": "forest"}]},
  {"id": "b", "vocabulary": "wild", "voice": "plain", "instruction": "Only snow.", "claims": [
    {"kind": "dominant", "subject": "S"}]}])";
constexpr char kEnvironments[] = R"([
  {"id": "c", "layout": "meadow", "vocabulary": "suburb", "voice": "plain",
   "instruction": "winter", "claims": [
    {"kind": "coarse", "attribute": "season", "values": ["winter"]},
    {"kind": "agents", "category": "sheep", "least_quantity": 1}]}])";

class FidelityBenchmarkTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string meadow;
    for (int row = 0; row < kLayoutSize; ++row) meadow += std::string(kLayoutSize, 'G') + "\n";
    Write(directory_.path() / "layouts" / "meadow.txt", meadow);
    Write(directory_.path() / "layout_test.json", kLayouts);
    Write(directory_.path() / "environment_test.json", kEnvironments);
  }

  // After `file` was rewritten, reading is refused in words that hold all of `needed`.
  void ExpectRefused(const std::string& file, const std::string& content,
                     const std::vector<std::string>& needed) {
    Write(directory_.path() / file, content);
    const auto read = ReadFidelityBenchmark(directory_.path(), BenchmarkPart::kTest);
    ASSERT_FALSE(read.ok()) << content;
    EXPECT_EQ(read.status().code(), StatusCode::kInvalidArgument);
    for (const std::string& words : needed) {
      EXPECT_NE(read.status().message().find(words), std::string::npos)
          << words << " | " << read.status().message();
    }
    SetUp();
  }

  TemporaryDirectory directory_;
};

// Answers every layout with forest, but refuses the wild.
class ForestGenerator : public LayoutGenerator {
 public:
  std::string_view name() const override { return "forest"; }
  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress&,
                                std::vector<ModelReply>*) override {
    if (request.vocabulary == Vocabulary::kWild) return Unavailable("nobody there");
    LayoutAnswer answer;
    answer.layout = {request.vocabulary, Grid<char>(kLayoutSize, kLayoutSize, 'F')};
    answer.warnings = {"all is forest"};
    return answer;
  }
};

class WinterGenerator : public EnvironmentGenerator {
 public:
  std::string_view name() const override { return "winter"; }
  Result<EnvironmentAnswer> Generate(const EnvironmentRequest& request, const Progress&,
                                     std::vector<ModelReply>*) override {
    EXPECT_EQ(request.layout->cells(0, 0), 'G');
    EnvironmentAnswer answer;
    answer.environment.coarse.season = Season::kWinter;
    answer.environment.fine = DeriveFineAttributes(answer.environment.coarse);
    return answer;
  }
};

TEST_F(FidelityBenchmarkTest, CountsPerKindWhatTheItemsClaim) {
  const auto benchmark = ReadFidelityBenchmark(directory_.path(), BenchmarkPart::kTest);
  ASSERT_TRUE(benchmark.ok()) << benchmark.status().ToString();
  const auto rules = MakeRuleReader();
  ForestGenerator forest;
  const auto score = ScoreLayouts(benchmark->layouts, 1, rules.get(), &forest, Progress());
  ASSERT_TRUE(score.ok());
  EXPECT_EQ(score->items, 2);
  EXPECT_EQ(score->answered, 1);
  EXPECT_EQ(score->by_kind.at("dominant").satisfied, 1);
  EXPECT_EQ(score->by_kind.at("dominant").total, 2);  // no answer satisfies nothing
  EXPECT_EQ(score->by_kind.at("present").satisfied, 0);
  EXPECT_EQ(score->all().satisfied, 1);
  EXPECT_EQ(score->all().total, 3);
  ASSERT_EQ(score->misses.size(), 2u);
  EXPECT_EQ(score->misses[0].id, "a");
  EXPECT_NE(score->misses[1].explanation.find("nobody there"), std::string::npos);
  ASSERT_EQ(score->warnings.size(), 1u);
  EXPECT_EQ(score->warnings[0].id, "a");
  EXPECT_EQ(score->warnings[0].text, "all is forest");

  WinterGenerator winter;
  const auto environments =
      ScoreEnvironments(benchmark->environments, 1, rules.get(), &winter, Progress());
  ASSERT_TRUE(environments.ok());
  EXPECT_EQ(environments->by_kind.at("coarse").satisfied, 1);
  EXPECT_EQ(environments->by_kind.at("agents").satisfied, 0);
}

TEST_F(FidelityBenchmarkTest, EachPartIsReadFromItsOwnFiles) {
  EXPECT_EQ(ReadFidelityBenchmark(directory_.path(), BenchmarkPart::kFirstSight).status().code(),
            StatusCode::kNotFound);
  Write(directory_.path() / "layout_first_sight.json", "[]");
  Write(directory_.path() / "environment_first_sight.json", kEnvironments);
  const auto part = ReadFidelityBenchmark(directory_.path(), BenchmarkPart::kFirstSight);
  ASSERT_TRUE(part.ok()) << part.status().ToString();
  EXPECT_TRUE(part->layouts.empty());
  EXPECT_EQ(part->environments.size(), 1u);
}

TEST_F(FidelityBenchmarkTest, EndsWhenItIsCancelled) {
  const auto benchmark = ReadFidelityBenchmark(directory_.path(), BenchmarkPart::kTest);
  const auto rules = MakeRuleReader();
  ForestGenerator forest;
  Progress progress;
  progress.Cancel();
  const auto score = ScoreLayouts(benchmark->layouts, 1, rules.get(), &forest, progress);
  EXPECT_EQ(score.status().code(), StatusCode::kCancelled);
}

TEST_F(FidelityBenchmarkTest, NamesTheFileAndTheItemThatAreWrong) {
  const std::string layouts = kLayouts;
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string forged = layouts;
    return forged.replace(forged.find(from), from.size(), to);
  };
  ExpectRefused("layout_test.json", "{", {"layout_test.json"});
  ExpectRefused("layout_test.json", "{}", {"layout_test.json", "array"});
  ExpectRefused("layout_test.json", with("\"b\"", "\"a\""), {"twice", "a"});
  ExpectRefused("layout_test.json", with("\"subject\": \"F\"", "\"subject\": \"S\""), {"a: "});
  ExpectRefused("layout_test.json", with("upper left", "over there"), {"a: ", "over there"});
  ExpectRefused("layout_test.json", with("\"voice\"", "\"tone\""), {"voice"});
  ExpectRefused("environment_test.json",
                R"([{"id": "c", "layout": "../x", "vocabulary": "suburb", "voice": "",
                     "instruction": "", "claims": []}])",
                {"../x"});
  ExpectRefused("layouts/meadow.txt", "GGG\n", {"meadow"});
}

TEST_F(FidelityBenchmarkTest, TheBenchmarkThatIsShippedIsReadAndLargeEnough) {
  std::size_t layouts = 0, environments = 0, test_layouts = 0, test_environments = 0;
  std::set<std::string> ids;
  for (const auto& entry : EnumNames(BenchmarkPart{})) {
    const auto part = ReadFidelityBenchmark(LATTICEWORLD_FIDELITY_BENCHMARK, entry.value);
    ASSERT_TRUE(part.ok()) << part.status().ToString();
    layouts += part->layouts.size();
    environments += part->environments.size();
    if (entry.value == BenchmarkPart::kTest) {
      test_layouts = part->layouts.size();
      test_environments = part->environments.size();
    }
    for (const LayoutItem& item : part->layouts) {
      EXPECT_TRUE(ids.insert(item.id).second) << item.id;
      EXPECT_FALSE(item.claims.empty()) << item.id;
    }
    for (const EnvironmentItem& item : part->environments) {
      EXPECT_TRUE(ids.insert(item.id).second) << item.id;
      EXPECT_FALSE(item.claims.empty()) << item.id;
    }
  }
  constexpr std::size_t kLeastLayouts = 120, kLeastEnvironments = 60;
  EXPECT_GE(layouts, kLeastLayouts);
  EXPECT_GE(environments, kLeastEnvironments);
  // A quarter of these at least is set aside; what is written later may all be for work.
  EXPECT_GE(test_layouts, kLeastLayouts / 4);
  EXPECT_GE(test_environments, kLeastEnvironments / 4);
}

// The embedded back end, its answers read back as if somebody else had sent them.
class CheckedLayouts : public LayoutGenerator {
 public:
  std::string_view name() const override { return "checked"; }
  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress& progress,
                                std::vector<ModelReply>* replies) override {
    auto answer = embedded_->Generate(request, progress, replies);
    EXPECT_TRUE(answer.ok()) << answer.status().ToString();
    if (answer.ok()) {
      const auto back = ParseLayout(ToText(answer->layout), request.vocabulary);
      EXPECT_TRUE(back.ok()) << back.status().ToString();
    }
    return answer;
  }

 private:
  std::unique_ptr<LayoutGenerator> embedded_ = MakeGroundedLayoutGenerator();
};

class CheckedEnvironments : public EnvironmentGenerator {
 public:
  std::string_view name() const override { return "checked"; }
  Result<EnvironmentAnswer> Generate(const EnvironmentRequest& request, const Progress& progress,
                                     std::vector<ModelReply>* replies) override {
    auto answer = embedded_->Generate(request, progress, replies);
    EXPECT_TRUE(answer.ok()) << answer.status().ToString();
    if (answer.ok()) {
      const auto back = ParseEnvironment(ToJson(answer->environment));
      EXPECT_TRUE(back.ok()) << back.status().ToString();
    }
    return answer;
  }

 private:
  std::unique_ptr<EnvironmentGenerator> embedded_ = MakeGroundedEnvironmentGenerator();
};

// Of the development and the test part; what single instructions of the latter come to is nobody's
// business here. The part for first sight is read by nobody but whoever scores it.
TEST(ShippedFidelityBenchmarkTest, EveryEmbeddedAnswerIsLegalAndNineClaimsInTenHold) {
  for (const auto& entry : EnumNames(BenchmarkPart{})) {
    if (entry.value == BenchmarkPart::kFirstSight) continue;
    const auto part = ReadFidelityBenchmark(LATTICEWORLD_FIDELITY_BENCHMARK, entry.value);
    ASSERT_TRUE(part.ok()) << part.status().ToString();
    const auto rules = MakeRuleReader();
    CheckedLayouts layouts;
    CheckedEnvironments environments;
    const auto layout_score = ScoreLayouts(part->layouts, 1, rules.get(), &layouts, Progress());
    const auto environment_score =
        ScoreEnvironments(part->environments, 1, rules.get(), &environments, Progress());
    ASSERT_TRUE(layout_score.ok() && environment_score.ok());
    EXPECT_EQ(layout_score->answered, layout_score->items);
    EXPECT_EQ(environment_score->answered, environment_score->items);
    if (entry.value == BenchmarkPart::kTest) continue;
    EXPECT_GE(10 * layout_score->all().satisfied, 9 * layout_score->all().total);
    EXPECT_GE(10 * environment_score->all().satisfied, 9 * environment_score->all().total);
  }
}

}  // namespace
}  // namespace latticeworld
