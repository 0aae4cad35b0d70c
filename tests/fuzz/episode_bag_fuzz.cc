// Bags of episodes: what was recorded, the plan to simulate it again, the world.

#include "fuzz/fuzz_target.h"
#include "fuzz/support/allocation_limit.h"
#include "latticeworld_ros/episode/episode_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const latticeworld::fuzz::InputFile file(latticeworld::fuzz::TextOf(data, size));
  const latticeworld::fuzz::AllocationLimit limit(std::size_t{64} << 20);
  const auto reader = latticeworld::EpisodeReader::Open({file.path()});
  if (!reader.ok()) return 0;
  std::vector<std::string> warnings;
  (void)(*reader)->ReadRecord();
  (void)(*reader)->ReadPlan(&warnings);
  (void)(*reader)->ReadWorld();
  return 0;
}
