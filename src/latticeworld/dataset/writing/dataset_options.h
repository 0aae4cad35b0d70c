#ifndef LATTICEWORLD_DATASET_WRITING_DATASET_OPTIONS_H_
#define LATTICEWORLD_DATASET_WRITING_DATASET_OPTIONS_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/status.h"

namespace latticeworld {

// What a record teaches: instruction -> layout, instruction and layout -> environment, height map
// -> words.
enum class DatasetTask : std::uint8_t { kLayout, kEnvironment, kRelief };

constexpr std::array<EnumName<DatasetTask>, 3> EnumNames(DatasetTask) {
  return {{{DatasetTask::kLayout, "layout"},
           {DatasetTask::kEnvironment, "environment"},
           {DatasetTask::kRelief, "relief"}}};
}

enum class DatasetSplit : std::uint8_t { kTrain, kValidation, kTest };

constexpr std::array<EnumName<DatasetSplit>, 3> EnumNames(DatasetSplit) {
  return {{{DatasetSplit::kTrain, "train"},
           {DatasetSplit::kValidation, "validation"},
           {DatasetSplit::kTest, "test"}}};
}

inline constexpr std::size_t kDatasetTasks = 3;
inline constexpr std::size_t kDatasetSplits = 3;

// Whether records hold the system message too. Small models have no room for it.
enum class PromptForm : std::uint8_t { kFull, kShort };

constexpr std::array<EnumName<PromptForm>, 2> EnumNames(PromptForm) {
  return {{{PromptForm::kFull, "full"}, {PromptForm::kShort, "short"}}};
}

// Who answers an instruction for a layout: the place that it was written for, or the embedded
// generator, whose layout has what the words say and little else.
enum class LayoutsBy : std::uint8_t { kSource, kGrounded };

constexpr std::array<EnumName<LayoutsBy>, 2> EnumNames(LayoutsBy) {
  return {{{LayoutsBy::kSource, "source"}, {LayoutsBy::kGrounded, "grounded"}}};
}

// The groups of a part: written ones are made in an instant, a model's cost minutes each and are
// lost with a part that a server does not live to see whole.
inline constexpr int kGroupsPerPart = 50;
inline constexpr int kGroupsPerRemotePart = 5;

struct DatasetOptions {
  std::uint64_t seed = 0;   // of the words; a source has its own
  bool layout = true;       // which tasks are written
  bool environment = true;  //
  bool images = true;       // height maps, sketches, and with them the task relief
  PromptForm prompts = PromptForm::kFull;
  LayoutsBy layouts = LayoutsBy::kSource;
  double train_share = 0.9;        // of the groups, [0, 1]
  double validation_share = 0.05;  // [0, 1]; the rest is for tests
  double sketch_share = 0.02;  // of a sketch's pixels, at most, for each kind of stroke, (0, 0.5)
  double size_m = 512.0;       // [16, 8192]: side of the world that environments are for
  // [1, 10000]: what a thread loses at most when the work is broken off. It belongs to the data
  // set, so that its bytes do not depend on breaks.
  int groups_per_part = kGroupsPerPart;
  int threads = 0;  // [0, 256]; 0: as many as cores
};
std::vector<Violation> Validate(const DatasetOptions& options);

// Chooses by a hash of the group's name alone, so that all that was cut from one image is in one
// split, in every data set with these shares.
DatasetSplit SplitOf(std::string_view group, const DatasetOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_WRITING_DATASET_OPTIONS_H_
