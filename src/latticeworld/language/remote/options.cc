#include "latticeworld/common/range.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {

std::vector<Violation> Validate(const RemoteOptions& options) {
  std::vector<Violation> violations;
  CheckRange("repair_turns", options.repair_turns, {0, kMostRepairTurns}, "", &violations);
  CheckRange("temperature", options.temperature, {0.0, 2.0}, "", &violations);
  CheckRange("layout_max_tokens", options.layout_max_tokens, {64, 65536}, "", &violations);
  CheckRange("environment_max_tokens", options.environment_max_tokens, {64, 65536}, "",
             &violations);
  return violations;
}

}  // namespace latticeworld
