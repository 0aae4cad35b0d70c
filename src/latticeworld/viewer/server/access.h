#ifndef LATTICEWORLD_VIEWER_SERVER_ACCESS_H_
#define LATTICEWORLD_VIEWER_SERVER_ACCESS_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/status.h"

namespace latticeworld {

// Who may look and who may control.
struct AccessOptions {
  // Who knows it may control from anywhere. Empty: nobody may but who sits at the machine itself.
  std::string token;
  bool require_token = false;              // at the machine itself, too
  std::vector<std::string> allowed_hosts;  // names by which browsers may call this server, beside
                                           // localhost and numeric addresses
};

// What is known of a client when it connects.
struct ClientFacts {
  bool from_loopback = false;  // by its address
  bool forwarded = false;      // it says that it comes through a proxy
  std::string host;            // header Host, with its port
  std::string origin;          // header Origin; empty: no browser's script
};

// "localhost", "127.0.0.1:8080", "[::1]": names of the machine itself.
bool IsLoopbackHost(std::string_view host);
// OK, or PERMISSION_DENIED: by a name that is not this server's a foreign page may have been led
// here (DNS rebinding); addresses cannot be.
Status CheckHost(std::string_view host, const AccessOptions& options);
// OK where there is no origin or it is the page that this server served to that host;
// PERMISSION_DENIED else.
Status CheckOrigin(std::string_view origin, std::string_view host);
// Whether a client may control without a token.
bool MayControl(const ClientFacts& client, const AccessOptions& options);
// Whether a token is the right one; the time that it takes says nothing about how much of it is
// right. False where there is no token.
bool IsToken(std::string_view given, const AccessOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_ACCESS_H_
