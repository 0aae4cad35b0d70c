#ifndef LATTICEWORLD_TESTS_DATASET_TEST_SOURCE_H_
#define LATTICEWORLD_TESTS_DATASET_TEST_SOURCE_H_

#include <atomic>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/dataset/captions/annotator.h"
#include "latticeworld/dataset/sources/generated_source.h"
#include "latticeworld/dataset/sources/instance_source.h"

namespace latticeworld {

// Groups of four generated places each, as the rotations or tiles of one image would be.
class FourEachSource : public InstanceSource {
 public:
  explicit FourEachSource(std::size_t groups, std::uint64_t seed = 1);
  const SourceCard& card() const override { return card_; }
  std::size_t group_count() const override { return groups_; }
  std::string GroupName(std::size_t index) const override {
    return "image-" + std::to_string(index);
  }
  Result<std::vector<Instance>> ReadGroup(std::size_t index) const override;

  std::set<std::size_t> broken;  // groups that cannot be read
  mutable std::atomic<int> reads{0};

 private:
  const std::size_t groups_;
  const GeneratedSourceOptions generated_;
  const SourceCard card_{"four", "Four places a group", "CC0-1.0", ""};
};

// The written annotator, which stops answering after so many layouts, and knows no words for some.
class FailingAnnotator : public Annotator {
 public:
  FailingAnnotator(Annotator* inner, int answers) : inner_(inner), left_(answers) {}
  std::string_view name() const override { return inner_->name(); }
  Result<LayoutCaption> DescribeLayout(const Instance& instance, std::uint64_t seed,
                                       const Progress& progress) override;
  Result<EnvironmentCaption> DescribeEnvironment(const Instance& instance,
                                                 const LayoutCaption& layout, std::uint64_t seed,
                                                 const Progress& progress) override {
    return inner_->DescribeEnvironment(instance, layout, seed, progress);
  }

  std::string speechless;  // the id of an instance that it cannot describe

 private:
  Annotator* inner_;
  std::atomic<int> left_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_DATASET_TEST_SOURCE_H_
