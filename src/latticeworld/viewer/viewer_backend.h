#ifndef LATTICEWORLD_VIEWER_VIEWER_BACKEND_H_
#define LATTICEWORLD_VIEWER_VIEWER_BACKEND_H_

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/viewer/server/viewer_request.h"

namespace latticeworld {

// How a request ended.
struct ViewerReply {
  Status status;
  std::optional<std::vector<BundleSummary>> worlds;  // of list_worlds
  std::string world;                                 // generate, load_world, save_world: its id
};

// Layers that at least one client looks at.
struct LayerDemand {
  std::set<std::string> lidar_robots;  // whose points; "": of any one
  bool paths = false;
  friend bool operator==(const LayerDemand& a, const LayerDemand& b) {
    return a.lidar_robots == b.lidar_robots && a.paths == b.paths;
  }
};

// What a ViewerServer controls. Its functions are called on the server's thread (and as the server
// dies), one at a time, and must not wait.
class ViewerBackend {
 public:
  using Done = std::function<void(ViewerReply)>;

  virtual ~ViewerBackend() = default;
  // Does what was asked for by somebody who may. done: to be called at most once, from any thread,
  // also after the server has ended. Not called for drive and strike that went well.
  virtual void Do(const ViewerRequest& request, Done done) = 0;
  // The demand has changed; at first there is none.
  virtual void OnDemand(const LayerDemand& demand) = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_VIEWER_BACKEND_H_
