#include "latticeworld_ros/episode/server_watch.h"

#include <utility>

namespace latticeworld {

ServerWatch::ServerWatch(Look look) : look_(std::move(look)), first_(look_()) {}

bool ServerWatch::IsSame() {
  if (replaced_) return false;
  const std::string now = look_();
  if (!now.empty() && now != first_) replaced_ = true;
  return !replaced_;
}

bool ServerWatch::Close() {
  closed_ = true;
  return IsSame();
}

bool ServerWatch::Accepts(const BagMessage& message) {
  if (replaced_) return false;
  if (message.header == nullptr || !connections_.insert(message.header).second) return true;
  return !closed_ || IsSame();
}

}  // namespace latticeworld
