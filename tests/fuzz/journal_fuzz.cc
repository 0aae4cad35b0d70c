// Calls of a journal, and the options of a recorded simulator, as JSON.

#include "fuzz/fuzz_target.h"
#include "latticeworld/episode/journal_json.h"

using latticeworld::fuzz::Expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text = latticeworld::fuzz::TextOf(data, size);
  if (latticeworld::fuzz::TakeChoice(&text, 2) == 0) {
    const auto call = latticeworld::DecodeCall(text);
    if (!call.ok()) return 0;
    const std::string encoded = EncodeCall(*call);
    const auto again = latticeworld::DecodeCall(encoded);
    Expect(again.ok() && EncodeCall(*again) == encoded, "a call is written as it was read");
  } else {
    const auto options = latticeworld::DecodeSimulatorOptions(text);
    if (!options.ok()) return 0;
    const std::string encoded = EncodeSimulatorOptions(*options);
    const auto again = latticeworld::DecodeSimulatorOptions(encoded);
    Expect(again.ok() && EncodeSimulatorOptions(*again) == encoded,
           "options are written as they were read");
  }
  return 0;
}
