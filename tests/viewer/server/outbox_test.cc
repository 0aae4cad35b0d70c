#include "latticeworld/viewer/server/outbox.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

SharedBytes Text(const std::string& text) { return std::make_shared<const std::string>(text); }

std::string NextText(Outbox* outbox) {
  const auto next = outbox->Next();
  return next ? *next->bytes : "nothing";
}

TEST(OutboxTest, OfASlotOnlyTheNewestIsSent) {
  Outbox outbox;
  outbox.SetText("clock", Text("1"));
  outbox.SetText("weather", Text("rain"));
  outbox.SetText("clock", Text("2"));
  EXPECT_EQ(NextText(&outbox), "2");
  EXPECT_EQ(NextText(&outbox), "rain");
  EXPECT_EQ(NextText(&outbox), "nothing");
  outbox.SetText("clock", Text("3"));
  EXPECT_EQ(NextText(&outbox), "3");
}

TEST(OutboxTest, OfTooManyEventsTheOldestAreLost) {
  Outbox outbox;
  for (int i = 0; i < 1000; ++i) outbox.AddText(Text(std::to_string(i)));
  for (std::size_t i = 0; i < Outbox::kMostOnce; ++i) {
    EXPECT_EQ(NextText(&outbox), std::to_string(1000 - Outbox::kMostOnce + i));
  }
  EXPECT_EQ(NextText(&outbox), "nothing");
}

StreamFrame Frame(std::uint64_t key_number, const std::string& delta) {
  StreamFrame frame;
  frame.key_number = key_number;
  frame.key = Text("key " + std::to_string(key_number));
  if (!delta.empty()) frame.delta = Text(delta);
  return frame;
}

TEST(OutboxTest, ADeltaComesAfterItsKeyFrameAndNoneOfThemTwice) {
  Outbox outbox;
  outbox.SetFrame(StreamKind::kAgents, Frame(1, ""));
  EXPECT_EQ(NextText(&outbox), "key 1");
  outbox.SetFrame(StreamKind::kAgents, Frame(1, "a"));
  outbox.SetFrame(StreamKind::kAgents, Frame(1, "b"));
  EXPECT_EQ(NextText(&outbox), "b");
  // The key frame 2 itself was replaced before it was sent.
  outbox.SetFrame(StreamKind::kAgents, Frame(2, ""));
  outbox.SetFrame(StreamKind::kAgents, Frame(2, "c"));
  EXPECT_EQ(NextText(&outbox), "key 2");
  EXPECT_EQ(NextText(&outbox), "c");
  EXPECT_EQ(NextText(&outbox), "nothing");
}

TEST(OutboxTest, TablesComeBeforeFramesAndKindsDoNotMix) {
  Outbox outbox;
  outbox.SetPoints(Text("points"));
  outbox.SetFrame(StreamKind::kProps, Frame(7, ""));
  outbox.SetFrame(StreamKind::kAgents, Frame(3, ""));
  outbox.SetText("agents", Text("table"));
  EXPECT_EQ(NextText(&outbox), "table");
  EXPECT_EQ(NextText(&outbox), "key 3");
  EXPECT_EQ(NextText(&outbox), "key 7");
  const auto points = outbox.Next();
  ASSERT_TRUE(points.has_value());
  EXPECT_TRUE(points->binary);
  EXPECT_EQ(*points->bytes, "points");
}

}  // namespace
}  // namespace latticeworld
