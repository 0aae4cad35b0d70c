#ifndef LATTICEWORLD_LANGUAGE_CHAT_FAILURE_H_
#define LATTICEWORLD_LANGUAGE_CHAT_FAILURE_H_

#include <optional>
#include <utility>

#include "latticeworld/common/status.h"

namespace latticeworld {

// Failure says how one try ended.
struct Failure {
  Status status;                        // OK: it did not fail
  bool again = false;                   // another try may go better
  std::optional<double> retry_after_s;  // the server's own wish

  bool ok() const { return status.ok(); }

  static Failure Final(Status status) { return {std::move(status), false, std::nullopt}; }
  static Failure Passing(Status status) { return {std::move(status), true, std::nullopt}; }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_FAILURE_H_
