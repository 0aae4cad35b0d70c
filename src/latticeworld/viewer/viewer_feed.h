#ifndef LATTICEWORLD_VIEWER_VIEWER_FEED_H_
#define LATTICEWORLD_VIEWER_VIEWER_FEED_H_

#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/simulation/world_state.h"
#include "latticeworld/viewer/payloads/state_stream.h"
#include "latticeworld/viewer/server/server_messages.h"
#include "latticeworld/viewer/server/viewer_server.h"

namespace latticeworld {

// Agents or props as the stream has them: rows of the table, and how each is.
template <typename Row>
struct StreamedState {
  std::vector<Row> rows;
  std::vector<StreamedThing> things;  // one a row
};
StreamedState<AgentRow> Streamed(const std::vector<AgentSnapshot>& agents);
StreamedState<PropRow> Streamed(const std::vector<PropSnapshot>& props);

// Turns states into tables and frames, and tells only what has changed. wall_s: a clock that never
// falls. Not for several threads at once.
class ViewerFeed {
 public:
  explicit ViewerFeed(ViewerServer* server) : server_(server) {}

  // Another world: everything is told anew.
  void Reset();
  void ShowAgents(double time_s, double wall_s, const StreamedState<AgentRow>& state);
  void ShowProps(double time_s, double wall_s, const StreamedState<PropRow>& state);

 private:
  template <typename Row>
  struct Stream {
    explicit Stream(StreamKind stream_kind) : kind(stream_kind), encoder(stream_kind) {}
    StreamKind kind;
    StateEncoder encoder;
    bool is_new = true;  // nothing was told yet
    std::uint32_t version = 0;
    double key_wall_s = 0.0;  // of the last key frame
    StreamedState<Row> told;
  };

  template <typename Row, typename Message>
  void Show(double time_s, double wall_s, const StreamedState<Row>& state, const char* slot,
            Message message, Stream<Row>* stream);

  ViewerServer* server_;
  Stream<AgentRow> agents_{StreamKind::kAgents};
  Stream<PropRow> props_{StreamKind::kProps};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_VIEWER_FEED_H_
