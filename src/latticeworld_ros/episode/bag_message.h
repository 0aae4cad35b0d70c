#ifndef LATTICEWORLD_ROS_EPISODE_BAG_MESSAGE_H_
#define LATTICEWORLD_ROS_EPISODE_BAG_MESSAGE_H_

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/this_node.h>

#include <boost/make_shared.hpp>
#include <exception>
#include <string>
#include <vector>

#include "latticeworld_ros/episode/bag_file.h"

namespace latticeworld {

// A message of a known type as one of any type. latched: who plays it latches it.
template <typename Message>
BagMessage ToBag(const std::string& topic, ros::Time time, const Message& message,
                 bool latched = false) {
  namespace traits = ros::message_traits;
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, message);
  auto shaped = boost::make_shared<topic_tools::ShapeShifter>();
  shaped->morph(traits::MD5Sum<Message>::value(), traits::DataType<Message>::value(),
                traits::Definition<Message>::value(), "");
  ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  shaped->read(in);
  auto header = boost::make_shared<ros::M_string>();
  (*header)["callerid"] = ros::this_node::getName();
  (*header)["latching"] = latched ? "1" : "0";
  (*header)["md5sum"] = traits::MD5Sum<Message>::value();
  (*header)["message_definition"] = traits::Definition<Message>::value();
  (*header)["topic"] = topic;
  (*header)["type"] = traits::DataType<Message>::value();
  return {topic, time, shaped, header};
}

// The message where it is of that type, else null.
template <typename Message>
boost::shared_ptr<Message> FromBag(const BagMessage& message) {
  try {
    return message.message->instantiate<Message>();
  } catch (const std::exception&) {  // topic_tools', of another type or cut short
    return nullptr;
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_BAG_MESSAGE_H_
