#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {
namespace {

// Says something and fails.
class Failing final : public InstructionReader {
 public:
  explicit Failing(StatusCode code) : code_(code) {}
  std::string_view name() const override { return "failing"; }
  Result<LayoutReading> ReadLayout(const LayoutRequest&, const Progress&,
                                   std::vector<ModelReply>* replies) override {
    replies->push_back({std::string(kLayoutWords), "m", "hm", "stop"});
    return Status(code_, "no more");
  }
  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest&, const Progress&,
                                             std::vector<ModelReply>*) override {
    return Status(code_, "no more");
  }

 private:
  const StatusCode code_;
};

LayoutRequest Lake() { return {"A lake.", Vocabulary::kSuburb, nullptr, 1}; }

TEST(FallbackReaderTest, TheSecondReadsWhatTheFirstFailedOfAndSaysSo) {
  const auto reader = MakeFallbackReader(std::make_shared<Failing>(StatusCode::kUnavailable),
                                         MakeControlledReader());
  std::vector<ModelReply> replies;
  const auto reading = reader->ReadLayout(Lake(), Progress(), &replies);
  ASSERT_TRUE(reading.ok()) << reading.status().ToString();
  EXPECT_EQ(reading->sentences, std::vector<std::string>{"A lake"});
  ASSERT_FALSE(reading->plan.warnings.empty());
  EXPECT_NE(reading->plan.warnings[0].find("UNAVAILABLE: no more"), std::string::npos);
  ASSERT_EQ(replies.size(), 2u);
  EXPECT_EQ(replies[1].purpose, kLayoutWords);
  EXPECT_EQ(replies[1].failure.code(), StatusCode::kUnavailable);
}

TEST(FallbackReaderTest, ReadsByKindWhereTheFirstDoes) {
  EXPECT_TRUE(MakeFallbackReader(MakeRuleReader(), MakeControlledReader())->reads_by_kind());
  EXPECT_FALSE(MakeFallbackReader(MakeControlledReader(), MakeRuleReader())->reads_by_kind());
}

TEST(FallbackReaderTest, CancellingIsNoFailure) {
  const auto reader =
      MakeFallbackReader(std::make_shared<Failing>(StatusCode::kCancelled), MakeControlledReader());
  std::vector<ModelReply> replies;
  EXPECT_EQ(reader->ReadLayout(Lake(), Progress(), &replies).status().code(),
            StatusCode::kCancelled);
}

TEST(FallbackReaderTest, ARequestThatIsWrongItselfGetsNoSecondReading) {
  const auto reader = MakeFallbackReader(std::make_shared<Failing>(StatusCode::kUnavailable),
                                         MakeControlledReader());
  std::vector<ModelReply> replies;
  LayoutRequest request = Lake();
  request.instruction = "\xFF";
  EXPECT_EQ(reader->ReadLayout(request, Progress(), &replies).status().code(),
            StatusCode::kInvalidArgument);
  EXPECT_TRUE(replies.empty());
}

TEST(LongTextReaderTest, TheSecondReadsWhatIsTooLongForTheFirstAndNothingElse) {
  std::vector<ModelReply> replies;
  const auto reader_of = [](StatusCode code) {
    return MakeLongTextReader(std::make_shared<Failing>(code), MakeControlledReader());
  };
  const auto reading =
      reader_of(StatusCode::kResourceExhausted)->ReadLayout(Lake(), Progress(), &replies);
  ASSERT_TRUE(reading.ok()) << reading.status().ToString();
  EXPECT_EQ(reading->sentences, std::vector<std::string>{"A lake"});
  ASSERT_FALSE(reading->plan.warnings.empty());
  EXPECT_NE(reading->plan.warnings[0].find("RESOURCE_EXHAUSTED: no more"), std::string::npos);
  EXPECT_EQ(replies.back().failure.code(), StatusCode::kResourceExhausted);
  for (const StatusCode code :
       {StatusCode::kCancelled, StatusCode::kDataLoss, StatusCode::kUnavailable}) {
    EXPECT_EQ(reader_of(code)->ReadLayout(Lake(), Progress(), &replies).status().code(), code);
  }
}

TEST(FailedReaderTest, FailsAsItDidThen) {
  std::vector<ModelReply> recorded(2);
  recorded[0].text = "hm";
  recorded[1].failure = Unavailable("no more");
  const auto reader = MakeFailedReader(MakeControlledReader(), recorded, {});
  std::vector<ModelReply> replies;
  EXPECT_EQ(reader->ReadLayout(Lake(), Progress(), &replies).status().code(),
            StatusCode::kUnavailable);
  ASSERT_EQ(replies.size(), 1u);
  EXPECT_EQ(replies[0].text, "hm");
}

}  // namespace
}  // namespace latticeworld
