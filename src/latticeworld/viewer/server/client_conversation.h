#ifndef LATTICEWORLD_VIEWER_SERVER_CLIENT_CONVERSATION_H_
#define LATTICEWORLD_VIEWER_SERVER_CLIENT_CONVERSATION_H_

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "latticeworld/viewer/server/access.h"
#include "latticeworld/viewer/server/outbox.h"
#include "latticeworld/viewer/server/rate_limit.h"
#include "latticeworld/viewer/viewer_backend.h"

namespace latticeworld {

class ServerCore;

inline constexpr double kMessageRate_hz = 60.0;
inline constexpr double kMessageBurst = 120.0;

// What is said with one client, apart from how it gets there: who it is, what it may, what it
// asked for, what waits to be sent.
class ClientConversation : public std::enable_shared_from_this<ClientConversation> {
 public:
  // wake: called when there is something to send.
  ClientConversation(ServerCore* core, const ClientFacts& facts, std::function<void()> wake);
  ~ClientConversation();
  ClientConversation(const ClientConversation&) = delete;
  ClientConversation& operator=(const ClientConversation&) = delete;

  // Says hello and joins. To be called once.
  void Begin();
  // Hears a message. False: the client goes on and on beyond what it may, and is to be left.
  bool Hear(std::string_view text, bool is_text, double now_s);
  // Leaves; nothing is said any more.
  void End();

  Outbox& outbox() { return outbox_; }
  void Wake() {
    if (wake_) wake_();
  }
  bool sees_lidar() const { return lidar_; }
  bool sees_paths() const { return paths_; }
  const std::string& robot() const { return robot_; }  // whose points; empty: anybody's

 private:
  void SayHello();
  void Say(std::string text);
  void Reply(const ViewerRequest& request, const ViewerReply& reply);
  void Refuse(const std::string& id, std::string_view type, const Status& status);
  void Handle(const ViewerRequest& request, double now_s);
  void Authenticate(const ViewerRequest& request, double now_s);
  void PassOn(const ViewerRequest& request);

  ServerCore* core_;
  std::function<void()> wake_;
  Outbox outbox_;
  bool may_control_;
  bool lidar_ = false, paths_ = false;
  std::string robot_;
  RateLimit messages_{kMessageRate_hz, kMessageBurst};
  RateLimit tokens_;      // of wrong ones
  RateLimit complaints_;  // that are told
  int refused_in_a_row_ = 0;
  int pending_ = 0;  // requests that are not answered yet
  bool joined_ = false;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_CLIENT_CONVERSATION_H_
