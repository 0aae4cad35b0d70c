#ifndef LATTICEWORLD_VIEWER_SERVER_SERVER_CORE_H_
#define LATTICEWORLD_VIEWER_SERVER_SERVER_CORE_H_

#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/viewer/server/mailbox.h"
#include "latticeworld/viewer/server/outbox.h"
#include "latticeworld/viewer/server/viewer_server.h"
#include "latticeworld/viewer/viewer_backend.h"

namespace latticeworld {

class ClientConversation;

// What all connections of a server share. Everything happens on the server's thread.
class ServerCore {
 public:
  ServerCore(ViewerServerOptions options, PayloadMap page, ViewerBackend* backend,
             std::shared_ptr<Mailbox> mailbox);

  const ViewerServerOptions& options() const { return options_; }
  const std::shared_ptr<const PayloadMap>& page() const { return page_; }
  const std::shared_ptr<const WorldPayloads>& world() const { return world_; }
  std::string world_key() const { return world_ == nullptr ? "" : world_->key; }

  // Connections, WebSockets among them.
  bool has_room() const { return connections_ < options_.max_connections; }
  bool has_room_for_client() const {
    return static_cast<int>(clients_.size()) < options_.max_clients;
  }
  void OnConnect() { ++connections_; }
  void OnDisconnect() { --connections_; }

  // A client comes: hears what was told so far. It leaves before it dies.
  void Join(ClientConversation* client);
  void Leave(ClientConversation* client);
  // Its layers have changed: what they show it hears at once.
  void OnLayers(ClientConversation* client);

  // done: called on the server's thread, at most once.
  void Do(const ViewerRequest& request, ViewerBackend::Done done);

  void SetWorld(std::shared_ptr<const WorldPayloads> world, const std::string& reason);
  void Tell(const std::string& slot, std::string text, Audience audience, bool remember);
  void Forget(const std::string& slot, std::string text, Audience audience);
  void TellOnce(std::string text);
  void Show(StreamKind kind, const StreamFrame& frame);
  void ShowPoints(const std::string& robot, std::string points);

 private:
  struct Told {
    std::string slot;
    SharedBytes text;
    Audience audience = Audience::kEverybody;
  };

  void TellClients(const Told& told);
  void UpdateDemand();

  const ViewerServerOptions options_;
  const std::shared_ptr<const PayloadMap> page_;
  ViewerBackend* backend_;
  std::shared_ptr<Mailbox> mailbox_;
  std::shared_ptr<const WorldPayloads> world_;
  std::vector<Told> told_;             // in the order of their slots' beginnings
  std::array<StreamFrame, 2> frames_;  // agents, props; no key frame: none yet
  std::vector<ClientConversation*> clients_;
  LayerDemand demand_;
  int connections_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_SERVER_CORE_H_
