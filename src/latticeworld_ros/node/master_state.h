#ifndef LATTICEWORLD_ROS_NODE_MASTER_STATE_H_
#define LATTICEWORLD_ROS_NODE_MASTER_STATE_H_

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace latticeworld {

// What the master knows: by topic or service the names of the nodes that publish, subscribe or
// offer it.
struct MasterState {
  using Nodes = std::map<std::string, std::vector<std::string>>;
  Nodes publishers, subscribers, services;
};
// payload: of the master's getSystemState. nullopt: it is none.
std::optional<MasterState> MasterStateFrom(XmlRpc::XmlRpcValue payload);

// What became of services that a node has offered.
struct ServiceStanding {
  struct Taken {
    std::string service, node;  // that the master sends callers to
  };
  std::vector<Taken> taken;
  std::vector<std::string> gone;  // the master knows nobody who offers them
};
ServiceStanding StandingOf(const MasterState& state, const std::string& node,
                           const std::vector<std::string>& services);

// Topics of a node of which the master does not know that it has them, as one that was started
// anew.
struct UnknownTopics {
  std::vector<std::string> advertised, subscribed;
};
UnknownTopics UnknownTo(const MasterState& state, const std::string& node,
                        const std::vector<std::string>& advertised,
                        const std::vector<std::string>& subscribed);

// Topics of a node that have more nodes at their other end than the node has connections for.
// Nodes that died without a word count, for the master knows them still. sent, heard: connections
// of a topic that the node publishes or subscribes to.
std::vector<std::string> TopicsNotDelivered(
    const MasterState& state, const std::string& node,
    const std::function<std::size_t(const std::string& topic)>& sent,
    const std::function<std::size_t(const std::string& topic)>& heard);
// Topics that a node publishes or subscribes to.
std::size_t CountTopics(const MasterState& state, const std::string& node);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NODE_MASTER_STATE_H_
