#include "latticeworld/language/chat/event_stream.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace latticeworld {
namespace {

using Events = std::vector<std::pair<std::string, std::string>>;  // type and data

Events ReadInPieces(const std::vector<std::string_view>& pieces) {
  Events events;
  const auto keep = [&](std::string_view type, std::string_view data) {
    events.emplace_back(type, data);
  };
  EventStreamParser parser;
  for (const std::string_view piece : pieces) parser.Feed(piece, keep);
  parser.Finish(keep);
  return events;
}

TEST(EventStreamTest, ReadsEventsByTheirFields) {
  struct Row {
    const char* what;
    std::string_view stream;
    Events events;
  };
  const Row rows[] = {
      {"one event", "data: a\n\n", {{"", "a"}}},
      {"no blank after the colon", "data:a\n\n", {{"", "a"}}},
      {"only one blank is dropped", "data:  a \n\n", {{"", " a "}}},
      {"two events", "data: a\n\ndata: b\n\n", {{"", "a"}, {"", "b"}}},
      {"data of several lines", "data: a\ndata:\ndata: b\n\n", {{"", "a\n\nb"}}},
      {"a field without a colon", "data\n\n", {{"", ""}}},
      {"comments", ": ping\n\n:\n\ndata: a\n: pong\n\n", {{"", "a"}}},
      {"a type", "event: error\ndata: a\n\ndata: b\n\n", {{"error", "a"}, {"", "b"}}},
      {"a type without data", "event: ping\n\ndata: b\n\n", {{"", "b"}}},
      {"fields that mean nothing here", "id: 7\nretry: 3\ndata: a\nwhat: ever\n\n", {{"", "a"}}},
      {"blank lines", "\n\n\ndata: a\n\n\n\n", {{"", "a"}}},
      {"CRLF", "data: a\r\ndata: b\r\n\r\ndata: c\r\n\r\n", {{"", "a\nb"}, {"", "c"}}},
      {"CR", "data: a\rdata: b\r\rdata: c\r\r", {{"", "a\nb"}, {"", "c"}}},
      {"a byte order mark",
       "\xEF\xBB\xBF"
       "data: a\n\n",
       {{"", "a"}}},
      {"UTF-8", "data: w\xC3\xB6rld \xF0\x9F\x8C\x8D\n\n", {{"", "w\xC3\xB6rld \xF0\x9F\x8C\x8D"}}},
      {"the last blank line is missing", "data: a\n\ndata: b\n", {{"", "a"}, {"", "b"}}},
      {"the last line end is missing", "data: a\n\ndata: b", {{"", "a"}, {"", "b"}}},
      {"nothing", "", {}},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.what);
    EXPECT_EQ(ReadInPieces({row.stream}), row.events);
    // The same, wherever the network cuts it.
    for (std::size_t cut = 0; cut <= row.stream.size(); ++cut) {
      EXPECT_EQ(ReadInPieces({row.stream.substr(0, cut), row.stream.substr(cut)}), row.events)
          << "cut after byte " << cut;
    }
    std::vector<std::string_view> bytes;
    for (std::size_t i = 0; i < row.stream.size(); ++i) bytes.push_back(row.stream.substr(i, 1));
    EXPECT_EQ(ReadInPieces(bytes), row.events) << "byte by byte";
  }
}

TEST(EventStreamTest, AnEventComesAsSoonAsItsBlankLine) {
  EventStreamParser parser;
  int events = 0;
  const auto count = [&](std::string_view, std::string_view) { ++events; };
  parser.Feed("data: a\r\n", count);
  EXPECT_EQ(events, 0);
  parser.Feed("\r", count);  // the LF that may follow is not waited for
  EXPECT_EQ(events, 1);
  parser.Feed("\ndata: b\n\n", count);
  EXPECT_EQ(events, 2);
}

}  // namespace
}  // namespace latticeworld
