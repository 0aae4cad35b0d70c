#include "latticeworld/generation/world_generator.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>
#include <new>
#include <set>
#include <stdexcept>
#include <string>

#include "generation/test_world.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// What the fakes saw, and what they do before they answer.
struct FakeLog {
  std::vector<std::string> calls;
  LayoutRequest layout_request;
  EnvironmentRequest environment_request;
  bool layout_had_relief = false;
  bool environment_had_layout = false;
  std::function<Status()> before_layout = [] { return Status(); };
};

class FakeLayoutGenerator : public LayoutGenerator {
 public:
  explicit FakeLayoutGenerator(FakeLog* log) : log_(log) {}
  std::string_view name() const override { return "fake"; }
  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress&,
                                std::vector<ModelReply>* replies) override {
    log_->calls.push_back("layout");
    log_->layout_request = request;
    log_->layout_had_relief = request.relief != nullptr;
    LW_RETURN_IF_ERROR(log_->before_layout());
    LayoutAnswer answer;
    answer.layout.vocabulary = request.vocabulary;
    answer.layout.cells = Grid<char>(kLayoutSize, kLayoutSize, 'F');
    for (int row = 20; row < 30; ++row) {
      for (int col = 20; col < 30; ++col) answer.layout.cells(row, col) = 'W';
    }
    replies->push_back({"layout", "fake", "FFFF", "stop", 1, 2, 0, 0.5});
    answer.warnings = {"from layout"};
    return answer;
  }

 private:
  FakeLog* log_;
};

class FakeEnvironmentGenerator : public EnvironmentGenerator {
 public:
  explicit FakeEnvironmentGenerator(FakeLog* log) : log_(log) {}
  std::string_view name() const override { return "fake"; }
  Result<EnvironmentAnswer> Generate(const EnvironmentRequest& request, const Progress&,
                                     std::vector<ModelReply>* replies) override {
    log_->calls.push_back("environment");
    log_->environment_request = request;
    log_->environment_had_layout = request.layout != nullptr && request.layout->cells(0, 0) == 'F';
    EnvironmentAnswer answer;
    answer.environment.coarse.season = Season::kAutumn;
    answer.environment.fine = DeriveFineAttributes(answer.environment.coarse);
    answer.environment.agents = {
        {AgentCategory::kSheep, 2, AgentState::kGrazing, Region::kUpperLeft}};
    replies->push_back({"environment", "fake", "{}", "stop", 1, 2, 0, 0.5});
    answer.warnings = {"from environment"};
    return answer;
  }

 private:
  FakeLog* log_;
};

WorldGenerator MakeFakeGenerator(FakeLog* log) {
  LanguageStack stack;
  stack.readers["rules"] = MakeRuleReader();
  stack.default_reader = "rules";
  for (const char* name : {"fake", "other"}) {
    stack.generators[name] = {std::make_unique<FakeLayoutGenerator>(log),
                              std::make_unique<FakeEnvironmentGenerator>(log)};
  }
  stack.default_generator = "fake";
  return WorldGenerator(std::move(stack));
}

GenerationRequest SmallRequest() {
  GenerationRequest request;
  request.layout_instruction = "A forest with a lake in the lower right.";
  request.environment_instruction = "Two sheep graze in autumn.";
  request.seed = 7;
  request.size_m = 64.0;
  request.resolution_m = 1.0;
  return request;
}

GenerationRequest HeightMapRequest() {
  GenerationRequest request = SmallRequest();
  request.visual_kind = VisualKind::kHeightMap;
  request.visual = MakePgm(40, 50);
  request.height_map.height_scale_m = 20.0;
  return request;
}

std::set<std::string> PointersOf(const Status& status) {
  std::set<std::string> pointers;
  for (const Violation& violation : status.violations()) pointers.insert(violation.pointer);
  return pointers;
}

TEST(WorldGeneratorTest, OneTextMayDescribeLandAndEnvironment) {
  GenerationRequest request = SmallRequest();
  request.layout_instruction = "A forest with a lake. It is a foggy night, and three sheep graze.";
  request.environment_instruction = "";
  const auto kinds = [&request] {
    FakeLog log;
    const auto world = MakeFakeGenerator(&log).Generate(request, Progress());
    EXPECT_TRUE(world.ok());
    std::set<std::string> kinds;
    for (const ClaimOutcome& claim : (*world)->fidelity.claims)
      if (claim.part == InstructionPart::kEnvironment) kinds.insert(claim.kind);
    return kinds;
  };
  EXPECT_EQ(kinds(), (std::set<std::string>{"agents", "coarse"}));
  request.environment_instruction = " In winter.";
  EXPECT_EQ(kinds(), std::set<std::string>{"coarse"}) << "what is said of it alone counts then";
  request.layout_instruction = "A forest with a lake in the lower right.";
  request.environment_instruction = "";
  EXPECT_TRUE(kinds().empty());
}

TEST(WorldGeneratorTest, RunsItsStagesInOrderAndReportsAndTimesEach) {
  FakeLog log;
  std::vector<std::string> begun, ended;
  const Progress progress([&](std::string_view stage, double fraction) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    if (begun.empty() || begun.back() != stage) {
      EXPECT_EQ(fraction, 0.0) << stage;
      begun.emplace_back(stage);
    }
    if (fraction == 1.0 && (ended.empty() || ended.back() != stage)) ended.emplace_back(stage);
  });
  const auto world = MakeFakeGenerator(&log).Generate(SmallRequest(), progress);
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  const std::vector<std::string> stages = {"relief", "layout", "environment", "terrain", "scene"};
  EXPECT_EQ(begun, stages);
  EXPECT_EQ(ended, stages);
  ASSERT_EQ((*world)->stages.size(), stages.size());
  for (std::size_t i = 0; i < stages.size(); ++i) {
    EXPECT_EQ((*world)->stages[i].name, stages[i]);
    EXPECT_GE((*world)->stages[i].seconds, 0.0);
  }
}

TEST(WorldGeneratorTest, GivesEveryStageItsOwnSeed) {
  FakeLog log;
  ASSERT_TRUE(MakeFakeGenerator(&log).Generate(SmallRequest(), Progress()).ok());
  EXPECT_EQ(log.layout_request.seed, StreamSeed(7, "layout"));
  EXPECT_EQ(log.environment_request.seed, StreamSeed(7, "environment"));
}

TEST(WorldGeneratorTest, HandsOnTextsAndCollectsAnswers) {
  FakeLog log;
  const auto world = MakeFakeGenerator(&log).Generate(SmallRequest(), Progress());
  ASSERT_TRUE(world.ok());
  EXPECT_EQ(log.layout_request.instruction, SmallRequest().layout_instruction);
  EXPECT_EQ(log.environment_request.instruction, SmallRequest().environment_instruction);
  EXPECT_TRUE(log.environment_had_layout);
  EXPECT_FALSE(log.layout_had_relief);
  EXPECT_EQ((*world)->layout.cells(25, 25), 'W');
  ASSERT_EQ((*world)->replies.size(), 2u);  // layout first
  EXPECT_EQ((*world)->replies[0].purpose, "layout");
  EXPECT_EQ((*world)->replies[1].purpose, "environment");
  EXPECT_EQ((*world)->environment.coarse.season, Season::kAutumn);
  ASSERT_GE((*world)->warnings.size(), 2u);
  EXPECT_EQ((*world)->warnings[0], "from layout");
  EXPECT_EQ((*world)->warnings[1], "from environment");
  EXPECT_EQ((*world)->scene->geometry().rows(), 64);
}

TEST(WorldGeneratorTest, FillsInWhatTheRequestLeftOpen) {
  FakeLog log;
  WorldGenerator generator = MakeFakeGenerator(&log);
  GenerationRequest request = SmallRequest();
  request.layout_instruction = "Rocky land with snow-capped mountains.";
  request.height_map.height_scale_m = std::numeric_limits<double>::quiet_NaN();  // no picture
  const auto world = generator.Generate(request, Progress());
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  EXPECT_EQ((*world)->request.vocabulary, "wild");
  EXPECT_EQ((*world)->request.generator, "fake");
  EXPECT_EQ((*world)->request.height_map.height_scale_m, HeightMapOptions().height_scale_m);
  EXPECT_EQ(log.layout_request.vocabulary, Vocabulary::kWild);

  request.vocabulary = "suburb";
  request.generator = "other";
  const auto chosen = generator.Generate(request, Progress());
  ASSERT_TRUE(chosen.ok());
  EXPECT_EQ((*chosen)->request.vocabulary, "suburb");
  EXPECT_EQ((*chosen)->request.generator, "other");
}

TEST(WorldGeneratorTest, TakesAHeightMapWithoutWordsForAWildPlace) {
  FakeLog log;
  GenerationRequest request = HeightMapRequest();
  request.layout_instruction.clear();
  const auto world = MakeFakeGenerator(&log).Generate(request, Progress());
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  EXPECT_TRUE(log.layout_had_relief);
  EXPECT_EQ((*world)->request.vocabulary, "wild");
}

TEST(WorldGeneratorTest, LetsTheHeightMapShapeTheGround) {
  FakeLog log;
  const auto world = MakeFakeGenerator(&log).Generate(HeightMapRequest(), Progress());
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  const HeightField& ground = (*world)->scene->terrain->ground;
  EXPECT_GT(ground.HeightAt({28.0, 25.0}), ground.HeightAt({-28.0, 25.0}) + 8.0);
}

TEST(WorldGeneratorTest, ReportsEveryViolationAtOnce) {
  FakeLog log;
  GenerationRequest request = HeightMapRequest();
  request.layout_instruction = "\xff";
  request.environment_instruction = std::string(kMaxInstructionBytes + 1, 'a');
  request.visual.clear();
  request.height_map.height_scale_m = -1.0;
  request.vocabulary = "sea";
  request.generator = "oracle";
  request.seed = 0;
  request.size_m = std::numeric_limits<double>::quiet_NaN();
  request.resolution_m = 0.0;
  const auto world = MakeFakeGenerator(&log).Generate(request, Progress());
  ASSERT_FALSE(world.ok());
  EXPECT_EQ(world.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(world.status().violations().size(), 9u) << world.status().ToString();
  const std::set<std::string> pointers = PointersOf(world.status());
  for (const char* pointer : {"visual", "vocabulary", "generator", "seed", "size", "resolution"}) {
    EXPECT_EQ(pointers.count(pointer), 1u) << pointer;
  }
  EXPECT_TRUE(log.calls.empty());
}

TEST(WorldGeneratorTest, SaysWhatWasGivenAndWhatIsLegal) {
  FakeLog log;
  const WorldGenerator generator = MakeFakeGenerator(&log);
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    std::function<void(GenerationRequest*)> change;
    std::vector<std::string> words;
  };
  const std::vector<Case> cases = {
      {[](auto* r) { r->layout_instruction.clear(); }, {"empty"}},
      {[](auto* r) { r->layout_instruction = "a\xc3("; }, {"UTF-8"}},
      {[](auto* r) { r->layout_instruction.assign(1 << 20, 'a'); }, {"1048576", "16384"}},
      {[](auto* r) { r->environment_instruction = "\xed\xa0\x80"; }, {"UTF-8"}},
      {[](auto* r) { r->environment_instruction.assign(1 << 20, 'a'); }, {"1048576", "16384"}},
      {[](auto* r) { r->vocabulary = "sea"; }, {"\"sea\"", "suburb, wild"}},
      {[](auto* r) { r->generator = "oracle"; }, {"\"oracle\"", "fake, other"}},
      {[](auto* r) { r->seed = 0; }, {"seed", "0"}},
      {[](auto* r) { r->size_m = 0.0; }, {"size", "0", "16", "8192"}},
      {[](auto* r) { r->size_m = -5.0; }, {"size", "-5"}},
      {[&](auto* r) { r->size_m = kNan; }, {"size", "nan"}},
      {[](auto* r) { r->size_m = 1e12; }, {"size", "8192"}},
      {[](auto* r) { r->resolution_m = 0.0; }, {"resolution", "0.05"}},
      {[](auto* r) { r->resolution_m = -1.0; }, {"resolution", "-1"}},
      {[&](auto* r) { r->resolution_m = kNan; }, {"resolution", "nan"}},
      {[](auto* r) { r->size_m = 8192, r->resolution_m = 0.05; }, {"163840", "8192"}},
      {[](auto* r) { r->visual_kind = VisualKind::kHeightMap; }, {"height_map", "PNG"}},
      {[](auto* r) { r->visual = "x"; }, {"visual_kind"}},
      {[](auto* r) { r->visual_kind = static_cast<VisualKind>(9); },
       {"9", "none, height_map, sketch, elevation"}},
      {[](auto* r) {
         r->visual_kind = VisualKind::kHeightMap, r->visual = "x",
         r->height_map.height_scale_m = 1e6;
       },
       {"9000"}},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    GenerationRequest request = SmallRequest();
    cases[i].change(&request);
    const Status status = generator.Validate(request);
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument) << "case " << i;
    EXPECT_EQ(status.violations().size(), 1u) << "case " << i << ": " << status.ToString();
    for (const std::string& word : cases[i].words) {
      EXPECT_NE(status.message().find(word), std::string::npos)
          << "case " << i << ": " << word << " | " << status.message();
    }
  }
  EXPECT_TRUE(generator.Validate(SmallRequest()).ok());
  EXPECT_TRUE(generator.Validate(HeightMapRequest()).ok());
}

TEST(WorldGeneratorTest, RefusesAPictureThatIsNone) {
  FakeLog log;
  GenerationRequest request = HeightMapRequest();
  request.visual = "no picture";
  const auto world = MakeFakeGenerator(&log).Generate(request, Progress());
  ASSERT_FALSE(world.ok());
  EXPECT_EQ(world.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(world.status().message().rfind("relief: ", 0), 0u) << world.status().message();
  EXPECT_TRUE(log.calls.empty());
}

TEST(WorldGeneratorTest, DoesNothingOnceCancelled) {
  FakeLog log;
  Progress progress([](std::string_view, double) { ADD_FAILURE() << "a stage began"; });
  progress.Cancel();
  const auto world = MakeFakeGenerator(&log).Generate(SmallRequest(), progress);
  ASSERT_FALSE(world.ok());
  EXPECT_EQ(world.status().code(), StatusCode::kCancelled);
}

TEST(WorldGeneratorTest, CanBeCancelledAtTheBeginningAndEndOfEveryStage) {
  for (const char* stage : {"relief", "layout", "environment", "terrain", "scene"}) {
    for (const double at : {0.0, 1.0}) {
      FakeLog log;
      Progress* cancelled = nullptr;
      std::string last;
      Progress progress([&](std::string_view name, double fraction) {
        last = name;
        if (name == stage && fraction == at) cancelled->Cancel();
      });
      cancelled = &progress;
      const auto world = MakeFakeGenerator(&log).Generate(SmallRequest(), progress);
      ASSERT_FALSE(world.ok()) << stage << " " << at;
      EXPECT_EQ(world.status().code(), StatusCode::kCancelled) << world.status().ToString();
      EXPECT_EQ(last, stage);
    }
  }
}

TEST(WorldGeneratorTest, NamesTheStageThatFailed) {
  FakeLog log;
  log.before_layout = [] { return Unavailable("the model sleeps"); };
  const auto world = MakeFakeGenerator(&log).Generate(SmallRequest(), Progress());
  ASSERT_FALSE(world.ok());
  EXPECT_EQ(world.status().code(), StatusCode::kUnavailable);
  EXPECT_EQ(world.status().message(), "layout: the model sleeps");
  EXPECT_EQ(log.calls, std::vector<std::string>{"layout"});
}

TEST(WorldGeneratorTest, MakesAStatusOfMissingMemoryAndOfDefects) {
  FakeLog log;
  WorldGenerator generator = MakeFakeGenerator(&log);
  log.before_layout = []() -> Status { throw std::bad_alloc(); };
  EXPECT_EQ(generator.Generate(SmallRequest(), Progress()).status().code(),
            StatusCode::kResourceExhausted);
  log.before_layout = []() -> Status { throw std::runtime_error("a defect"); };
  const Status status = generator.Generate(SmallRequest(), Progress()).status();
  EXPECT_EQ(status.code(), StatusCode::kInternal);
  EXPECT_NE(status.message().find("a defect"), std::string::npos);
  log.before_layout = [] { return Status(); };
  EXPECT_TRUE(generator.Generate(SmallRequest(), Progress()).ok());
}

TEST(WorldGeneratorTest, NamesItsReadersAndGenerators) {
  FakeLog log;
  EXPECT_EQ(MakeFakeGenerator(&log).generator_names(), (std::vector<std::string>{"fake", "other"}));
  EXPECT_EQ(MakeDefaultWorldGenerator().reader_names(),
            (std::vector<std::string>{"controlled", "rules"}));
  EXPECT_EQ(MakeDefaultWorldGenerator().generator_names(), std::vector<std::string>{"grounded"});
}

// Who reads and who answers are two choices, each of which can be wrong.
TEST(WorldGeneratorTest, RefusesUnknownReadersAndGenerators) {
  GenerationRequest request = SmallRequest();
  request.reader = "crystal ball";
  request.generator = "oracle";
  const Status status = MakeDefaultWorldGenerator().Validate(request);
  EXPECT_EQ(status.violations().size(), 2u) << status.ToString();
  for (const char* said : {"controlled, rules", "crystal ball", "grounded", "oracle"}) {
    EXPECT_NE(status.ToString().find(said), std::string::npos) << status.ToString();
  }
}

TEST(WorldGeneratorTest, TheReaderThatIsNamedReads) {
  GenerationRequest request = SmallRequest();
  request.reader = "controlled";
  const auto world = MakeDefaultWorldGenerator().Generate(request, Progress());
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  EXPECT_EQ((*world)->request.reader, "controlled");
  EXPECT_EQ((*world)->request.generator, "grounded");
  EXPECT_EQ((*world)->fidelity.not_understood,
            (std::vector<std::string>{"A forest with a lake in the lower right",
                                      "Two sheep graze in autumn"}));
}

TEST(WorldGeneratorTest, WarnsOfSentencesOfTheOtherKindWhereTheReaderReadsByKind) {
  GenerationRequest request = SmallRequest();
  request.layout_instruction = "A lake in the south. Foggy autumn morning.";
  request.environment_instruction = "Rain.";
  for (const auto& [reader, warns] :
       std::map<std::string, bool>{{"rules", true}, {"controlled", false}}) {
    request.reader = reader;
    const auto world = MakeDefaultWorldGenerator().Generate(request, Progress());
    ASSERT_TRUE(world.ok()) << world.status().ToString();
    EXPECT_EQ(
        Join((*world)->warnings, "\n").find("not read, for it speaks of") != std::string::npos,
        warns)
        << reader << ": " << Join((*world)->warnings, "\n");
  }
}

TEST(WorldGeneratorTest, MakesTheSameWorldFromTheSameRequest) {
  for (const GenerationRequest& request : {SmallRequest(), HeightMapRequest()}) {
    const auto first = MakeDefaultWorldGenerator().Generate(request, Progress());
    WorldGenerator used = MakeDefaultWorldGenerator();
    GenerationRequest other = request;
    other.seed = 8;
    const auto unlike = used.Generate(other, Progress());
    const auto second = used.Generate(request, Progress());  // whatever it made before
    ASSERT_TRUE(first.ok() && second.ok() && unlike.ok()) << first.status().ToString();
    ExpectSameWorld(**first, **second);
    EXPECT_NE((*first)->id, (*unlike)->id);
  }
}

TEST(WorldGeneratorTest, MakesOfAnAcceptedRequestTheWorldOfTheRequest) {
  WorldGenerator generator = MakeDefaultWorldGenerator();
  for (const GenerationRequest& request : {SmallRequest(), HeightMapRequest()}) {
    auto accepted = generator.Accept(request);
    ASSERT_TRUE(accepted.ok()) << accepted.status().ToString();
    EXPECT_EQ((*accepted)->visual, request.visual);
    const auto world = generator.Generate(*std::move(accepted), Progress());
    const auto same = generator.Generate(request, Progress());
    ASSERT_TRUE(world.ok() && same.ok()) << world.status().ToString();
    ExpectSameWorld(**world, **same);
  }
  GenerationRequest illegal = SmallRequest();
  illegal.size_m = -1.0;
  EXPECT_EQ(generator.Accept(illegal).status().ToString(), generator.Validate(illegal).ToString());
}

TEST(WorldGeneratorTest, LeavesTheLayoutAloneWhenOnlyTheEnvironmentIsAskedForAnew) {
  GenerationRequest request = SmallRequest();
  const auto first = MakeDefaultWorldGenerator().Generate(request, Progress());
  request.environment_instruction = "A snowy winter night.";
  const auto second = MakeDefaultWorldGenerator().Generate(request, Progress());
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ((*first)->layout.cells, (*second)->layout.cells);
  EXPECT_EQ((*first)->scene->terrain->ground.height_m(),
            (*second)->scene->terrain->ground.height_m());
  EXPECT_NE((*first)->id, (*second)->id);
}

}  // namespace
}  // namespace latticeworld
