#include "latticeworld/language/chat/event_stream.h"

#include <cstddef>

namespace latticeworld {

void EventStreamParser::Feed(std::string_view bytes, const Handler& handler) {
  while (!bytes.empty()) {
    if (after_cr_ && bytes.front() == '\n') bytes.remove_prefix(1);
    after_cr_ = false;
    const std::size_t end = bytes.find_first_of("\r\n");
    line_ += bytes.substr(0, end);
    if (end == std::string_view::npos) return;
    after_cr_ = bytes[end] == '\r';
    bytes.remove_prefix(end + 1);
    EndLine(handler);
  }
}

void EventStreamParser::Finish(const Handler& handler) {
  if (!line_.empty()) EndLine(handler);
  EndEvent(handler);
}

void EventStreamParser::EndLine(const Handler& handler) {
  std::string_view line = line_;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (first_line_ && line.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    line.remove_prefix(kByteOrderMark.size());
  }
  first_line_ = false;
  if (line.empty()) {
    EndEvent(handler);
  } else {
    const std::size_t colon = line.find(':');
    const std::string_view field = line.substr(0, colon);
    std::string_view value = colon == std::string_view::npos ? "" : line.substr(colon + 1);
    if (!value.empty() && value.front() == ' ') value.remove_prefix(1);
    // Any other field, and a comment (an empty field), says nothing to us.
    if (field == "data") {
      if (has_data_) data_ += '\n';
      data_ += value;
      has_data_ = true;
    } else if (field == "event") {
      type_ = value;
    }
  }
  line_.clear();
}

void EventStreamParser::EndEvent(const Handler& handler) {
  if (has_data_) handler(type_, data_);
  type_.clear();
  data_.clear();
  has_data_ = false;
}

}  // namespace latticeworld
