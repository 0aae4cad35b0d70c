// latticeworld._core: worlds, simulations and crews for Python.

#include "crew.h"
#include "errors.h"
#include "python.h"
#include "simulation.h"
#include "world.h"

NB_MODULE(_core, module) {
  latticeworld::python::BindErrors(module);
  latticeworld::python::BindWorld(module);
  latticeworld::python::BindSimulation(module);
  latticeworld::python::BindCrew(module);
}
