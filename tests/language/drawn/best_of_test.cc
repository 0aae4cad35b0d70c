#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

// 32 rows: water in the north, forest in the south, grass between, each where it is wanted.
SymbolicLayout Land(bool water, bool forest) {
  std::string text;
  for (int row = 0; row < 32; ++row) {
    const char letter = water && row < 8 ? 'W' : forest && row >= 24 ? 'F' : 'G';
    text += std::string(32, letter) + "\n";
  }
  return *ParseLayout(text, Vocabulary::kSuburb);
}

// Gives what it was told to, in this order, and remembers the seeds.
class Listed final : public LayoutGenerator {
 public:
  explicit Listed(std::set<std::uint64_t>* seeds) : seeds_(seeds) {}
  std::string_view name() const override { return "listed"; }
  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress&,
                                std::vector<ModelReply>* replies) override {
    seeds_->insert(request.seed);
    replies->push_back({"layout", "m", said.front(), "stop"});
    said.pop_front();
    Result<LayoutAnswer> answer = std::move(answers.front());
    answers.pop_front();
    return answer;
  }

  std::deque<Result<LayoutAnswer>> answers;
  std::deque<std::string> said;

 private:
  std::set<std::uint64_t>* seeds_;
};

class BestOfTest : public testing::Test {
 protected:
  void Say(bool water, bool forest, const std::string& reply) {
    LayoutAnswer answer;
    answer.layout = Land(water, forest);
    listed_->answers.push_back(std::move(answer));
    listed_->said.push_back(reply);
  }
  void Fail(StatusCode code, const std::string& reply = "") {
    listed_->answers.push_back(Status(code, "failed"));
    listed_->said.push_back(reply);
  }
  // The reply of the layout that was taken, or the name of the error.
  std::string Taken(int tries) {
    auto generator = MakeBestOfLayoutGenerator(std::move(listed_), tries);
    const auto answer = generator->Generate(
        {"A lake in the north and a forest in the south.", Vocabulary::kSuburb, nullptr, 7},
        Progress(), &replies_);
    if (!answer.ok()) return std::string(ToString(answer.status().code()));
    EXPECT_EQ(replies_.size(), 1u);
    return replies_.front().text;
  }

  std::set<std::uint64_t> seeds_;
  std::vector<ModelReply> replies_;
  std::unique_ptr<Listed> listed_ = std::make_unique<Listed>(&seeds_);
};

TEST_F(BestOfTest, TheLayoutWithMostClaimsIsTaken) {
  Say(false, false, "nothing");
  Say(false, true, "forest");
  Say(true, false, "water");
  EXPECT_EQ(Taken(3), "forest");
  EXPECT_EQ(seeds_.size(), 3u);
  EXPECT_EQ(seeds_.count(7), 1u);
}

TEST_F(BestOfTest, OneThatHasThemAllEndsIt) {
  Say(true, false, "water");
  Say(true, true, "both");
  EXPECT_EQ(Taken(64), "both");
}

TEST_F(BestOfTest, OneTryIsTheRequest) {
  Say(false, false, "nothing");
  EXPECT_EQ(Taken(1), "nothing");
  EXPECT_EQ(seeds_, std::set<std::uint64_t>{7});
}

TEST_F(BestOfTest, ATryThatFailsIsPassedOver) {
  Fail(StatusCode::kDataLoss);
  Say(true, false, "water");
  Fail(StatusCode::kDataLoss);
  EXPECT_EQ(Taken(3), "water");
}

TEST_F(BestOfTest, WhereAllFailSoDoesIt) {
  Fail(StatusCode::kUnavailable, "first");
  Fail(StatusCode::kDataLoss, "last");
  EXPECT_EQ(Taken(2), ToString(StatusCode::kDataLoss));
  ASSERT_EQ(replies_.size(), 1u) << "those of the failure that is told";
  EXPECT_EQ(replies_.front().text, "last");
}

TEST_F(BestOfTest, CancellingEndsIt) {
  Say(true, false, "water");
  Fail(StatusCode::kCancelled);
  EXPECT_EQ(Taken(3), ToString(StatusCode::kCancelled));
}

}  // namespace
}  // namespace latticeworld
