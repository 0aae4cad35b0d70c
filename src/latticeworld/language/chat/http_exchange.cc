#include "latticeworld/language/chat/http_exchange.h"

#include <curl/curl.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxHeadBytes = 64 << 10;
constexpr int kLongestPollMs = 20;

struct EasyDeleter {
  void operator()(CURL* easy) const { curl_easy_cleanup(easy); }
};
struct MultiDeleter {
  void operator()(CURLM* multi) const { curl_multi_cleanup(multi); }
};
struct ListDeleter {
  void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};
using Easy = std::unique_ptr<CURL, EasyDeleter>;
using Multi = std::unique_ptr<CURLM, MultiDeleter>;
using HeaderList = std::unique_ptr<curl_slist, ListDeleter>;

// What libcurl's callbacks write. No code of ours but this runs below libcurl.
struct Received {
  HttpHead head;
  std::string body;  // not yet handed on
  std::size_t head_bytes = 0;
  std::size_t body_bytes = 0;
  std::size_t max_body_bytes = 0;
  bool too_large = false;
};

std::string_view TrimmedValue(std::string_view line, std::size_t colon) {
  std::string_view value = line.substr(colon + 1);
  const std::size_t begin = value.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return "";
  value.remove_prefix(begin);
  return value.substr(0, value.find_last_not_of(" \t\r\n") + 1);
}

void ReadHeadLine(std::string_view line, HttpHead* head) {
  // An interim answer (100, 103) comes before the one that counts.
  if (line.substr(0, 5) == "HTTP/") *head = HttpHead();
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return;
  const std::string name = ToLowerAscii(line.substr(0, colon));
  for (const auto& [known, member] :
       {std::pair{"content-type", &HttpHead::content_type},
        std::pair{"retry-after", &HttpHead::retry_after}, std::pair{"date", &HttpHead::date},
        std::pair{"location", &HttpHead::location}}) {
    if (name == known) head->*member = TrimmedValue(line, colon);
  }
}

std::size_t OnHeadLine(char* data, std::size_t size, std::size_t count, void* user) {
  auto* received = static_cast<Received*>(user);
  received->head_bytes += size * count;
  if (received->head_bytes > kMaxHeadBytes) {
    received->too_large = true;
    return 0;
  }
  ReadHeadLine(std::string_view(data, size * count), &received->head);
  return size * count;
}

std::size_t OnBodyBytes(char* data, std::size_t size, std::size_t count, void* user) {
  auto* received = static_cast<Received*>(user);
  const std::size_t room = received->max_body_bytes - received->body_bytes;
  const std::size_t kept = std::min(room, size * count);
  received->body.append(data, kept);
  received->body_bytes += kept;
  received->too_large = kept < size * count;
  return kept;  // fewer than came: libcurl ends the transfer
}

HttpEnd EndOf(CURLcode code) {
  switch (code) {
    case CURLE_OK:
      return HttpEnd::kComplete;
    case CURLE_OPERATION_TIMEDOUT:  // only connecting has a time limit there
      return HttpEnd::kConnectTimeout;
    case CURLE_COULDNT_RESOLVE_HOST:
    case CURLE_COULDNT_RESOLVE_PROXY:
    case CURLE_COULDNT_CONNECT:
      return HttpEnd::kNoConnection;
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
    case CURLE_SSL_ISSUER_ERROR:
      return HttpEnd::kUntrusted;
    case CURLE_UNSUPPORTED_PROTOCOL:
    case CURLE_WEIRD_SERVER_REPLY:
    case CURLE_BAD_CONTENT_ENCODING:
      return HttpEnd::kNotHttp;
    case CURLE_OUT_OF_MEMORY:  // what libcurl says of a header line without end
      return HttpEnd::kTooLarge;
    default:
      return HttpEnd::kBroken;
  }
}

HeaderList MakeHeaders(const HttpRequest& request) {
  HeaderList headers;
  const auto add = [&](const std::string& line) {
    headers.reset(curl_slist_append(headers.release(), line.c_str()));
  };
  add("Accept: text/event-stream, application/json");
  // Without this libcurl waits for a 100 that some servers never send.
  add("Expect:");
  if (!request.body.empty()) add("Content-Type: application/json");
  if (!request.key.empty()) add("Authorization: Bearer " + request.key);
  return headers;
}

void SetOptions(const HttpRequest& request, curl_slist* headers, Received* received, char* error,
                CURL* easy) {
  curl_easy_setopt(easy, CURLOPT_URL, request.url.c_str());
  curl_easy_setopt(easy, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(easy, CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(easy, CURLOPT_HTTPHEADER, headers);
  curl_easy_setopt(easy, CURLOPT_USERAGENT, "latticeworld");
  if (!request.body.empty()) {
    curl_easy_setopt(easy, CURLOPT_POSTFIELDSIZE_LARGE,
                     static_cast<curl_off_t>(request.body.size()));
    curl_easy_setopt(easy, CURLOPT_POSTFIELDS, request.body.c_str());
  }
  if (!request.ca_file.empty()) curl_easy_setopt(easy, CURLOPT_CAINFO, request.ca_file.c_str());
  curl_easy_setopt(easy, CURLOPT_SSL_VERIFYPEER, 1L);
  curl_easy_setopt(easy, CURLOPT_SSL_VERIFYHOST, 2L);
  if (request.is_loopback) curl_easy_setopt(easy, CURLOPT_PROXY, "");
  curl_easy_setopt(easy, CURLOPT_SUPPRESS_CONNECT_HEADERS, 1L);
  curl_easy_setopt(easy, CURLOPT_NOSIGNAL, 1L);
  // A name server that hangs must not hold up the end of an interrupted exchange.
  curl_easy_setopt(easy, CURLOPT_QUICK_EXIT, 1L);
  curl_easy_setopt(easy, CURLOPT_TCP_KEEPALIVE, 1L);
  curl_easy_setopt(easy, CURLOPT_CONNECTTIMEOUT_MS,
                   std::max(1L, std::lround(request.connect_timeout_s * 1e3)));
  curl_easy_setopt(easy, CURLOPT_HEADERFUNCTION, OnHeadLine);
  curl_easy_setopt(easy, CURLOPT_HEADERDATA, received);
  curl_easy_setopt(easy, CURLOPT_WRITEFUNCTION, OnBodyBytes);
  curl_easy_setopt(easy, CURLOPT_WRITEDATA, received);
  curl_easy_setopt(easy, CURLOPT_ERRORBUFFER, error);
}

// Drives the transfer until it ends by itself or by the handler.
HttpEnd Drive(CURL* easy, CURLM* multi, Received* received, HttpHandler* handler) {
  for (int running = 1;;) {
    if (handler->Interrupted()) return HttpEnd::kInterrupted;
    if (curl_multi_perform(multi, &running) != CURLM_OK) return HttpEnd::kBroken;
    long status = 0;  // NOLINT: libcurl's type
    curl_easy_getinfo(easy, CURLINFO_RESPONSE_CODE, &status);
    received->head.status = static_cast<int>(status);
    if (!received->body.empty()) {
      if (!handler->OnBody(received->head, received->body)) return HttpEnd::kStopped;
      received->body.clear();
    }
    int left = 0;
    while (const CURLMsg* message = curl_multi_info_read(multi, &left)) {
      if (message->msg != CURLMSG_DONE) continue;
      if (received->too_large) return HttpEnd::kTooLarge;
      const HttpEnd end = EndOf(message->data.result);
      // libcurl lets a first line pass that has no status: "HTTP/200 ".
      return end == HttpEnd::kComplete && status == 0 ? HttpEnd::kNotHttp : end;
    }
    curl_multi_poll(multi, nullptr, 0, kLongestPollMs, nullptr);
  }
}

}  // namespace

HttpResult Exchange(const HttpRequest& request, HttpHandler* handler) {
  // libcurl's own state of the process; made once, by whoever comes first.
  static const CURLcode initialised = curl_global_init(CURL_GLOBAL_DEFAULT);
  const Easy easy(curl_easy_init());
  const Multi multi(curl_multi_init());
  if (initialised != CURLE_OK || easy == nullptr || multi == nullptr) {
    return {HttpEnd::kNoConnection, {}, "libcurl cannot be initialised"};
  }
  Received received;
  received.max_body_bytes = request.max_body_bytes;
  char error[CURL_ERROR_SIZE] = "";
  const HeaderList headers = MakeHeaders(request);
  SetOptions(request, headers.get(), &received, error, easy.get());
  curl_multi_add_handle(multi.get(), easy.get());
  const HttpEnd end = Drive(easy.get(), multi.get(), &received, handler);
  curl_multi_remove_handle(multi.get(), easy.get());
  const bool no_status = end == HttpEnd::kNotHttp && *error == '\0';
  return {end, std::move(received.head), no_status ? "its first line has no status" : error};
}

}  // namespace latticeworld
