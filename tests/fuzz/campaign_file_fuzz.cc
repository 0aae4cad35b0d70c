// Campaigns as YAML.

#include "fuzz/fuzz_target.h"
#include "latticeworld/campaign/campaign_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)latticeworld::ParseCampaign(std::string(latticeworld::fuzz::TextOf(data, size)),
                                    "/nowhere");
  return 0;
}
