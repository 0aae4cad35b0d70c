#include "latticeworld_ros/episode/episode_recorder.h"

#include <ros/master.h>

#include <boost/thread/exceptions.hpp>
#include <chrono>
#include <ctime>
#include <optional>
#include <system_error>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/conversion/status_conversion.h"
#include "latticeworld_ros/episode/episode_files.h"
#include "latticeworld_ros/episode/parameters_json.h"
#include "latticeworld_ros/node/descriptors.h"
#include "latticeworld_ros/node/parameters.h"
#include "latticeworld_ros/node/service_address.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;
using latticeworld_msgs::EpisodeStart;
using latticeworld_msgs::EpisodeStatus;
using latticeworld_msgs::GetWorldBundle;
using latticeworld_msgs::ListEpisodes;
using latticeworld_msgs::StartEpisode;
using latticeworld_msgs::StopEpisode;
using latticeworld_msgs::WorldFiles;

constexpr char kBundleService[] = "get_world_bundle";
constexpr std::size_t kMostNamed = 5;  // topics, in a warning
constexpr std::chrono::milliseconds kSupervisePeriod(250);
constexpr std::chrono::milliseconds kPollPeriod(10);
// It waits this long for connections, which stand in a few milliseconds, and for a server that
// starts.
constexpr std::chrono::seconds kPatience(5);

// Time of the wall: simulated time may stand still.
std::string WallTime(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  char text[64] = "";
  if (gmtime_r(&now, &utc) != nullptr) (void)std::strftime(text, sizeof(text), format, &utc);
  return text;
}

template <typename Condition>
bool WaitFor(const Condition& condition) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline || !ros::ok()) return false;
    std::this_thread::sleep_for(kPollPeriod);
  }
  return true;
}

Status WaitForService(const std::string& name) {
  if (WaitFor([&name] { return ros::service::exists(name, /*print_failure_reason=*/false); })) {
    return Status();
  }
  return Unavailable("there is no service " + ros::names::resolve(name) +
                     ": world_server does not run");
}

template <typename Service>
Status Call(const std::string& name, Service* service) {
  LW_RETURN_IF_ERROR(WaitForService(name));
  if (!ros::service::call(name, *service)) return Unavailable(name + " gave no answer");
  const latticeworld_msgs::Status& status = service->response.status;
  return Status(static_cast<StatusCode>(status.code), status.message).WithContext(name);
}

// Says which topics an episode begins without.
void WaitForConnections(const EpisodeListener& listener) {
  std::optional<std::vector<std::string>> missing;
  if (WaitFor([&] {
        missing = listener.Unconnected();
        return missing.has_value() && missing->empty();
      }) ||
      !missing.has_value()) {
    return;
  }
  const std::size_t count = missing->size();
  if (count > kMostNamed) missing->resize(kMostNamed);
  const DescriptorUse use = CountDescriptors();
  ROS_WARN_STREAM("the episode begins without "
                  << count << " topics that are not connected, " << Join(*missing, ", ")
                  << (count > kMostNamed ? " and others" : "") << "; " << use.open << " of "
                  << use.limit << " file descriptors are in use");
}

EpisodeTopics TopicsHere() {
  return {ros::names::resolve("world/journal"), ros::names::resolve("world/state_hash")};
}

EpisodeStart StartOf(const GetWorldBundle::Response& world, const std::string& name,
                     const std::vector<std::string>& topics) {
  EpisodeStart start;
  start.header.stamp = world.stamp;
  start.header.frame_id = "map";
  start.format = kEpisodeFormat;
  start.name = name;
  start.begun = WallTime("%Y-%m-%dT%H:%M:%SZ");
  start.world_id = world.world_id;
  start.run = world.run;
  start.seed = world.seed;
  start.step = world.step;
  start.episode_step = world.episode_step;
  start.calls = world.calls;
  start.state_hash = world.state_hash;
  start.options = world.options;
  start.beginning_seed = world.beginning_seed;
  start.beginning_number = world.beginning_number;
  start.beginning_step = world.beginning_step;
  start.journal = world.journal;
  start.journal_complete = world.journal_complete;
  start.versions = world.versions;
  start.topics = topics;
  XmlRpc::XmlRpcValue parameters;
  (void)ros::param::get("/", parameters);
  start.parameters = ParametersToJson(parameters);
  return start;
}

}  // namespace

EpisodeRecorder::Running::Running(const EpisodeRecordingOptions& options,
                                  const ros::NodeHandle& node, const TopicFilter& filter,
                                  const std::vector<std::string>& always)
    : recording(options),
      server([] { return ServiceAddress(kBundleService); }),
      listener(node, filter, always, [this](BagMessage message) {
        if (server.Accepts(message)) recording.Add(std::move(message));
      }) {}

EpisodeRecorder::EpisodeRecorder(ros::NodeHandle node, const EpisodeRecorderOptions& options)
    : node_(node),
      options_(options),
      directory_(ExpandHome(options.directory)),
      status_(node_.advertise<EpisodeStatus>("episode/status", 10, /*latch=*/true)),
      services_(node) {
  TellStatus();
  services_.Advertise<StartEpisode>("start_episode", [this](const StartEpisode::Request& request,
                                                            StartEpisode::Response* response) {
    response->status = ToStatusMessage(Start(request, response));
  });
  services_.Advertise<StopEpisode>(
      "stop_episode", [this](const StopEpisode::Request&, StopEpisode::Response* response) {
        response->status = ToStatusMessage(Stop(response));
      });
  services_.Advertise<ListEpisodes>(
      "list_episodes",
      [this](const ListEpisodes::Request&, ListEpisodes::Response* response) { List(response); });
  supervisor_ = std::thread([this] { Supervise(); });
  services_.Start();
}

EpisodeRecorder::~EpisodeRecorder() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  supervisor_.join();
  services_.Stop();
  const std::lock_guard<std::mutex> lifecycle(lifecycle_);
  if (running_ != nullptr) (void)Finish("the recorder was ended", /*ask=*/false);
}

Result<EpisodeRequest> EpisodeRecorder::Read(const StartEpisode::Request& request) const {
  LW_ASSIGN_OR_RETURN(EpisodeRequest read, ReadEpisodeRequest(request, options_.compression));
  EpisodeRecordingOptions& options = read.options;
  options.directory = directory_;
  if (options.name.empty()) options.name = WallTime("episode-%Y%m%d-%H%M%S");
  options.topics = TopicsHere();
  options.buffer_bytes = static_cast<std::uint64_t>(options_.buffer_mb) << 20;
  if (!FilesOfEpisode(directory_, options.name).empty()) {
    return Status(StatusCode::kAlreadyExists,
                  "there is an episode " + Quote(options.name) + " in " + directory_.string());
  }
  return read;
}

Result<GetWorldBundle::Response> EpisodeRecorder::AskForWorld(bool files) const {
  latticeworld_msgs::GetWorldBundle service;
  service.request.files = files;
  LW_RETURN_IF_ERROR(Call(kBundleService, &service));
  return std::move(service.response);
}

Status EpisodeRecorder::ResetWorld(std::uint64_t seed) const {
  latticeworld_msgs::ResetWorld service;
  service.request.seed = seed;
  return Call("reset_world", &service);
}

Result<std::unique_ptr<EpisodeRecorder::Running>> EpisodeRecorder::Hear(
    const EpisodeRecordingOptions& options, const TopicFilter& filter) const {
  const std::vector<std::string> always = {"/clock", options.topics.journal,
                                           options.topics.state_hash};
  try {
    return std::make_unique<Running>(options, node_, filter, always);
  } catch (const boost::thread_resource_error& error) {
    return ResourceExhausted(std::string("no thread can be had to hear topics: ") + error.what());
  }
}

Status EpisodeRecorder::Start(const StartEpisode::Request& request,
                              StartEpisode::Response* response) {
  const std::lock_guard<std::mutex> lifecycle(lifecycle_);
  if (running_ != nullptr) {
    return FailedPrecondition("the episode " + Quote(running_->recording.options().name) +
                              " is being recorded; stop_episode ends it");
  }
  LW_ASSIGN_OR_RETURN(const EpisodeRequest read, Read(request));
  const EpisodeRecordingOptions& options = read.options;
  std::error_code error;
  fs::create_directories(directory_, error);
  if (error) {
    return PermissionDenied("cannot make " + directory_.string() + ": " + error.message());
  }
  LW_RETURN_IF_ERROR(WaitForService(kBundleService));
  // Heard first, asked for then: what happens between the two is known twice, not lost.
  LW_ASSIGN_OR_RETURN(auto running, Hear(options, read.filter));
  running->listener.Discover();
  WaitForConnections(running->listener);
  if (!request.keep_state) LW_RETURN_IF_ERROR(ResetWorld(request.seed));
  LW_ASSIGN_OR_RETURN(GetWorldBundle::Response world, AskForWorld(/*files=*/true));
  if (!running->server.Close()) {
    return Unavailable("another world_server started meanwhile; call start_episode again");
  }
  WorldFiles files;
  files.world_id = world.world_id;
  files.files.swap(world.world);
  LW_RETURN_IF_ERROR(running->recording.Begin(StartOf(world, options.name, read.filter.patterns()),
                                              std::move(files)));
  running_ = std::move(running);
  response->name = options.name;
  response->path = running_->recording.progress().active_path;
  response->world_id = world.world_id;
  response->seed = world.seed;
  TellStatus();
  return Status();
}

Result<GetWorldBundle::Response> EpisodeRecorder::AskForLastCalls() const {
  if (!running_->server.IsSame()) return Unavailable(kAnotherServer);
  LW_ASSIGN_OR_RETURN(GetWorldBundle::Response last, AskForWorld(/*files=*/false));
  if (!running_->server.IsSame()) return Unavailable(kAnotherServer);
  return last;
}

Status EpisodeRecorder::Finish(const std::string& reason, bool ask) {
  const Result<GetWorldBundle::Response> last = ask ? AskForLastCalls() : Unavailable("not asked");
  if (ask && !last.ok()) {
    ROS_WARN_STREAM("the episode ends without the last calls: " << last.status().ToString());
  }
  const Status ended =
      running_->recording.End(running_->server.IsSame() ? reason : std::string(kAnotherServer),
                              last.ok() ? &*last : nullptr);
  TellStatus();
  running_.reset();
  return ended;
}

Status EpisodeRecorder::Stop(StopEpisode::Response* response) {
  const std::lock_guard<std::mutex> lifecycle(lifecycle_);
  if (running_ == nullptr) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return FailedPrecondition(last_.reason.empty()
                                  ? "no episode is being recorded; start_episode begins one"
                                  : "no episode is being recorded: " + Quote(last_.name) +
                                        " ended because " + last_.reason);
  }
  const Status ended = Finish("stopped", /*ask=*/true);
  const std::lock_guard<std::mutex> lock(mutex_);
  response->name = last_.name;
  response->paths = last_.paths;
  response->messages = last_.messages;
  response->dropped = last_.dropped;
  response->missing_calls = last_.missing_calls;
  return ended;
}

void EpisodeRecorder::List(ListEpisodes::Response* response) const {
  response->directory = directory_.string();
  response->episodes = EpisodesIn(directory_);
}

void EpisodeRecorder::Supervise() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!changed_.wait_for(lock, kSupervisePeriod, [this] { return stop_; })) {
    lock.unlock();
    {
      const std::lock_guard<std::mutex> lifecycle(lifecycle_);
      if (running_ != nullptr) {
        running_->listener.Discover();
        TellStatus();
        const EpisodeProgress progress = running_->recording.progress();
        if (!progress.reason.empty() || !running_->server.IsSame()) {
          (void)Finish(progress.reason, /*ask=*/!progress.failed);
        }
      }
    }
    lock.lock();
  }
}

void EpisodeRecorder::TellStatus() {
  EpisodeStatus status;
  status.state = "idle";
  if (running_ != nullptr) {
    const EpisodeProgress progress = running_->recording.progress();
    status.name = running_->recording.options().name;
    status.reason = progress.reason;
    status.paths = progress.paths;
    status.active_path = progress.active_path;
    status.bytes = progress.bytes;
    status.messages = progress.messages;
    status.dropped = progress.dropped;
    status.missing_calls = progress.missing_calls;
    status.state = !progress.done ? "recording" : progress.failed ? "failed" : "complete";
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  last_ = status;
  status_.publish(status);
}

}  // namespace latticeworld
