// What campaigns keep and hear: tasks, results of trials, lines of a stack's program.

#include "fuzz/fuzz_target.h"
#include "latticeworld/campaign/stacks/program_messages.h"
#include "latticeworld/campaign/trial_result.h"
#include "latticeworld/navigation/tasks_json.h"

namespace {

using namespace latticeworld;
using fuzz::Expect;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text = fuzz::TextOf(data, size);
  switch (fuzz::TakeChoice(&text, 4)) {
    case 0: {
      const auto tasks = DecodeTasks(text);
      if (!tasks.ok()) break;
      const std::string encoded = EncodeTasks(*tasks);
      const auto again = DecodeTasks(encoded);
      Expect(again.ok() && EncodeTasks(*again) == encoded, "tasks are written as they were read");
      break;
    }
    case 1: {
      const auto result = DecodeTrialResult(text);
      if (!result.ok()) break;
      const std::string encoded = EncodeTrialResult(*result);
      const auto again = DecodeTrialResult(encoded);
      Expect(again.ok() && EncodeTrialResult(*again) == encoded,
             "a result is written as it was read");
      break;
    }
    case 2:
      (void)DecodeReady(std::string(text));
      break;
    default:
      (void)DecodeOutput(std::string(text));
  }
  return 0;
}
