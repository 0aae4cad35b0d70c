#ifndef LATTICEWORLD_LANGUAGE_CHAT_EVENT_STREAM_H_
#define LATTICEWORLD_LANGUAGE_CHAT_EVENT_STREAM_H_

#include <functional>
#include <string>
#include <string_view>

namespace latticeworld {

// Reads server-sent events (WHATWG HTML, "Server-sent events") from bytes that come in pieces of
// any size: lines end in LF, CR or CRLF, comments are dropped, data lines of one event are joined
// by LF. What it holds back is at most one event, so whoever feeds it bounds it.
class EventStreamParser {
 public:
  // type: the event's name, "" when it has none; data: what its data lines say.
  using Handler = std::function<void(std::string_view type, std::string_view data)>;

  // Calls handler for every event that these bytes complete.
  void Feed(std::string_view bytes, const Handler& handler);
  // The stream is over. An event whose closing blank line is missing is handed on as well: servers
  // leave it out after their last event.
  void Finish(const Handler& handler);

 private:
  void EndLine(const Handler& handler);
  void EndEvent(const Handler& handler);

  std::string line_;  // begun, not ended
  std::string type_;
  std::string data_;
  bool has_data_ = false;
  bool first_line_ = true;
  bool after_cr_ = false;  // a LF that comes next belongs to the line end before
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_EVENT_STREAM_H_
