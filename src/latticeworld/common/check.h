#ifndef LATTICEWORLD_COMMON_CHECK_H_
#define LATTICEWORLD_COMMON_CHECK_H_

#include <string_view>

namespace latticeworld::internal {

[[noreturn]] void CheckFailed(const char* file, int line, const char* condition,
                              std::string_view message);

}  // namespace latticeworld::internal

// Ends the program when `condition` is false: for bugs only, never for what comes from outside.
#define LW_CHECK(condition, message)                                                    \
  do {                                                                                  \
    if (!(condition))                                                                   \
      ::latticeworld::internal::CheckFailed(__FILE__, __LINE__, #condition, (message)); \
  } while (false)

#endif  // LATTICEWORLD_COMMON_CHECK_H_
