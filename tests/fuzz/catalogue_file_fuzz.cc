// Assets that a user adds to the catalogue, as JSON.

#include "fuzz/fuzz_target.h"
#include "latticeworld/catalogue/catalogue.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(latticeworld::fuzz::TextOf(data, size));
  (void)latticeworld::Catalogue::Extended({{"user.json", text}});
  return 0;
}
