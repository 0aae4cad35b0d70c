#include "latticeworld_ros/episode/episode_reader.h"

#include <rosbag/view.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "latticeworld/episode/replay_plan.h"
#include "latticeworld_ros/conversion/journal_conversion.h"
#include "latticeworld_ros/episode/bag_check.h"
#include "latticeworld_ros/episode/episode_record_builder.h"
#include "latticeworld_ros/episode/episode_recording.h"
#include "latticeworld_ros/episode/lz4_frame.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;
using latticeworld_msgs::AgentEvent;
using latticeworld_msgs::AgentStates;
using latticeworld_msgs::EpisodeEnd;
using latticeworld_msgs::EpisodeStart;
using latticeworld_msgs::StateHash;
using latticeworld_msgs::WorldFiles;
using JournalMessage = latticeworld_msgs::JournalEntry;

template <typename Message>
std::string TypeName() {
  return ros::message_traits::DataType<Message>::value();
}

// Every message of a type from a time on, whatever its topic; `use` answers whether to go on.
// Errors: FAILED_PRECONDITION where the bag knows the type by another definition.
template <typename Message, typename Use>
Status ForEach(const rosbag::Bag& bag, const Use& use, const ros::Time& from = ros::TIME_MIN) {
  rosbag::View view(bag, rosbag::TypeQuery(TypeName<Message>()), from);
  for (const rosbag::MessageInstance& instance : view) {
    const auto message = instance.instantiate<Message>();
    if (message == nullptr) {
      return FailedPrecondition("was recorded by another version: its " + TypeName<Message>() +
                                " on " + instance.getTopic() + " is of MD5 sum " +
                                instance.getMD5Sum() + ", and this one's is " +
                                ros::message_traits::MD5Sum<Message>::value());
    }
    if (!use(*message, instance)) break;
  }
  return Status();
}

// When the last message of a type was recorded, by the bag's index alone.
template <typename Message>
ros::Time LastTime(const rosbag::Bag& bag) {
  rosbag::View view(bag, rosbag::TypeQuery(TypeName<Message>()));
  return view.size() == 0 ? ros::TIME_MAX : view.getEndTime();
}

// Why a bag cannot be read. what: as rosbag or the reading of a message says it.
Status Unreadable(const std::string& bag, const char* what) {
  if (!HasForeignLz4Frame(bag)) return DataLoss(bag + " is no rosbag, or damaged: " + what);
  return FailedPrecondition(
      bag +
      " is compressed in LZ4 frames that rosbag cannot read, as the PyPI package rosbags "
      "writes them; rosbags-convert --src " +
      bag + " --dst OTHER.bag writes it without compression");
}

// What rosbag and the reading of messages throw becomes a status.
template <typename Function>
Status Guarded(const rosbag::Bag& bag, const Function& function) {
  const std::string& name = bag.getFileName();
  try {
    return function().WithContext(name);
  } catch (const std::exception& error) {  // rosbag's, or of a message that is cut short
    return Unreadable(name, error.what());
  }
}

Result<std::unique_ptr<rosbag::Bag>> OpenBag(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return NotFound("there is no file " + path.string());
  try {
    // rosbag itself crashes on some damaged bags.
    if (const Status checked = CheckBag(path); !checked.ok()) {
      return Unreadable(path.string(), checked.message().c_str());
    }
    auto bag = std::make_unique<rosbag::Bag>();
    bag->open(path.string(), rosbag::bagmode::Read);
    return bag;
  } catch (const rosbag::BagUnindexedException&) {
    return DataLoss(path.string() +
                    " has no index, for its recorder was ended; rosbag reindex makes one");
  } catch (const std::exception& caught) {
    return DataLoss(path.string() + " is no rosbag, or damaged: " + caught.what());
  }
}

Result<EpisodeStart> ReadStart(const rosbag::Bag& bag) {
  EpisodeStart start;
  bool found = false;
  const Status read = Guarded(bag, [&]() {
    return ForEach<EpisodeStart>(bag, [&](const EpisodeStart& message, const auto&) {
      start = message;
      found = true;
      return false;
    });
  });
  LW_RETURN_IF_ERROR(read);
  if (!found) {
    return DataLoss(bag.getFileName() + " is no episode: nothing of type " +
                    TypeName<EpisodeStart>() + " is in it");
  }
  if (start.format != kEpisodeFormat) {
    return FailedPrecondition(bag.getFileName() + " is an episode of format " +
                              std::to_string(start.format) + "; this program reads format " +
                              std::to_string(kEpisodeFormat));
  }
  return start;
}

}  // namespace

Result<std::unique_ptr<EpisodeReader>> EpisodeReader::Open(const std::vector<fs::path>& paths) {
  if (paths.empty()) return InvalidArgument("no bag is given");
  std::unique_ptr<EpisodeReader> reader(new EpisodeReader);
  for (const fs::path& path : paths) {
    LW_ASSIGN_OR_RETURN(std::unique_ptr<rosbag::Bag> bag, OpenBag(path));
    LW_ASSIGN_OR_RETURN(EpisodeStart start, ReadStart(*bag));
    if (reader->bags_.empty()) {
      reader->start_ = std::move(start);
    } else if (start.name != reader->start_.name || start.begun != reader->start_.begun ||
               start.world_id != reader->start_.world_id || start.run != reader->start_.run) {
      return InvalidArgument(path.string() + " is of another episode than " + paths[0].string());
    }
    reader->bags_.push_back(std::move(bag));
  }
  return reader;
}

Result<std::shared_ptr<const World>> EpisodeReader::ReadWorld() const {
  const rosbag::Bag& bag = *bags_.front();
  std::vector<WorldFile> files;
  const Status read = Guarded(bag, [&]() {
    return ForEach<WorldFiles>(bag, [&](const WorldFiles& message, const auto&) {
      files = ToWorldFiles(message.files);
      return false;
    });
  });
  LW_RETURN_IF_ERROR(read);
  if (files.empty()) {
    return DataLoss(bag.getFileName() + " holds no world: nothing of type " +
                    TypeName<WorldFiles>() + " is in it");
  }
  auto world = UnpackWorld(files);
  if (!world.ok()) return world.status().WithContext(bag.getFileName());
  if ((*world)->id != start_.world_id) {
    return DataLoss(bag.getFileName() + " holds the world " + (*world)->id +
                    ", and is an episode of " + start_.world_id);
  }
  return world;
}

Result<ReplayPlan> EpisodeReader::ReadPlan(std::vector<std::string>* warnings) const {
  RecordedSimulation recorded;
  recorded.beginning = {start_.beginning_seed, start_.beginning_number, start_.beginning_step};
  recorded.hashes.push_back({start_.step, start_.calls, start_.state_hash});
  recorded.steps = {start_.step, start_.calls, start_.step};
  const auto reach = [&recorded](std::uint64_t step) {
    recorded.steps.last = std::max(recorded.steps.last, step);
  };
  const auto add_call = [&](const JournalMessage& message) -> Status {
    LW_ASSIGN_OR_RETURN(JournalEntry entry, ToJournalEntry(message));
    reach(entry.step);
    recorded.calls.push_back(std::move(entry));
    return Status();
  };
  for (const JournalMessage& message : start_.journal) LW_RETURN_IF_ERROR(add_call(message));
  for (const auto& bag : bags_) {
    const Status read = Guarded(*bag, [&]() {
      Status legal;
      Status status =
          ForEach<JournalMessage>(*bag, [&](const JournalMessage& message, const auto&) {
            if (message.run == start_.run) legal = add_call(message);
            return legal.ok();
          });
      if (!status.ok() || !legal.ok()) return status.ok() ? legal : status;
      status = ForEach<StateHash>(*bag, [&](const StateHash& message, const auto&) {
        if (message.run != start_.run) return true;
        recorded.hashes.push_back(ToRecordedHash(message));
        reach(message.step);
        return true;
      });
      if (!status.ok()) return status;
      const auto add_steps = [&](const AgentStates& message, const auto&) {
        if (message.world_id == start_.world_id) reach(message.step);
        return true;
      };
      return ForEach<AgentStates>(*bag, add_steps, LastTime<AgentStates>(*bag));
    });
    LW_RETURN_IF_ERROR(read);
  }
  return MakeReplayPlan(std::move(recorded), warnings);
}

template <typename Message, typename Use>
Status EpisodeReader::ForAll(const Use& use) const {
  for (const auto& bag : bags_) {
    const Status read = Guarded(*bag, [&]() {
      return ForEach<Message>(*bag, [&](const Message& message, const auto& instance) {
        use(message, instance.getTopic());
        return true;
      });
    });
    LW_RETURN_IF_ERROR(read);
  }
  return Status();
}

Result<EpisodeRecord> EpisodeReader::ReadRecord() const {
  EpisodeRecordBuilder builder(start_);
  std::set<std::uint64_t> calls;
  const auto add = [&builder](const auto& message, const std::string&) { builder.Add(message); };
  // Events first: they tell who came back, where tracks break.
  LW_RETURN_IF_ERROR(ForAll<AgentEvent>(add));
  LW_RETURN_IF_ERROR(ForAll<AgentStates>(add));
  LW_RETURN_IF_ERROR(ForAll<EpisodeEnd>(add));
  LW_RETURN_IF_ERROR(ForAll<sensor_msgs::JointState>(
      [&builder](const sensor_msgs::JointState& message, const std::string& topic) {
        builder.Add(message, topic);
      }));
  LW_RETURN_IF_ERROR(
      ForAll<StateHash>([&builder](const StateHash&, const std::string&) { builder.CountHash(); }));
  LW_RETURN_IF_ERROR(
      ForAll<JournalMessage>([&calls](const JournalMessage& message, const std::string&) {
        calls.insert(message.number);
      }));
  EpisodeRecord record = builder.Take();
  record.calls = calls.size();
  return record;
}

}  // namespace latticeworld
