#include "dataset/test_source.h"

namespace latticeworld {
namespace {

GeneratedSourceOptions OptionsOf(std::size_t groups, std::uint64_t seed) {
  GeneratedSourceOptions options;
  options.groups = 4 * groups;
  options.seed = seed;
  return options;
}

}  // namespace

FourEachSource::FourEachSource(std::size_t groups, std::uint64_t seed)
    : groups_(groups), generated_(OptionsOf(groups, seed)) {}

Result<std::vector<Instance>> FourEachSource::ReadGroup(std::size_t index) const {
  ++reads;
  if (broken.count(index) > 0) return DataLoss(GroupName(index) + ".png is truncated");
  std::vector<Instance> instances;
  for (std::size_t i = 0; i < 4; ++i) {
    instances.push_back(GeneratePlace(generated_, 4 * index + i).instance);
    instances.back().group = GroupName(index);
    instances.back().id = GroupName(index) + "-" + std::to_string(90 * i);
  }
  return instances;
}

Result<LayoutCaption> FailingAnnotator::DescribeLayout(const Instance& instance, std::uint64_t seed,
                                                       const Progress& progress) {
  if (instance.id == speechless) return DataLoss("no caption fits");
  if (--left_ < 0) return Unavailable("the server is gone");
  return inner_->DescribeLayout(instance, seed, progress);
}

}  // namespace latticeworld
