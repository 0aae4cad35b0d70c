#include "latticeworld_ros/publishing/journal_publisher.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/journaled_simulator.h"
#include "latticeworld_ros/conversion/journal_conversion.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {
namespace {

// Calls of a second of a hundred robots that are commanded in every step.
constexpr std::uint32_t kJournalQueue = 10000;
constexpr std::uint32_t kHashQueue = 1000;

JournaledSimulator* JournalOf(const Tick& tick) {
  return dynamic_cast<JournaledSimulator*>(tick.simulator);
}

}  // namespace

JournalPublisher::JournalPublisher(ros::NodeHandle node, double hash_rate_hz, double step_s)
    : steps_per_hash_(hash_rate_hz == 0.0 ? 0
                                          : static_cast<std::uint64_t>(std::max(
                                                1L, std::lround(1.0 / (hash_rate_hz * step_s))))),
      journal_(node.advertise<latticeworld_msgs::JournalEntry>("world/journal", kJournalQueue)),
      hash_(node.advertise<latticeworld_msgs::StateHash>("world/state_hash", kHashQueue)) {}

bool JournalPublisher::IsHashDue(const Tick& tick) const {
  const JournaledSimulator* simulator = JournalOf(tick);
  if (simulator == nullptr || hash_.getNumSubscribers() == 0) return false;
  if (tick.settled || simulator->run() != run_) return true;
  return steps_per_hash_ != 0 && simulator->steps() >= last_hash_step_ + steps_per_hash_;
}

bool JournalPublisher::IsDue(const Tick& tick) const {
  const JournaledSimulator* simulator = JournalOf(tick);
  return simulator != nullptr && (simulator->has_new() || IsHashDue(tick));
}

void JournalPublisher::Publish(const Tick& tick) {
  JournaledSimulator* simulator = JournalOf(tick);
  if (simulator == nullptr) return;
  const std::string world_id = tick.world_id();
  for (const JournalEntry& entry : simulator->TakeNew()) {
    journal_.publish(ToJournalEntryMessage(entry, tick.now, world_id, simulator->run()));
  }
  if (!IsHashDue(tick)) return;
  latticeworld_msgs::StateHash message;
  message.header.stamp = tick.now;
  message.header.frame_id = "map";
  message.world_id = world_id;
  message.run = run_ = simulator->run();
  message.calls = simulator->last_number();
  message.step = last_hash_step_ = simulator->steps();
  message.episode_step = simulator->State()->episode_step;
  message.state_hash = simulator->StateHash();
  hash_.publish(message);
}

}  // namespace latticeworld
