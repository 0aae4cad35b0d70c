#ifndef LATTICEWORLD_DATASET_SOURCES_INSTANCE_SOURCE_H_
#define LATTICEWORLD_DATASET_SOURCES_INSTANCE_SOURCE_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/dataset/instance.h"

namespace latticeworld {

// What a data card says of where instances come from.
struct SourceCard {
  std::string name;      // "loveda", "scenes", "generated"
  std::string title;     // in words
  std::string licence;   // of the images; SPDX where there is one, "" not known
  std::string citation;  // "" none
};

// Supplies instances, group by group. A group is a source image with all its rotations or tiles, or
// one generated place.
class InstanceSource {
 public:
  virtual ~InstanceSource() = default;
  virtual const SourceCard& card() const = 0;
  virtual std::size_t group_count() const = 0;
  // Unique, the same at every run, fit for a file's name; index < group_count().
  virtual std::string GroupName(std::size_t index) const = 0;
  // All instances of a group, never none. May be called by several threads at once; depends on the
  // index (and the source's seed) alone. Errors name the file: NOT_FOUND (a missing pair),
  // INVALID_ARGUMENT (sizes that differ, unknown mask values, an elevation in degrees),
  // DATA_LOSS (a broken file). The other groups are not touched by them.
  virtual Result<std::vector<Instance>> ReadGroup(std::size_t index) const = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_INSTANCE_SOURCE_H_
