#ifndef LATTICEWORLD_PYTHON_CORE_CREW_H_
#define LATTICEWORLD_PYTHON_CORE_CREW_H_

#include "python.h"

namespace latticeworld::python {

// Crew, which advances many simulations side by side, and reachable, which goals are drawn by.
void BindCrew(nb::module_& module);

}  // namespace latticeworld::python

#endif  // LATTICEWORLD_PYTHON_CORE_CREW_H_
