#ifndef LATTICEWORLD_VIEWER_SERVER_OUTBOX_H_
#define LATTICEWORLD_VIEWER_SERVER_OUTBOX_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "latticeworld/viewer/payloads/state_stream.h"

namespace latticeworld {

using SharedBytes = std::shared_ptr<const std::string>;

struct OutMessage {
  SharedBytes bytes;
  bool binary = false;
};

// What waits to be sent to one client, however slow it is: of everything that has a newer
// version only the newest, of what happens once the last kMostOnce. So it never grows, and what a
// slow client gets is little but not late.
class Outbox {
 public:
  static constexpr std::size_t kMostOnce = 128;

  // The newest text of a slot takes the place of one that still waits.
  void SetText(const std::string& slot, SharedBytes text);
  // Texts that are said once, in their order; the oldest of too many is lost.
  void AddText(SharedBytes text);
  void SetFrame(StreamKind kind, const StreamFrame& frame);
  void SetPoints(SharedBytes points);

  // What to send next; nullopt: nothing. Texts come before frames, which need the tables in them.
  std::optional<OutMessage> Next();

 private:
  struct Waiting {
    bool is_new = false;
    StreamFrame frame;
    std::uint64_t sent_key = 0;  // number of the key frame that the client has; 0: none
  };

  std::deque<std::string> order_;  // slots of what waits in `texts_`
  std::map<std::string, SharedBytes> texts_;
  std::deque<SharedBytes> once_;
  std::array<Waiting, 2> frames_;  // agents, props
  SharedBytes points_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_OUTBOX_H_
