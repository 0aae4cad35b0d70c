#ifndef LATTICEWORLD_LANGUAGE_CHAT_SERVER_URL_H_
#define LATTICEWORLD_LANGUAGE_CHAT_SERVER_URL_H_

#include <string>

#include "latticeworld/common/result.h"

namespace latticeworld {

// ServerUrl is a server's base address, taken apart once.
struct ServerUrl {
  std::string base;  // without a slash at its end; endpoints are base + "/models" and so on
  bool is_loopback = false;
};

// Takes a base address apart. Errors: INVALID_ARGUMENT for anything but http or https, for no host,
// for a user or password (an address is written into logs), a query or fragment, and for an
// endpoint in the base's place.
Result<ServerUrl> ParseServerUrl(const std::string& url);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_SERVER_URL_H_
