#include "latticeworld_ros/node/master_watch.h"

#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/publication.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "latticeworld_ros/node/node_listening.h"

namespace latticeworld {
namespace {

constexpr std::chrono::seconds kPeriod(3);

std::optional<MasterState> AskMaster() {
  XmlRpc::XmlRpcValue arguments, response, payload;
  arguments[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", arguments, response, payload, false)) {
    return std::nullopt;
  }
  return MasterStateFrom(payload);
}

// Whether a node that the master knows was killed: nobody listens where it says that it is.
bool WasKilled(const std::string& node) {
  XmlRpc::XmlRpcValue arguments, response, payload;
  arguments[0] = ros::this_node::getName();
  arguments[1] = node;
  if (!ros::master::execute("lookupNode", arguments, response, payload, false)) return false;
  if (payload.getType() != XmlRpc::XmlRpcValue::TypeString) return false;
  return NobodyListensAt(payload, ros::network::getHost());
}

// Tells the master, as roscpp did first, that this node offers a service.
void Announce(const std::string& service) {
  if (ros::isShuttingDown()) return;
  const std::string uri = "rosrpc://" + ros::network::getHost() + ":" +
                          std::to_string(ros::ConnectionManager::instance()->getTCPPort());
  XmlRpc::XmlRpcValue arguments, response, payload;
  arguments[0] = ros::this_node::getName();
  arguments[1] = service;
  arguments[2] = uri;
  arguments[3] = ros::XMLRPCManager::instance()->getServerURI();
  if (!ros::master::execute("registerService", arguments, response, payload, false)) return;
  ROS_INFO_STREAM("nobody offers " << service << " any more; it is announced again");
  if (!ros::isShuttingDown()) return;
  // The node took leave meanwhile.
  XmlRpc::XmlRpcValue leave;
  leave[0] = ros::this_node::getName();
  leave[1] = service;
  leave[2] = uri;
  (void)ros::master::execute("unregisterService", leave, response, payload, false);
}

// Calls the master with this node's name, a topic, further arguments and this node's address.
bool TellMaster(const char* call, std::vector<std::string> arguments,
                XmlRpc::XmlRpcValue* answer = nullptr) {
  XmlRpc::XmlRpcValue sent, response, payload;
  arguments.insert(arguments.begin(), ros::this_node::getName());
  arguments.push_back(ros::XMLRPCManager::instance()->getServerURI());
  for (std::size_t i = 0; i < arguments.size(); ++i) sent[static_cast<int>(i)] = arguments[i];
  const bool done = ros::master::execute(call, sent, response, payload, false);
  if (answer != nullptr) *answer = payload;
  return done;
}

void AnnouncePublisher(const std::string& topic) {
  const ros::TopicManagerPtr topics = ros::TopicManager::instance();
  const ros::PublicationPtr publication = topics->lookupPublication(topic);
  if (publication == nullptr || ros::isShuttingDown()) return;
  if (!TellMaster("registerPublisher", {topic, publication->getDataType()})) return;
  // It was given up meanwhile.
  if (topics->lookupPublication(topic) == nullptr) TellMaster("unregisterPublisher", {topic});
}

// Has the master send what it learns of a topic's publishers, and gives roscpp those that it knows,
// as the master itself would.
void AnnounceSubscriber(const std::string& topic) {
  XmlRpc::XmlRpcValue publishers;
  if (ros::isShuttingDown() || !TellMaster("registerSubscriber", {topic, "*"}, &publishers)) return;
  std::vector<std::string> subscribed;
  ros::TopicManager::instance()->getSubscribedTopics(subscribed);
  if (std::find(subscribed.begin(), subscribed.end(), topic) == subscribed.end()) {
    TellMaster("unregisterSubscriber", {topic});  // it was given up meanwhile
    return;
  }
  if (publishers.getType() != XmlRpc::XmlRpcValue::TypeArray || publishers.size() == 0) return;
  const ros::XMLRPCManagerPtr manager = ros::XMLRPCManager::instance();
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(manager->getServerURI(), host, port)) return;
  XmlRpc::XmlRpcClient* self = manager->getXMLRPCClient(host, static_cast<int>(port), "/");
  if (self == nullptr) return;
  XmlRpc::XmlRpcValue arguments, response;
  arguments[0] = "/master";
  arguments[1] = topic;
  arguments[2] = publishers;
  (void)self->execute("publisherUpdate", arguments, response);
  manager->releaseXMLRPCClient(self);
}

std::vector<std::string> InBoth(std::vector<std::string> a, std::vector<std::string> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  std::vector<std::string> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

}  // namespace

MasterWatch::~MasterWatch() { Stop(); }

void MasterWatch::Start(std::vector<std::string> services) {
  services_ = std::move(services);
  report_.descriptors = CountDescriptors();
  thread_ = std::thread([this] { Run(); });
}

void MasterWatch::Stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

MasterReport MasterWatch::report() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return report_;
}

void MasterWatch::Run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!changed_.wait_for(lock, kPeriod, [this] { return stopping_; })) {
    lock.unlock();
    Look();
    lock.lock();
  }
}

void MasterWatch::Look() {
  MasterReport report;
  report.descriptors = CountDescriptors();
  // Before the master is asked: what is new since then it need not know yet.
  std::vector<std::string> advertised, subscribed;
  ros::TopicManager::instance()->getAdvertisedTopics(advertised);
  ros::TopicManager::instance()->getSubscribedTopics(subscribed);
  const std::optional<MasterState> state = AskMaster();
  if (!state) {
    // Asking takes a descriptor itself: that there is none has to be told all the same.
    const std::lock_guard<std::mutex> lock(mutex_);
    report_.descriptors = report.descriptors;
    return;
  }
  const std::string node = ros::this_node::getName();
  report.topics = CountTopics(*state, node);
  // roscpp searches a list for each topic that is asked for.
  std::vector<std::string> missing;
  if (report.descriptors.is_short()) {
    const ros::TopicManagerPtr topics = ros::TopicManager::instance();
    missing = TopicsNotDelivered(
        *state, node, [&](const std::string& topic) { return topics->getNumSubscribers(topic); },
        [&](const std::string& topic) { return topics->getNumPublishers(topic); });
    if (!short_told_) {
      ROS_WARN_STREAM(report.descriptors.open << " of " << report.descriptors.limit
                                              << " file descriptors are in use: topics are not "
                                                 "delivered (diagnostics name them); raise the "
                                                 "hard limit, ulimit -Hn");
    }
  }
  short_told_ = report.descriptors.is_short();
  // Connections take a while to stand: what misses one twice in a row has none.
  report.not_delivered = InBoth(missing, unsure_);
  unsure_ = std::move(missing);
  ServiceStanding standing = StandingOf(*state, node, services_);
  for (const std::string& service : standing.gone) Announce(service);
  AnnounceTopics(UnknownTo(*state, node, advertised, subscribed));
  const auto killed =
      std::partition(standing.taken.begin(), standing.taken.end(),
                     [](const ServiceStanding::Taken& taken) { return !WasKilled(taken.node); });
  for (auto taken = killed; taken != standing.taken.end(); ++taken) Announce(taken->service);
  standing.taken.erase(killed, standing.taken.end());
  WarnOfTaken(standing.taken);
  report.services = std::move(standing.taken);
  const std::lock_guard<std::mutex> lock(mutex_);
  report_ = std::move(report);
}

void MasterWatch::AnnounceTopics(UnknownTopics unknown) {
  if (!unknown.advertised.empty()) {
    ROS_INFO_STREAM("the master does not know " << unknown.advertised.size()
                                                << " topics of this node; they are announced");
  }
  for (const std::string& topic : unknown.advertised) AnnouncePublisher(topic);
  for (const std::string& topic : InBoth(unknown.subscribed, unheard_)) AnnounceSubscriber(topic);
  unheard_ = std::move(unknown.subscribed);
}

void MasterWatch::WarnOfTaken(const std::vector<ServiceStanding::Taken>& taken) {
  std::vector<std::string> told;
  for (const ServiceStanding::Taken& one : taken) {
    told.push_back(one.service);
    if (std::find(told_.begin(), told_.end(), one.service) != told_.end()) continue;
    ROS_WARN_STREAM(one.node << " has taken the service " << one.service
                             << ": calls go there; remap it in one of the two nodes");
  }
  told_ = std::move(told);
}

}  // namespace latticeworld
