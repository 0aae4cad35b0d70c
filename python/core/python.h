#ifndef LATTICEWORLD_PYTHON_CORE_PYTHON_H_
#define LATTICEWORLD_PYTHON_CORE_PYTHON_H_

// All of nanobind that this module uses.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace nb = nanobind;

#endif  // LATTICEWORLD_PYTHON_CORE_PYTHON_H_
