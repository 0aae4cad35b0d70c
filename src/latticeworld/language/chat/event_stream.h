#ifndef LATTICEWORLD_LANGUAGE_CHAT_EVENT_STREAM_H_
#define LATTICEWORLD_LANGUAGE_CHAT_EVENT_STREAM_H_

#include <functional>
#include <string>
#include <string_view>

namespace latticeworld {

// EventStreamParser reads server-sent events (WHATWG HTML, "Server-sent events") from bytes that
// come in pieces of any size. Lines end in LF, CR or CRLF, comments are dropped, and the data lines
// of one event are joined by LF. The parser holds back one event at most, so whoever feeds it
// bounds what it holds.
class EventStreamParser {
 public:
  // Handler is called with the event's name in `type`, "" when it has none, and with what its data
  // lines say in `data`.
  using Handler = std::function<void(std::string_view type, std::string_view data)>;

  // Calls handler for every event that these bytes complete.
  void Feed(std::string_view bytes, const Handler& handler);
  // Ends the stream. An event whose closing blank line is missing is handed on as well: servers
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
