#ifndef LATTICEWORLD_ROS_PUBLISHING_HEARD_PUBLISHER_H_
#define LATTICEWORLD_ROS_PUBLISHING_HEARD_PUBLISHER_H_

#include <ros/poll_manager.h>
#include <ros/publication.h>
#include <ros/publisher.h>
#include <ros/serialization.h>
#include <ros/topic_manager.h>

#include <utility>

namespace latticeworld {

// While one lives, what the HeardPublishers of its thread publish waits for its end, and then
// roscpp's thread is woken once for all of it: every time it wakes it goes through all topics.
class PublishBatch {
 public:
  PublishBatch() : outer_(current_) { current_ = this; }
  ~PublishBatch() {
    current_ = outer_;
    if (has_messages_) Wake();
  }
  PublishBatch(const PublishBatch&) = delete;
  PublishBatch& operator=(const PublishBatch&) = delete;

  // Has what was published sent: now, or with the batch of this thread.
  static void Wake() {
    if (current_ != nullptr) {
      current_->has_messages_ = true;
    } else {
      ros::PollManager::instance()->getPollSet().signal();
    }
  }

 private:
  inline static thread_local PublishBatch* current_ = nullptr;
  PublishBatch* const outer_;  // that this one is within; nullptr: none
  bool has_messages_ = false;
};

// A publisher that knows at once how many listen, and hands its messages straight to its topic.
// roscpp itself searches its list of all topics for the name in every such question and with every
// message, under a lock that its own thread holds while it walks over all of them: with a thousand
// topics of a hundred robots whoever publishes would wait longer than a step takes. For messages
// that are made for one publication; never latched.
class HeardPublisher {
 public:
  HeardPublisher() = default;  // publishes nothing
  // Searches a list: it is not for hundreds of publishers a second.
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
    if (IsHeard()) Send(make());
  }

 private:
  template <typename Message>
  void Send(const Message& message) const {
    ros::SerializedMessage bytes = ros::serialization::serializeMessage(message);
    publication_->publish(bytes);
    PublishBatch::Wake();
  }

  ros::Publisher publisher_;
  ros::PublicationPtr publication_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_HEARD_PUBLISHER_H_
