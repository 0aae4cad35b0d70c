// Species that a user adds, as JSON.

#include "fuzz/fuzz_target.h"
#include "latticeworld/species/species_catalogue.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(latticeworld::fuzz::TextOf(data, size));
  (void)latticeworld::SpeciesCatalogue::Extended({{"user.json", text}});
  return 0;
}
