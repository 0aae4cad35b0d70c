#include "latticeworld/viewer/server/access.h"

#include <arpa/inet.h>

#include <algorithm>
#include <cstddef>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// Returns a host without its port: "[::1]:80" -> "::1".
std::string_view NameOfHost(std::string_view host) {
  if (!host.empty() && host.front() == '[') {
    const std::size_t end = host.find(']');
    return end == std::string_view::npos ? std::string_view() : host.substr(1, end - 1);
  }
  return host.substr(0, host.find(':'));
}

bool IsAddress(const std::string& name) {
  unsigned char bytes[16];
  return inet_pton(AF_INET, name.c_str(), bytes) == 1 ||
         inet_pton(AF_INET6, name.c_str(), bytes) == 1;
}

}  // namespace

bool IsLoopbackHost(std::string_view host) {
  const std::string name = ToLowerAscii(NameOfHost(host));
  return name == "localhost" || name == "::1" || (StartsWith(name, "127.") && IsAddress(name));
}

Status CheckHost(std::string_view host, const AccessOptions& options) {
  const std::string name = ToLowerAscii(NameOfHost(host));
  if (IsLoopbackHost(host) || IsAddress(name)) return Status();
  const bool allowed = std::any_of(
      options.allowed_hosts.begin(), options.allowed_hosts.end(),
      [&name](const std::string& legal) { return !name.empty() && ToLowerAscii(legal) == name; });
  if (allowed) return Status();
  return PermissionDenied("the host is " + Quote(host) +
                          "; legal are localhost, numeric addresses and the names in "
                          "allowed_hosts");
}

Status CheckOrigin(std::string_view origin, std::string_view host) {
  if (origin.empty()) return Status();
  const std::string given = ToLowerAscii(origin), wanted = ToLowerAscii(host);
  if (given == "http://" + wanted || given == "https://" + wanted) return Status();
  return PermissionDenied("the origin is " + Quote(origin) + "; legal is the page's own, at " +
                          Quote(host));
}

bool MayControl(const ClientFacts& client, const AccessOptions& options) {
  return !options.require_token && client.from_loopback && !client.forwarded &&
         IsLoopbackHost(client.host);
}

bool IsToken(std::string_view given, const AccessOptions& options) {
  if (options.token.empty()) return false;
  const std::string a = Sha256Hex(given), b = Sha256Hex(options.token);
  unsigned different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    different |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return different == 0;
}

}  // namespace latticeworld
