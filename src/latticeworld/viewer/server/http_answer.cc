#include "latticeworld/viewer/server/http_answer.h"

#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/viewer/payloads/json_parts.h"

namespace latticeworld {
namespace {

constexpr char kRevalidate[] = "no-cache";
constexpr char kForEver[] = "public, max-age=31536000, immutable";
constexpr char kNever[] = "no-store";

int HttpStatusOf(StatusCode code) {
  switch (code) {
    case StatusCode::kOk:
      return 200;
    case StatusCode::kInvalidArgument:
      return 400;
    case StatusCode::kUnauthenticated:
      return 401;
    case StatusCode::kPermissionDenied:
      return 403;
    case StatusCode::kNotFound:
      return 404;
    case StatusCode::kUnimplemented:
      return 405;
    case StatusCode::kOutOfRange:
      return 431;
    case StatusCode::kResourceExhausted:
    case StatusCode::kUnavailable:
      return 503;
    default:
      return 500;
  }
}

// Whether one of the tags of If-None-Match is this one (RFC 9110, 13.1.2: a weak comparison).
bool Matches(const std::string& if_none_match, const std::string& etag) {
  return if_none_match == "*" || if_none_match.find(etag) != std::string::npos;
}

// Whether gzip is named and not refused by a quality of 0.
bool TakesGzip(const std::string& accept_encoding) {
  for (const std::string& entry : Split(ToLowerAscii(accept_encoding), ',')) {
    const std::size_t begin = entry.find_first_not_of(" \t");
    if (begin == std::string::npos || entry.compare(begin, 4, "gzip") != 0) continue;
    const std::size_t quality = entry.find("q=");
    return quality == std::string::npos ||
           entry.find_first_of("123456789", quality) != std::string::npos;
  }
  return false;
}

HttpAnswer AnswerPayload(const HttpQuestion& question, const Payload& payload,
                         std::shared_ptr<const void> keeper, const char* cache_control) {
  HttpAnswer answer;
  answer.etag = payload.etag;
  answer.cache_control = cache_control;
  answer.content_type = payload.content_type;
  if (Matches(question.if_none_match, payload.etag)) {
    answer.status = 304;
    return answer;
  }
  answer.is_gzip = !payload.gzip.empty() && TakesGzip(question.accept_encoding);
  answer.body = answer.is_gzip ? payload.gzip : payload.bytes;
  answer.keeper = std::move(keeper);
  return answer;
}

}  // namespace

HttpAnswer HttpError(const Status& status) {
  HttpAnswer answer;
  answer.status = HttpStatusOf(status.code());
  answer.content_type = "application/json";
  answer.cache_control = kNever;
  answer.text = std::make_shared<const std::string>(
      Dump({{"code", ToString(status.code())}, {"message", status.message()}}) + "\n");
  answer.body = *answer.text;
  return answer;
}

HttpAnswer AnswerHttp(const HttpQuestion& question, const std::shared_ptr<const PayloadMap>& page,
                      const std::shared_ptr<const WorldPayloads>& world) {
  if (question.method != "GET" && question.method != "HEAD") {
    return HttpError(Status(StatusCode::kUnimplemented, "the method is " + Quote(question.method) +
                                                            "; legal are GET and HEAD"));
  }
  const std::string path = question.target.substr(0, question.target.find('?'));
  if (path == "/api/world.json") {
    if (world == nullptr) return HttpError(NotFound("no world is running"));
    return AnswerPayload(question, world->description, world, kRevalidate);
  }
  if (world != nullptr) {
    const auto file = world->files.find(path);
    if (file != world->files.end()) return AnswerPayload(question, file->second, world, kForEver);
  }
  const auto file = page->find(path);
  if (file != page->end()) return AnswerPayload(question, file->second, page, kRevalidate);
  return HttpError(NotFound("there is no " + Quote(path) +
                            "; docs/viewer.md has the paths, /api/world.json those of the world"));
}

}  // namespace latticeworld
