#ifndef LATTICEWORLD_TESTS_LANGUAGE_LOCAL_TINY_EYES_H_
#define LATTICEWORLD_TESTS_LANGUAGE_LOCAL_TINY_EYES_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace latticeworld {

// Eyes with random weights for a language model of that width.
struct TinyEyes {
  std::uint32_t weight_type = 0;  // as of TinyModel
  std::size_t side = 16, patch = 4, width = 32, heads = 4, hidden = 64, layers = 2;
  std::size_t embedding = 64;
  std::vector<std::string> without;  // keys and tensors that are left out
  std::uint64_t seed = 1;
};

// The bytes of their GGUF file.
std::string TinyEyesGguf(const TinyEyes& eyes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_LOCAL_TINY_EYES_H_
