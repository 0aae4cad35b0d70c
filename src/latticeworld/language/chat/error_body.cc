#include "latticeworld/language/chat/error_body.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// Not ordered_json, which copies members, by recursion, as an object grows.
using Json = nlohmann::json;

constexpr std::size_t kMaxQuotedBytes = 600;

// A text as it is, a number in digits, else "".
std::string Plain(const Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end()) return "";
  if (found->is_string()) return found->get<std::string>();
  return found->is_number() ? found->dump() : "";
}

// 0: it is none.
int AsHttpStatus(const std::string& text) {
  int status = 0;
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, status);
  return read.ec == std::errc() && read.ptr == end && status >= 400 && status <= 599 ? status : 0;
}

ErrorBody FromJson(const Json& json, int depth);

// One violation as FastAPI writes it.
ErrorBody FromDetail(const Json& detail) {
  ErrorBody body;
  std::string where;
  if (const auto loc = detail.find("loc"); loc != detail.end() && loc->is_array()) {
    for (const Json& step : *loc) {
      // A place is told by names and numbers; what is built of more is nobody's, and may be deep.
      if (step.is_structured()) continue;
      body.param = step.is_string() ? step.get<std::string>() : step.dump();
      where += (where.empty() ? "" : ".") + body.param;
    }
  }
  body.message = (where.empty() ? "" : where + ": ") + Plain(detail, "msg");
  body.type = Plain(detail, "type");
  return body;
}

ErrorBody FromDetails(const Json& details) {
  ErrorBody all;
  for (const Json& detail : details) {
    const ErrorBody one = detail.is_object() ? FromDetail(detail) : FromJson(detail, 1);
    if (all.message.empty()) {
      all = one;
    } else {
      all.message += "; " + one.message;
    }
  }
  return all;
}

// The members of the object that describes the error.
ErrorBody FromMembers(const Json& json) {
  ErrorBody body{Plain(json, "message"), Plain(json, "type"), Plain(json, "code"),
                 Plain(json, "param"), 0};
  if (body.type.empty()) body.type = Plain(json, "error_type");
  for (const std::string& said : {body.code, Plain(json, "status"), body.type}) {
    if (body.http_status == 0) body.http_status = AsHttpStatus(said);
  }
  return body;
}

ErrorBody FromJson(const Json& json, int depth) {
  constexpr int kMaxDepth = 4;  // of errors that are wrapped in errors
  if (json.is_string()) return {json.get<std::string>(), "", "", "", 0};
  if (json.is_array() && !json.empty() && depth < kMaxDepth) {
    return FromJson(json.front(), depth + 1);
  }
  if (!json.is_object()) return {};
  ErrorBody body = FromMembers(json);
  for (const char* name : {"error", "detail"}) {
    const auto found = json.find(name);
    if (found == json.end() || found->is_null() || depth >= kMaxDepth) continue;
    ErrorBody inner = found->is_array() ? FromDetails(*found) : FromJson(*found, depth + 1);
    // What only the wrapping says is kept.
    if (inner.message.empty()) inner.message = std::move(body.message);
    if (inner.type.empty()) inner.type = std::move(body.type);
    if (inner.code.empty()) inner.code = std::move(body.code);
    if (inner.http_status == 0) inner.http_status = body.http_status;
    return inner;
  }
  return body;
}

bool IsKnownShape(const Json& json) {
  const Json* value = &json;
  while (value->is_array() && !value->empty()) value = &value->front();
  if (!value->is_object()) return value->is_string();
  for (const char* name : {"error", "detail", "message", "type", "code"}) {
    if (value->contains(name)) return true;
  }
  return false;
}

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return "";
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::string PageTitle(std::string_view page) {
  const std::string lower = ToLowerAscii(page);
  const std::size_t tag = lower.find("<title");
  const std::size_t begin = tag == std::string::npos ? tag : lower.find('>', tag);
  const std::size_t end = begin == std::string::npos ? begin : lower.find("</title", begin);
  if (end == std::string::npos) return "a page in HTML";
  return "a page in HTML titled " + std::string(Trimmed(page.substr(begin + 1, end - begin - 1)));
}

bool QuotaIsUsedUp(const ErrorBody& body) {
  for (const std::string_view said : {body.type, body.code}) {
    if (said == "insufficient_quota" || said == "billing_hard_limit_reached" ||
        said == "credit_balance_exhausted") {
      return true;
    }
  }
  return false;
}

StatusCode CodeOf(int http_status) {
  switch (http_status) {
    case 401:
    case 407:
      return StatusCode::kUnauthenticated;
    case 402:
    case 403:
      return StatusCode::kPermissionDenied;
    case 404:
    case 410:
      return StatusCode::kNotFound;
    case 408:
    case 504:
      return StatusCode::kDeadlineExceeded;
    case 429:
    case 502:
    case 503:
    case 529:
      return StatusCode::kUnavailable;
    default:
      return http_status >= 400 && http_status < 500 ? StatusCode::kInvalidArgument
                                                     : StatusCode::kInternal;
  }
}

}  // namespace

ErrorBody ParseErrorBody(std::string_view body) {
  body = Trimmed(body);
  if (body.empty()) return {};
  const Json json = Json::parse(body, nullptr, /*allow_exceptions=*/false);
  if (!json.is_discarded()) {
    ErrorBody parsed = FromJson(json, 0);
    // A shape that nobody has told us of still tells a person something.
    if (!IsKnownShape(json)) parsed.message = body;
    return parsed;
  }
  return {body.front() == '<' ? PageTitle(body) : std::string(body), "", "", "", 0};
}

Failure FailureOf(int http_status, const ErrorBody& body, const ApiKey& key) {
  std::string message = "HTTP " + std::to_string(http_status);
  // A code that is a number says no more than the status.
  const bool has_named_code = body.code.find_first_not_of("0123456789") != std::string::npos;
  const std::string kind = key.Scrub(has_named_code ? body.code : body.type);
  if (!kind.empty()) message += " (" + Quote(kind) + ")";
  message += body.message.empty() ? " without a message"
                                  : ": " + Quote(key.Scrub(body.message), kMaxQuotedBytes);
  const bool again = CodeOf(http_status) == StatusCode::kUnavailable && !QuotaIsUsedUp(body);
  return {Status(CodeOf(http_status), std::move(message)), again, std::nullopt};
}

int HttpStatusOf(const ErrorBody& body) {
  if (body.http_status != 0) return body.http_status;
  constexpr std::array<std::pair<std::string_view, int>, 13> kKnown = {
      {{"invalid_request_error", 400},
       {"BadRequestError", 400},
       {"exceed_context_size_error", 400},
       {"authentication_error", 401},
       {"permission_error", 403},
       {"not_found_error", 404},
       {"model_not_found", 404},
       {"insufficient_quota", 429},
       {"rate_limit_error", 429},
       {"rate_limit_exceeded", 429},
       {"overloaded_error", 503},
       {"unavailable_error", 503},
       {"overloaded", 503}}};
  for (const std::string_view said : {body.code, body.type}) {
    for (const auto& [name, status] : kKnown) {
      if (said == name) return status;
    }
  }
  return 500;
}

}  // namespace latticeworld
