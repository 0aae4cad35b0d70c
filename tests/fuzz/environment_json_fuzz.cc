// Environments as JSON: what is read is legal, and written as it was read.

#include "fuzz/fuzz_target.h"
#include "latticeworld/environment/environment_config.h"

using latticeworld::ParseEnvironment;
using latticeworld::fuzz::Expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto environment = ParseEnvironment(latticeworld::fuzz::TextOf(data, size));
  if (!environment.ok()) return 0;
  Expect(Validate(*environment).empty(), "an environment that was read is legal");
  const std::string text = ToJson(*environment);
  const auto again = ParseEnvironment(text);
  Expect(again.ok() && ToJson(*again) == text, "an environment is written as it was read");
  return 0;
}
