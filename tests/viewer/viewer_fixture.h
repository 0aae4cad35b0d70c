#ifndef LATTICEWORLD_TESTS_VIEWER_VIEWER_FIXTURE_H_
#define LATTICEWORLD_TESTS_VIEWER_VIEWER_FIXTURE_H_

#include <gtest/gtest.h>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "latticeworld/viewer/server/page_files.h"
#include "latticeworld/viewer/server/viewer_server.h"
#include "latticeworld/viewer/viewer_backend.h"
#include "viewer/plain_client.h"

namespace latticeworld {

inline constexpr char kPageText[] = "<!DOCTYPE html><title>page</title>";

// Payloads of the small world of tests/generation, made once.
std::shared_ptr<const WorldPayloads> SmallWorld();

// Keeps requests until the test answers them.
class FakeBackend : public ViewerBackend {
 public:
  void Do(const ViewerRequest& request, Done done) override;
  void OnDemand(const LayerDemand& demand) override;

  // The oldest request that was not waited for yet; fails after 20 s.
  ViewerRequest WaitForRequest();
  // The answer to the oldest request that has none.
  void Answer(const ViewerReply& reply);
  std::size_t requests();
  LayerDemand demand();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<ViewerRequest> heard_;
  std::deque<Done> waiting_;
  std::size_t requests_ = 0;
  LayerDemand demand_;
};

// A server on a free port of 127.0.0.1, with a page of one file.
class ViewerServerTest : public ::testing::Test {
 protected:
  void Start() {
    ViewerServerOptions options;
    options.port = 0;
    Start(options);
  }
  void Start(const ViewerServerOptions& options);
  void End() { server_.reset(); }

  ViewerServer& server() { return *server_; }
  FakeBackend& backend() { return backend_; }
  PlainClient Connect() { return PlainClient(server_->port()); }
  // The next binary message; fails where the connection ends before it.
  static std::string ReadBinary(PlainClient* client);

 private:
  FakeBackend backend_;
  std::unique_ptr<ViewerServer> server_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_VIEWER_VIEWER_FIXTURE_H_
