#include "latticeworld/viewer/server/client_conversation.h"

#include <utility>

#include "latticeworld/viewer/server/server_core.h"
#include "latticeworld/viewer/server/server_messages.h"

namespace latticeworld {
namespace {

constexpr int kMostPending = 8;
// A client whose messages are refused this often in a row must leave; a browser whose timers lag
// does not come near.
constexpr int kMostRefusedInARow = 240;
constexpr double kTokenRate_hz = 0.5, kTokenBurst = 5.0;
constexpr double kComplaintRate_hz = 1.0, kComplaintBurst = 5.0;
constexpr char kHelloSlot[] = "hello";

bool IsSilent(RequestType type) {
  return type == RequestType::kDrive || type == RequestType::kStrike;
}

}  // namespace

ClientConversation::ClientConversation(ServerCore* core, const ClientFacts& facts,
                                       std::function<void()> wake)
    : core_(core),
      wake_(std::move(wake)),
      may_control_(MayControl(facts, core->options().access)),
      tokens_(kTokenRate_hz, kTokenBurst),
      complaints_(kComplaintRate_hz, kComplaintBurst) {}

ClientConversation::~ClientConversation() { End(); }

void ClientConversation::Begin() {
  SayHello();
  joined_ = true;
  core_->Join(this);
}

void ClientConversation::End() {
  wake_ = nullptr;
  if (std::exchange(joined_, false)) core_->Leave(this);
}

bool ClientConversation::Hear(std::string_view text, bool is_text, double now_s) {
  if (!messages_.Take(now_s)) {
    if (complaints_.Take(now_s)) {
      Say(ErrorMessage(ResourceExhausted("too many messages; legal are 60 a second")));
    }
    return ++refused_in_a_row_ < kMostRefusedInARow;
  }
  refused_in_a_row_ = 0;
  if (!is_text) {
    Say(ErrorMessage(InvalidArgument("a message is binary; legal is JSON as text")));
    return true;
  }
  std::string id, type;
  const Result<ViewerRequest> request = ParseRequest(text, &id, &type);
  if (!request.ok()) {
    Refuse(id, type, request.status());
  } else {
    Handle(*request, now_s);
  }
  return true;
}

void ClientConversation::Handle(const ViewerRequest& request, double now_s) {
  switch (request.type) {
    case RequestType::kAuthenticate:
      return Authenticate(request, now_s);
    case RequestType::kSubscribe:
      lidar_ = request.lidar;
      paths_ = request.paths;
      robot_ = request.robot;
      core_->OnLayers(this);
      return Reply(request, ViewerReply());
    default:
      break;
  }
  if (IsControl(request.type) && !may_control_) {
    return Refuse(request.id, NameOf(request.type),
                  PermissionDenied(core_->options().access.token.empty()
                                       ? "this client may look only; controlling from elsewhere "
                                         "takes a token, and this server has none"
                                       : "this client may look only; authenticate with the "
                                         "server's token"));
  }
  PassOn(request);
}

void ClientConversation::Authenticate(const ViewerRequest& request, double now_s) {
  if (!tokens_.Take(now_s)) {
    return Refuse(request.id, NameOf(request.type), ResourceExhausted("too many tokens; wait"));
  }
  if (!IsToken(request.token, core_->options().access)) {
    return Refuse(request.id, NameOf(request.type),
                  Status(StatusCode::kUnauthenticated, "that is not the server's token"));
  }
  may_control_ = true;
  SayHello();
  Reply(request, ViewerReply());
}

void ClientConversation::PassOn(const ViewerRequest& request) {
  const bool silent = IsSilent(request.type);
  if (!silent && pending_ >= kMostPending) {
    return Refuse(request.id, NameOf(request.type),
                  ResourceExhausted("8 requests of this client are not done yet; wait"));
  }
  if (!silent) ++pending_;
  core_->Do(request, [weak = weak_from_this(), request, silent](const ViewerReply& reply) {
    const std::shared_ptr<ClientConversation> self = weak.lock();
    if (self == nullptr) return;
    if (!silent) --self->pending_;
    if (!silent || !reply.status.ok()) self->Reply(request, reply);
  });
}

void ClientConversation::SayHello() {
  const std::string key = core_->world_key();
  outbox_.SetText(kHelloSlot, std::make_shared<const std::string>(
                                  HelloMessage(may_control_, !core_->options().access.token.empty(),
                                               core_->options().moves, key)));
  Wake();
}

void ClientConversation::Say(std::string text) {
  outbox_.AddText(std::make_shared<const std::string>(std::move(text)));
  Wake();
}

void ClientConversation::Reply(const ViewerRequest& request, const ViewerReply& reply) {
  Say(ReplyMessage(request.id, NameOf(request.type), reply.status,
                   reply.worlds ? &*reply.worlds : nullptr, reply.world.empty() ? "" : "world",
                   reply.world));
}

void ClientConversation::Refuse(const std::string& id, std::string_view type,
                                const Status& status) {
  if (type.empty()) return Say(ErrorMessage(status));
  Say(ReplyMessage(id, type, status, nullptr, "", ""));
}

}  // namespace latticeworld
