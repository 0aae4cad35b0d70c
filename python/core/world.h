#ifndef LATTICEWORLD_PYTHON_CORE_WORLD_H_
#define LATTICEWORLD_PYTHON_CORE_WORLD_H_

#include <cstdint>
#include <memory>
#include <mutex>
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
  // For the built-in wheeled robot, as world_server's map; made once.
  const Grid<std::int8_t>& Occupancy();

 private:
  std::shared_ptr<const World> world_;
  std::once_flag mapped_;
  Grid<std::int8_t> occupancy_;
};

void BindWorld(nb::module_& module);

}  // namespace latticeworld::python

#endif  // LATTICEWORLD_PYTHON_CORE_WORLD_H_
