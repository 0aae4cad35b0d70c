#include "errors.h"

namespace latticeworld::python {

void BindErrors(nb::module_& module) {
  (void)module;
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const StatusError& error) {
      const std::string code(ToString(error.status().code()));
      const nb::object exception = nb::module_::import_("latticeworld.errors")
                                       .attr("of_status")(code, error.status().message());
      PyErr_SetObject(exception.type().ptr(), exception.ptr());
    }
  });
}

}  // namespace latticeworld::python
