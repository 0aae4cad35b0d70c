#include "latticeworld_ros/episode/episode_request.h"

#include <cmath>
#include <utility>
#include <vector>

#include "latticeworld/common/request_fields.h"
#include "latticeworld/common/text.h"
#include "latticeworld_ros/server/bundle_name.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMostNameCharacters = 64;

void Append(const Status& status, std::vector<Violation>* violations) {
  violations->insert(violations->end(), status.violations().begin(), status.violations().end());
}

}  // namespace

Result<EpisodeRequest> ReadEpisodeRequest(const latticeworld_msgs::StartEpisode::Request& request,
                                          const std::string& usual_compression) {
  std::vector<Violation> violations;
  EpisodeRequest read;
  read.options.name = request.name;
  read.options.split_bytes = static_cast<std::uint64_t>(request.split_mb) << 20;
  read.options.max_bytes = static_cast<std::uint64_t>(request.max_mb) << 20;
  read.options.max_duration_s = request.max_duration;
  if (!request.name.empty()) {
    Append(CheckBundleName(request.name, kMostNameCharacters), &violations);
  }
  Result<TopicFilter> filter = TopicFilter::Create(request.topics, request.sensors);
  Append(filter.status(), &violations);
  if (request.keep_state && request.seed != 0) {
    const std::string given = std::to_string(request.seed);
    violations.push_back({"conflict", "seed",
                          "is " + given +
                              ", and keep_state is set: the state has its seed; legal "
                              "is 0",
                          given});
  }
  if (const auto compression = ReadName<BagCompression>(
          "compression", request.compression.empty() ? usual_compression : request.compression,
          &violations)) {
    read.options.compression = *compression;
  }
  if (!(request.max_duration >= 0.0) || !std::isfinite(request.max_duration)) {
    const std::string given = FormatDouble(request.max_duration);
    violations.push_back(
        {"out_of_range", "max_duration", "is " + given + " s; legal is 0 or more", given});
  }
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal request", std::move(violations)));
  read.filter = *std::move(filter);
  return read;
}

}  // namespace latticeworld
