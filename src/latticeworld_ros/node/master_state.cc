#include "latticeworld_ros/node/master_state.h"

#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <array>

namespace latticeworld {
namespace {

using Names = std::vector<std::string>;

bool Contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Those of a node's topics under which it is not listed.
Names WithoutNode(const MasterState::Nodes& listed, const std::string& node, const Names& topics) {
  Names missing;
  for (const std::string& topic : topics) {
    const auto found = listed.find(topic);
    if (found == listed.end() || !Contains(found->second, node)) missing.push_back(topic);
  }
  return missing;
}

// Nodes of a topic other than this one.
std::size_t OthersOf(const MasterState::Nodes& nodes, const std::string& topic,
                     const std::string& node) {
  const auto found = nodes.find(topic);
  if (found == nodes.end()) return 0;
  return found->second.size() -
         static_cast<std::size_t>(std::count(found->second.begin(), found->second.end(), node));
}

}  // namespace

std::optional<MasterState> MasterStateFrom(XmlRpc::XmlRpcValue payload) {
  MasterState state;
  try {
    const std::array<MasterState::Nodes*, 3> parts = {&state.publishers, &state.subscribers,
                                                      &state.services};
    if (payload.size() != static_cast<int>(parts.size())) return std::nullopt;
    for (int part = 0; part < payload.size(); ++part) {
      for (int i = 0; i < payload[part].size(); ++i) {
        XmlRpc::XmlRpcValue& entry = payload[part][i];
        Names& nodes = (*parts[static_cast<std::size_t>(part)])[static_cast<std::string>(entry[0])];
        for (int j = 0; j < entry[1].size(); ++j) {
          nodes.push_back(static_cast<std::string>(entry[1][j]));
        }
      }
    }
  } catch (const XmlRpc::XmlRpcException&) {  // of another type than it should be
    return std::nullopt;
  }
  return state;
}

ServiceStanding StandingOf(const MasterState& state, const std::string& node,
                           const Names& services) {
  ServiceStanding standing;
  for (const std::string& service : services) {
    const auto found = state.services.find(service);
    if (found == state.services.end() || found->second.empty()) {
      standing.gone.push_back(service);
    } else if (!Contains(found->second, node)) {
      standing.taken.push_back({service, found->second.front()});
    }
  }
  return standing;
}

UnknownTopics UnknownTo(const MasterState& state, const std::string& node, const Names& advertised,
                        const Names& subscribed) {
  return {WithoutNode(state.publishers, node, advertised),
          WithoutNode(state.subscribers, node, subscribed)};
}

Names TopicsNotDelivered(const MasterState& state, const std::string& node,
                         const std::function<std::size_t(const std::string& topic)>& sent,
                         const std::function<std::size_t(const std::string& topic)>& heard) {
  Names topics;
  for (const auto& [topic, nodes] : state.publishers) {
    if (!Contains(nodes, node)) continue;
    const std::size_t wanted = OthersOf(state.subscribers, topic, node);
    if (wanted > 0 && sent(topic) < wanted) topics.push_back(topic);
  }
  for (const auto& [topic, nodes] : state.subscribers) {
    if (!Contains(nodes, node)) continue;
    const std::size_t wanted = OthersOf(state.publishers, topic, node);
    if (wanted > 0 && heard(topic) < wanted) topics.push_back(topic);
  }
  return topics;
}

std::size_t CountTopics(const MasterState& state, const std::string& node) {
  std::size_t count = 0;
  for (const MasterState::Nodes* part : {&state.publishers, &state.subscribers}) {
    count += static_cast<std::size_t>(
        std::count_if(part->begin(), part->end(),
                      [&node](const auto& entry) { return Contains(entry.second, node); }));
  }
  return count;
}

}  // namespace latticeworld
