#include "latticeworld/dataset/writing/dataset_options.h"

#include "latticeworld/common/random.h"
#include "latticeworld/common/range.h"

namespace latticeworld {

std::vector<Violation> Validate(const DatasetOptions& options) {
  std::vector<Violation> violations;
  CheckRange("train_share", options.train_share, {0.0, 1.0}, "", &violations);
  CheckRange("validation_share", options.validation_share, {0.0, 1.0}, "", &violations);
  if (violations.empty() && options.train_share + options.validation_share > 1.0 + 1e-9) {
    violations.push_back({"conflict", "validation_share",
                          "is more than train_share leaves; both together are at most 1", ""});
  }
  CheckRange("sketch_share", options.sketch_share, {0.0, 0.5, true, true}, "", &violations);
  CheckRange("size", options.size_m, {16.0, 8192.0}, " m", &violations);
  CheckRange("groups_per_part", options.groups_per_part, {1.0, 10000.0}, "", &violations);
  CheckRange("threads", options.threads, {0.0, 256.0}, "", &violations);
  if (!options.layout && !options.environment) {
    violations.push_back({"conflict", "layout, environment",
                          "neither is asked for; a data set has one of them or both", ""});
  }
  return violations;
}

DatasetSplit SplitOf(std::string_view group, const DatasetOptions& options) {
  const double place = RandomStream(0, "dataset/split/" + std::string(group)).Uniform();
  if (place < options.train_share) return DatasetSplit::kTrain;
  if (place < options.train_share + options.validation_share) return DatasetSplit::kValidation;
  return DatasetSplit::kTest;
}

}  // namespace latticeworld
