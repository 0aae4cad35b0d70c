#ifndef LATTICEWORLD_ROS_NODE_NODE_LISTENING_H_
#define LATTICEWORLD_ROS_NODE_NODE_LISTENING_H_

#include <string>

namespace latticeworld {

// Whether it is certain that no process listens at the address of a node any more: a connection to
// it is refused. That is so on the machine of a node that was killed, which the master takes for
// alive. False in all doubt: no answer within half a second, a URI that is none, or a host that is
// neither own_host nor an IPv4 address in digits (names are not looked up, for that can take long).
// uri: of the node's own server as the master knows it, "http://HOST:PORT/".
bool NobodyListensAt(const std::string& uri, const std::string& own_host);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_NODE_LISTENING_H_
