#include "latticeworld_ros/viewer/viewer_options.h"

#include <cstdlib>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/node/parameter_binding.h"

namespace latticeworld {
namespace {

constexpr double kLeastRate_hz = 1.0, kMostRate_hz = 60.0;
// Shorter ones can be guessed.
constexpr std::size_t kLeastTokenBytes = 8;

}  // namespace

Result<ViewerOptions> ViewerOptionsFromParameters(const XmlRpc::XmlRpcValue& parameters) {
  ViewerOptions options;
  std::vector<Violation> violations;
  // Every parameter is read and checked by itself.
  const BoundParameters known = {
      {"host", Bind(&options.server.host)},
      {"port", Bind(&options.server.port)},
      {"max_connections", Bind(&options.server.max_connections)},
      {"max_clients", Bind(&options.server.max_clients)},
      {"allowed_hosts", Bind(&options.server.access.allowed_hosts)},
      {"require_token", Bind(&options.server.access.require_token)},
      {"token_variable", Bind(&options.token_variable)},
      {"page_directory", Bind(&options.page_directory)},
      {"state_rate", Bind(&options.state_rate_hz)},
  };
  ReadParameters(parameters, known, &violations);
  for (Violation& violation : Validate(options.server)) violations.push_back(std::move(violation));
  if (!(options.state_rate_hz >= kLeastRate_hz && options.state_rate_hz <= kMostRate_hz)) {
    const std::string given = FormatDouble(options.state_rate_hz);
    violations.push_back(
        {"out_of_range", "state_rate", given + " is not legal; legal is 1 .. 60", given});
  }
  // The token comes from the environment, so that no parameter shows it.
  if (!options.token_variable.empty()) {
    const char* token = std::getenv(options.token_variable.c_str());
    options.server.access.token = token == nullptr ? "" : token;
    const std::size_t length = options.server.access.token.size();
    if (length > 0 && length < kLeastTokenBytes) {  // what it is stays unsaid
      violations.push_back({"too_short", "token_variable",
                            "the token in it has " + std::to_string(length) +
                                " bytes; legal are at least " + std::to_string(kLeastTokenBytes),
                            options.token_variable});
    }
  }
  // A token that is required must be there.
  if (options.server.access.require_token && options.server.access.token.empty()) {
    violations.push_back({"wrong_combination", "require_token",
                          "it is true, and there is no token; legal is true with a token in the "
                          "environment variable that token_variable names",
                          "true"});
  }
  LW_RETURN_IF_ERROR(Status::FromViolations("parameters of world_viewer", std::move(violations)));
  return options;
}

}  // namespace latticeworld
