// Sensors and suites that a user adds, as JSON.

#include "fuzz/fuzz_target.h"
#include "latticeworld/sensing/sensor_suite.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(latticeworld::fuzz::TextOf(data, size));
  (void)latticeworld::SensorCatalogue::Extended({{"user.json", text}});
  return 0;
}
