#include "latticeworld/viewer/server/server_core.h"

#include <algorithm>
#include <utility>

#include "latticeworld/viewer/server/client_conversation.h"
#include "latticeworld/viewer/server/server_messages.h"

namespace latticeworld {
namespace {

constexpr char kWorldSlot[] = "world";

SharedBytes Shared(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

std::size_t IndexOf(StreamKind kind) { return kind == StreamKind::kAgents ? 0 : 1; }

bool IsFor(const ClientConversation& client, Audience audience) {
  return audience == Audience::kEverybody || client.sees_paths();
}

}  // namespace

ServerCore::ServerCore(ViewerServerOptions options, PayloadMap page, ViewerBackend* backend,
                       std::shared_ptr<Mailbox> mailbox)
    : options_(std::move(options)),
      page_(std::make_shared<const PayloadMap>(std::move(page))),
      backend_(backend),
      mailbox_(std::move(mailbox)) {}

void ServerCore::Join(ClientConversation* client) {
  clients_.push_back(client);
  for (const Told& told : told_) {
    if (IsFor(*client, told.audience)) client->outbox().SetText(told.slot, told.text);
  }
  for (const StreamKind kind : {StreamKind::kAgents, StreamKind::kProps}) {
    const StreamFrame& frame = frames_[IndexOf(kind)];
    if (frame.key != nullptr) client->outbox().SetFrame(kind, frame);
  }
  client->Wake();
  UpdateDemand();
}

void ServerCore::Leave(ClientConversation* client) {
  clients_.erase(std::remove(clients_.begin(), clients_.end(), client), clients_.end());
  UpdateDemand();
}

void ServerCore::OnLayers(ClientConversation* client) {
  for (const Told& told : told_) {
    if (told.audience == Audience::kEverybody || !IsFor(*client, told.audience)) continue;
    client->outbox().SetText(told.slot, told.text);
  }
  client->Wake();
  UpdateDemand();
}

void ServerCore::UpdateDemand() {
  LayerDemand demand;
  for (const ClientConversation* client : clients_) {
    if (client->sees_lidar()) demand.lidar_robots.insert(client->robot());
    demand.paths = demand.paths || client->sees_paths();
  }
  if (demand == demand_) return;
  demand_ = std::move(demand);
  backend_->OnDemand(demand_);
}

void ServerCore::Do(const ViewerRequest& request, ViewerBackend::Done done) {
  backend_->Do(request, [mailbox = mailbox_, done = std::move(done)](ViewerReply reply) {
    mailbox->Post([done, reply = std::move(reply)] { done(reply); });
  });
}

void ServerCore::SetWorld(std::shared_ptr<const WorldPayloads> world, const std::string& reason) {
  world_ = std::move(world);
  told_.clear();
  frames_ = {};
  Tell(kWorldSlot, WorldMessage(world_key(), reason), Audience::kEverybody, /*remember=*/false);
}

void ServerCore::TellClients(const Told& told) {
  for (ClientConversation* client : clients_) {
    if (!IsFor(*client, told.audience)) continue;
    client->outbox().SetText(told.slot, told.text);
    client->Wake();
  }
}

void ServerCore::Tell(const std::string& slot, std::string text, Audience audience, bool remember) {
  const Told told{slot, Shared(std::move(text)), audience};
  if (remember) {
    const auto known = std::find_if(told_.begin(), told_.end(),
                                    [&slot](const Told& entry) { return entry.slot == slot; });
    if (known == told_.end()) {
      told_.push_back(told);
    } else {
      *known = told;
    }
  }
  TellClients(told);
}

void ServerCore::Forget(const std::string& slot, std::string text, Audience audience) {
  told_.erase(std::remove_if(told_.begin(), told_.end(),
                             [&slot](const Told& entry) { return entry.slot == slot; }),
              told_.end());
  if (!text.empty()) TellClients({slot, Shared(std::move(text)), audience});
}

void ServerCore::TellOnce(std::string text) {
  const SharedBytes shared = Shared(std::move(text));
  for (ClientConversation* client : clients_) {
    client->outbox().AddText(shared);
    client->Wake();
  }
}

void ServerCore::Show(StreamKind kind, const StreamFrame& frame) {
  frames_[IndexOf(kind)] = frame;
  for (ClientConversation* client : clients_) {
    client->outbox().SetFrame(kind, frame);
    client->Wake();
  }
}

void ServerCore::ShowPoints(const std::string& robot, std::string points) {
  const SharedBytes shared = Shared(std::move(points));
  for (ClientConversation* client : clients_) {
    if (!client->sees_lidar() || (!client->robot().empty() && client->robot() != robot)) continue;
    client->outbox().SetPoints(shared);
    client->Wake();
  }
}

}  // namespace latticeworld
