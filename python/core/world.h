#ifndef LATTICEWORLD_PYTHON_CORE_WORLD_H_
#define LATTICEWORLD_PYTHON_CORE_WORLD_H_

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "latticeworld/generation/world.h"
#include "latticeworld/geometry/grid.h"
#include "python.h"

namespace latticeworld::python {

// A world as Python has it, and the map that is made of it when first asked for.
class PyWorld {
 public:
  explicit PyWorld(std::shared_ptr<const World> world) : world_(std::move(world)) {}

  const World& world() const { return *world_; }
  const std::shared_ptr<const World>& shared() const { return world_; }
  const Scene& scene() const { return *world_->scene; }
  // For the footprint of a built-in species, as world_server's map; made once for each, and kept.
  // Raises InvalidArgument where there is no such species.
  const Grid<std::int8_t>& OccupancyFor(const std::string& species);

 private:
  std::shared_ptr<const World> world_;
  std::mutex mutex_;
  std::map<std::string, Grid<std::int8_t>> occupancy_;  // by species; guarded by mutex_
};

void BindWorld(nb::module_& module);

}  // namespace latticeworld::python

#endif  // LATTICEWORLD_PYTHON_CORE_WORLD_H_
