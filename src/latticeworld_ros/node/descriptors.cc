#include "latticeworld_ros/node/descriptors.h"

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

namespace latticeworld {
namespace {

// roscpp keeps 32 free.
constexpr std::size_t kSpare = 64;

}  // namespace

bool DescriptorUse::is_short() const { return limit != 0 && open + kSpare > limit; }

std::size_t RaiseDescriptorLimit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return 0;
  const rlim_t wanted = std::min<rlim_t>(limit.rlim_max, kMostDescriptors);
  if (wanted > limit.rlim_cur) {
    rlimit raised = limit;
    raised.rlim_cur = wanted;
    if (setrlimit(RLIMIT_NOFILE, &raised) == 0) limit = raised;
  }
  return limit.rlim_cur;
}

DescriptorUse CountDescriptors() {
  DescriptorUse use;
  std::error_code error;
  std::filesystem::directory_iterator files("/proc/self/fd", error);
  if (!error) {
    use.open = static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) == 0) use.limit = limit.rlim_cur;
  return use;
}

}  // namespace latticeworld
