#ifndef LATTICEWORLD_ROS_NODE_GUARDED_H_
#define LATTICEWORLD_ROS_NODE_GUARDED_H_

#include <exception>
#include <optional>
#include <string>
#include <utility>

namespace latticeworld {

// Calls `call`. What its exception says; nothing: it threw none. For threads that have to go on,
// whatever what they call does.
template <typename F>
std::optional<std::string> ExceptionOf(F&& call) {
  try {
    std::forward<F>(call)();
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception that says nothing";
  }
  return std::nullopt;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_GUARDED_H_
