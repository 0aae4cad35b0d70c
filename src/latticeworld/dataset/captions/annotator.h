#ifndef LATTICEWORLD_DATASET_CAPTIONS_ANNOTATOR_H_
#define LATTICEWORLD_DATASET_CAPTIONS_ANNOTATOR_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/dataset/instance.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {

// A layout instruction written for a layout that there is.
struct LayoutCaption {
  std::string text;           // x_L; says nothing that the layout contradicts
  std::vector<Claim> claims;  // what it says, every one satisfied by the layout
  std::string relief_text;    // what the relief looks like, with directions; "" without a relief
};

// An environment configuration for a layout, and an instruction that asks for it.
struct EnvironmentCaption {
  std::string text;               // x_C
  EnvironmentConfig environment;  // y_C, valid, fits the layout
};

// Writes what a person could have said to get an instance.
class Annotator {
 public:
  virtual ~Annotator() = default;
  virtual std::string_view name() const = 0;  // "written", or the model that wrote
  // May be called by several threads at once. The same instance and seed give the same words where
  // no model is asked. Errors: CANCELLED; DATA_LOSS (no caption that fits after all tries), and
  // those of a server.
  virtual Result<LayoutCaption> DescribeLayout(const Instance& instance, std::uint64_t seed,
                                               const Progress& progress) = 0;
  virtual Result<EnvironmentCaption> DescribeEnvironment(const Instance& instance,
                                                         const LayoutCaption& layout,
                                                         std::uint64_t seed,
                                                         const Progress& progress) = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_ANNOTATOR_H_
