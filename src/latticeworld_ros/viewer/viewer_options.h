#ifndef LATTICEWORLD_ROS_VIEWER_VIEWER_OPTIONS_H_
#define LATTICEWORLD_ROS_VIEWER_VIEWER_OPTIONS_H_

#include <XmlRpcValue.h>

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/viewer/server/viewer_server.h"

namespace latticeworld {

// The parameters of world_viewer; launch_cfg/world_viewer.yaml has one entry a field.
struct ViewerOptions {
  ViewerServerOptions server;  // its token is read from the variable below
  std::string page_directory;  // "": the program's own
  std::string token_variable = "LATTICEWORLD_VIEWER_TOKEN";  // environment variable; "": no token
  double state_rate_hz = 20.0;                               // [1, 60] of state frames, wall time
};

// The options that the node's private parameters say; absent ones keep their defaults. Reads the
// environment variable of the token. Errors: INVALID_ARGUMENT naming every unknown name, wrong type
// and illegal value.
Result<ViewerOptions> ViewerOptionsFromParameters(const XmlRpc::XmlRpcValue& parameters);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_VIEWER_VIEWER_OPTIONS_H_
