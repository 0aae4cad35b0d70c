#ifndef LATTICEWORLD_DATASET_INSTANCE_H_
#define LATTICEWORLD_DATASET_INSTANCE_H_

#include <memory>
#include <string>

#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// One place of a data set, before there are words for it.
struct Instance {
  std::string id;     // unique in its source; letters, digits, '_' and '-'
  std::string group;  // what it was cut from; a group is never divided between two splits
  SymbolicLayout layout;
  std::shared_ptr<const Relief> relief;  // v_L; null: a fixed-height scene
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_INSTANCE_H_
