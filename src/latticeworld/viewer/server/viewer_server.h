#ifndef LATTICEWORLD_VIEWER_SERVER_VIEWER_SERVER_H_
#define LATTICEWORLD_VIEWER_SERVER_VIEWER_SERVER_H_

#include <memory>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/viewer/payloads/payload.h"
#include "latticeworld/viewer/payloads/state_stream.h"
#include "latticeworld/viewer/payloads/world_payloads.h"
#include "latticeworld/viewer/server/access.h"

namespace latticeworld {

class ViewerBackend;

struct ViewerServerOptions {
  std::string host = "127.0.0.1";  // numeric address to listen at, or localhost
  int port = 8080;                 // [0, 65535]; 0: any that is free
  AccessOptions access;
  bool moves = true;          // whether something is simulated
  int max_connections = 256;  // [1, 10000] at a time, of all kinds
  int max_clients = 64;       // [1, 10000] WebSockets at a time
  // How long a client may take; tests shorten them. All > 0.
  double header_timeout_s = 15.0;   // to send a request, and between two of them
  double body_timeout_s = 300.0;    // to take an answer
  double silence_timeout_s = 30.0;  // of a WebSocket that answers no ping
};
// Every violation, each with its option's name.
std::vector<Violation> Validate(const ViewerServerOptions& options);

// Whom a text is for.
enum class Audience : std::uint8_t { kEverybody, kPaths };

// Serves the page, the payloads of a world and the stream of its state: docs/viewer.md. One thread
// of its own does all of it, and nothing that a client does, or leaves undone, makes a caller wait.
// All functions may be called from any thread.
class ViewerServer {
 public:
  // backend: outlives the server. Errors: INVALID_ARGUMENT (options), UNAVAILABLE (it cannot
  // listen there).
  static Result<std::unique_ptr<ViewerServer>> Start(const ViewerServerOptions& options,
                                                     PayloadMap page, ViewerBackend* backend);
  ~ViewerServer();  // Stops.
  ViewerServer(const ViewerServer&) = delete;
  ViewerServer& operator=(const ViewerServer&) = delete;

  // Ends every connection and the thread. Nothing happens afterwards.
  void Stop();
  int port() const;

  // Another world, or none (null). What was told of the one before is forgotten.
  void SetWorld(std::shared_ptr<const WorldPayloads> world, const std::string& reason);
  // A text that replaces what was told last under `slot`; who joins later hears it, too.
  void Tell(const std::string& slot, std::string text, Audience audience = Audience::kEverybody);
  // The same, but who joins later does not.
  void TellNow(const std::string& slot, std::string text);
  // Ends a slot; text: what is told now ("": nothing).
  void Forget(const std::string& slot, std::string text, Audience audience = Audience::kEverybody);
  // A text of its own: an event.
  void TellOnce(std::string text);
  void Show(StreamKind kind, StreamFrame frame);
  // A message of points, for those who look at that robot's or at anybody's.
  void ShowPoints(const std::string& robot, std::string points);

 private:
  class Impl;
  explicit ViewerServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_VIEWER_SERVER_H_
