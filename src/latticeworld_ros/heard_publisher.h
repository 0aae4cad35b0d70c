#ifndef LATTICEWORLD_ROS_HEARD_PUBLISHER_H_
#define LATTICEWORLD_ROS_HEARD_PUBLISHER_H_

#include <ros/publication.h>
#include <ros/publisher.h>
#include <ros/topic_manager.h>

#include <utility>

namespace latticeworld {

// A publisher that knows at once how many listen. roscpp itself searches its list of all topics for
// the name in every such question and with every message, which hundreds of robots' topics that
// nobody hears would pay for many times a second.
class HeardPublisher {
 public:
  HeardPublisher() = default;  // publishes nothing
  // Not of hundreds a second: this searches the list.
  explicit HeardPublisher(ros::Publisher publisher)
      : publisher_(std::move(publisher)),
        publication_(ros::TopicManager::instance()->lookupPublication(publisher_.getTopic())) {}

  explicit operator bool() const { return publication_ != nullptr; }
  bool IsHeard() const { return publication_ != nullptr && publication_->hasSubscribers(); }
  int listeners() const {
    return publication_ == nullptr ? 0 : static_cast<int>(publication_->getNumSubscribers());
  }
  // Publishes what make() answers, which nobody makes for nobody.
  template <typename Make>
  void Publish(const Make& make) const {
    if (IsHeard()) publisher_.publish(make());
  }

 private:
  ros::Publisher publisher_;
  ros::PublicationPtr publication_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_HEARD_PUBLISHER_H_
