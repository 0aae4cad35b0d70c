#include "viewer/viewer_fixture.h"

#include <chrono>

#include "generation/test_world.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

std::shared_ptr<const WorldPayloads> SmallWorld() {
  static const std::shared_ptr<const WorldPayloads> payloads = [] {
    auto made = MakeWorldPayloads(*MakeTestWorld(), *SpeciesCatalogue::BuiltIn(), /*moves=*/true,
                                  Progress());
    EXPECT_TRUE(made.ok()) << made.status().ToString();
    return *std::move(made);
  }();
  return payloads;
}

void FakeBackend::Do(const ViewerRequest& request, Done done) {
  const std::lock_guard<std::mutex> lock(mutex_);
  heard_.push_back(request);
  waiting_.push_back(std::move(done));
  ++requests_;
  changed_.notify_all();
}

void FakeBackend::OnDemand(const LayerDemand& demand) {
  const std::lock_guard<std::mutex> lock(mutex_);
  demand_ = demand;
}

ViewerRequest FakeBackend::WaitForRequest() {
  std::unique_lock<std::mutex> lock(mutex_);
  if (!changed_.wait_for(lock, std::chrono::seconds(20), [this] { return !heard_.empty(); })) {
    ADD_FAILURE() << "no request came";
    return {};
  }
  ViewerRequest request = heard_.front();
  heard_.pop_front();
  return request;
}

void FakeBackend::Answer(const ViewerReply& reply) {
  Done done;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (waiting_.empty()) {
      ADD_FAILURE() << "there is no request to answer";
      return;
    }
    done = std::move(waiting_.front());
    waiting_.pop_front();
  }
  done(reply);
}

std::size_t FakeBackend::requests() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return requests_;
}

LayerDemand FakeBackend::demand() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return demand_;
}

void ViewerServerTest::Start(const ViewerServerOptions& options) {
  PayloadMap page;
  page.emplace("/", MakePayload("text/html; charset=utf-8", kPageText, false));
  page.emplace("/app.js", MakePayload("text/javascript; charset=utf-8", "1;", false));
  auto server = ViewerServer::Start(options, std::move(page), &backend_);
  ASSERT_TRUE(server.ok()) << server.status().ToString();
  server_ = *std::move(server);
}

std::string ViewerServerTest::ReadBinary(PlainClient* client) {
  for (;;) {
    const PlainClient::Message message = client->ReadMessage();
    if (message.opcode == 2) return message.payload;
    if (message.opcode == 0 || message.opcode == 8) {
      ADD_FAILURE() << "the connection ended";
      return "";
    }
  }
}

}  // namespace latticeworld
