#ifndef LATTICEWORLD_COMMON_RESULT_H_
#define LATTICEWORLD_COMMON_RESULT_H_

#include <optional>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/status.h"

namespace latticeworld {

// A value, or the Status that says why there is none. What a temporary Result holds is handed out
// by value, so that `for (auto& x : *F())` walks over something that lives as long as the loop.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}         // NOLINT: implicit by design
  Result(Status status) : status_(std::move(status)) {  // NOLINT: implicit by design
    LW_CHECK(!status_.ok(), "a Result without a value needs a failed Status");
  }

  bool ok() const { return value_.has_value(); }
  const Status& status() const { return status_; }

  const T& value() const& { return Checked(), *value_; }
  T& value() & { return Checked(), *value_; }
  T value() && { return Checked(), *std::move(value_); }

  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

 private:
  void Checked() const { LW_CHECK(ok(), "value of a failed Result: " + status_.ToString()); }

  std::optional<T> value_;
  Status status_;
};

}  // namespace latticeworld

// Leaves the function with the failure of `expression` (a Status).
#define LW_RETURN_IF_ERROR(expression)                                                      \
  do {                                                                                      \
    if (::latticeworld::Status lw_status = (expression); !lw_status.ok()) return lw_status; \
  } while (false)

#define LW_CONCAT_INNER(a, b) a##b
#define LW_CONCAT(a, b) LW_CONCAT_INNER(a, b)

// LW_ASSIGN_OR_RETURN(auto layout, ParseLayout(text, vocabulary));
#define LW_ASSIGN_OR_RETURN(declaration, expression) \
  LW_ASSIGN_OR_RETURN_IMPL(LW_CONCAT(lw_result_, __LINE__), declaration, expression)
#define LW_ASSIGN_OR_RETURN_IMPL(result, declaration, expression) \
  auto result = (expression);                                     \
  if (!result.ok()) return result.status();                       \
  declaration = std::move(result).value()

#endif  // LATTICEWORLD_COMMON_RESULT_H_
