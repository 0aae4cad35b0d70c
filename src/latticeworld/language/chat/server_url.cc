#include "latticeworld/language/chat/server_url.h"

#include <curl/curl.h>

#include <memory>
#include <string_view>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

struct UrlDeleter {
  void operator()(CURLU* url) const { curl_url_cleanup(url); }
};

// "": the address has no such part.
std::string Part(CURLU* url, CURLUPart part) {
  char* text = nullptr;
  if (curl_url_get(url, part, &text, 0) != CURLUE_OK || text == nullptr) return "";
  std::string copy = text;
  curl_free(text);
  return copy;
}

// Names are resolved by whoever answers for them; only those that always mean this machine count.
bool IsLoopback(const std::string& host) {
  return host == "localhost" || EndsWith(host, ".localhost") || host == "[::1]" ||
         (host.substr(0, 4) == "127." &&
          host.find_first_not_of("0123456789.") == std::string::npos);
}

}  // namespace

Result<ServerUrl> ParseServerUrl(const std::string& url) {
  const auto refuse = [](const std::string& why) {
    return InvalidArgument("must be like \"http://127.0.0.1:8080/v1\"; " + why);
  };
  const std::unique_ptr<CURLU, UrlDeleter> parts(curl_url());
  if (parts == nullptr) return ResourceExhausted("no memory for an address");
  // A password is named by no message, so the address as a whole is not either.
  if (curl_url_set(parts.get(), CURLUPART_URL, url.c_str(), CURLU_NON_SUPPORT_SCHEME) !=
      CURLUE_OK) {
    return refuse("this is no address");
  }
  const std::string scheme = ToLowerAscii(Part(parts.get(), CURLUPART_SCHEME));
  if (scheme != "http" && scheme != "https") {
    return refuse("the scheme " + Quote(scheme) + " is neither http nor https");
  }
  const std::string host = ToLowerAscii(Part(parts.get(), CURLUPART_HOST));
  if (host.empty()) return refuse("there is no host");
  if (!Part(parts.get(), CURLUPART_USER).empty() ||
      !Part(parts.get(), CURLUPART_PASSWORD).empty()) {
    return refuse("a user or password has no place in it: name a key's variable instead");
  }
  if (!Part(parts.get(), CURLUPART_QUERY).empty() ||
      !Part(parts.get(), CURLUPART_FRAGMENT).empty()) {
    return refuse("a query or fragment has no place in it");
  }
  std::string base = url;
  while (EndsWith(base, "/")) base.pop_back();
  if (EndsWith(base, "/completions") || EndsWith(base, "/models")) {
    return refuse("this one is an endpoint: leave out what follows the version");
  }
  return ServerUrl{base, IsLoopback(host)};
}

}  // namespace latticeworld
