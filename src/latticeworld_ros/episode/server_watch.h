#ifndef LATTICEWORLD_ROS_EPISODE_SERVER_WATCH_H_
#define LATTICEWORLD_ROS_EPISODE_SERVER_WATCH_H_

#include <atomic>
#include <functional>
#include <set>
#include <string>

#include "latticeworld_ros/episode/bag_file.h"

namespace latticeworld {

// Why an episode ends whose server has been replaced.
inline constexpr char kAnotherServer[] =
    "another world_server has taken the place of the one that was recorded";

// Whether the world_server that an episode records is still the one that it began with. One that
// starts again counts its runs anew and may make the same world, so that what it publishes does not
// tell it from the one before; where it is called does. A server that has ended, with none in its
// place, counts as the first one still: nothing of another one can be heard.
class ServerWatch {
 public:
  using Look = std::function<std::string()>;

  // look: where the server is called now, empty where nobody knows; thread safe. The one that is
  // there now is the first.
  explicit ServerWatch(Look look);

  // Looks. Thread safe.
  bool IsSame();
  // Looks, from now on, at every connection that was not heard of before. What was heard until then
  // is of the first server if this returns true.
  bool Close();
  // False: the first server has been replaced, and messages are no part of the episode any more.
  // Looks with the first message of every new connection: a server is known to the master before it
  // publishes. Only one thread may call it.
  bool Accepts(const BagMessage& message);

 private:
  const Look look_;
  const std::string first_;
  std::atomic<bool> replaced_{false}, closed_{false};
  // What identifies connections; kept alive, so that no address comes twice.
  std::set<boost::shared_ptr<ros::M_string>> connections_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_SERVER_WATCH_H_
