#include "latticeworld/common/status.h"

#include <algorithm>
#include <utility>

namespace latticeworld {

std::string_view ToString(StatusCode code) {
  switch (code) {
    case StatusCode::kOk:
      return "OK";
    case StatusCode::kCancelled:
      return "CANCELLED";
    case StatusCode::kUnknown:
      return "UNKNOWN";
    case StatusCode::kInvalidArgument:
      return "INVALID_ARGUMENT";
    case StatusCode::kDeadlineExceeded:
      return "DEADLINE_EXCEEDED";
    case StatusCode::kNotFound:
      return "NOT_FOUND";
    case StatusCode::kAlreadyExists:
      return "ALREADY_EXISTS";
    case StatusCode::kPermissionDenied:
      return "PERMISSION_DENIED";
    case StatusCode::kResourceExhausted:
      return "RESOURCE_EXHAUSTED";
    case StatusCode::kFailedPrecondition:
      return "FAILED_PRECONDITION";
    case StatusCode::kAborted:
      return "ABORTED";
    case StatusCode::kOutOfRange:
      return "OUT_OF_RANGE";
    case StatusCode::kUnimplemented:
      return "UNIMPLEMENTED";
    case StatusCode::kInternal:
      return "INTERNAL";
    case StatusCode::kUnavailable:
      return "UNAVAILABLE";
    case StatusCode::kDataLoss:
      return "DATA_LOSS";
    case StatusCode::kUnauthenticated:
      return "UNAUTHENTICATED";
  }
  return "UNKNOWN";
}

Status::Status(StatusCode code, std::string message, std::vector<Violation> violations)
    : code_(code), message_(std::move(message)), violations_(std::move(violations)) {}

Status Status::FromViolations(std::string_view what, std::vector<Violation> violations) {
  if (violations.empty()) return Status();
  std::string message(what);
  message +=
      violations.size() == 1 ? ": " : " (" + std::to_string(violations.size()) + " violations): ";
  const std::size_t told = std::min<std::size_t>(violations.size(), kViolationsTold);
  for (std::size_t i = 0; i < told; ++i) {
    if (i > 0) message += "; ";
    if (!violations[i].pointer.empty()) message += violations[i].pointer + ": ";
    message += violations[i].message;
  }
  if (told < violations.size()) {
    message += "; and " + std::to_string(violations.size() - told) + " more";
  }
  return Status(StatusCode::kInvalidArgument, std::move(message), std::move(violations));
}

Status Status::WithContext(std::string_view context) const {
  if (ok()) return *this;
  return Status(code_, std::string(context) + ": " + message_, violations_);
}

std::string Status::ToString() const {
  std::string text(latticeworld::ToString(code_));
  if (!message_.empty()) text += ": " + message_;
  return text;
}

Status InvalidArgument(std::string message) {
  return Status(StatusCode::kInvalidArgument, std::move(message));
}
Status NotFound(std::string message) { return Status(StatusCode::kNotFound, std::move(message)); }
Status PermissionDenied(std::string message) {
  return Status(StatusCode::kPermissionDenied, std::move(message));
}
Status FailedPrecondition(std::string message) {
  return Status(StatusCode::kFailedPrecondition, std::move(message));
}
Status ResourceExhausted(std::string message) {
  return Status(StatusCode::kResourceExhausted, std::move(message));
}
Status Unavailable(std::string message) {
  return Status(StatusCode::kUnavailable, std::move(message));
}
Status DataLoss(std::string message) { return Status(StatusCode::kDataLoss, std::move(message)); }
Status Cancelled(std::string message) { return Status(StatusCode::kCancelled, std::move(message)); }
Status Internal(std::string message) { return Status(StatusCode::kInternal, std::move(message)); }

}  // namespace latticeworld
