#include "latticeworld/language/local/weights/instructions.h"

#include <atomic>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

std::atomic<Instructions>& Used() {
  static std::atomic<Instructions> used{FastestInstructions()};
  return used;
}

}  // namespace

bool HasInstructions(Instructions instructions) {
#if defined(__x86_64__) && defined(__GNUC__)
  const bool avx2 = __builtin_cpu_supports("avx2");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
  if (instructions == Instructions::kVnni) return avx512 && __builtin_cpu_supports("avx512vnni");
  if (instructions == Instructions::kAvx512) return avx512;
  if (instructions == Instructions::kAvx2) return avx2;
#endif
  return instructions == Instructions::kPlain;
}

Instructions FastestInstructions() {
  Instructions fastest = Instructions::kPlain;
  for (const Instructions instructions : kAllInstructions)
    if (HasInstructions(instructions)) fastest = instructions;
  return fastest;
}

Instructions UsedInstructions() { return Used().load(std::memory_order_relaxed); }

void UseInstructions(Instructions instructions) {
  LW_CHECK(HasInstructions(instructions), "this processor has no such instructions");
  Used().store(instructions, std::memory_order_relaxed);
}

}  // namespace latticeworld
