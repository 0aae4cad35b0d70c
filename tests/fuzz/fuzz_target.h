#ifndef LATTICEWORLD_TESTS_FUZZ_FUZZ_TARGET_H_
#define LATTICEWORLD_TESTS_FUZZ_FUZZ_TARGET_H_

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

// The entry of a fuzz target, as libFuzzer calls it (https://llvm.org/docs/LibFuzzer.html). Each
// *_fuzz.cc defines it; libFuzzer or corpus_main.cc has the main function. Returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace latticeworld::fuzz {

inline std::string_view TextOf(const std::uint8_t* data, std::size_t size) {
  return size == 0 ? std::string_view()
                   : std::string_view(reinterpret_cast<const char*>(data), size);
}

// Ends the program, which makes the input a finding, where a claim about the reader does not hold.
inline void Expect(bool holds, const char* claim) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", claim);
  std::abort();
}

// Takes the first byte of an input, which chooses one of several readers: 'a' the first of them,
// 'b' the second, and so on; any other byte some.
inline std::size_t TakeChoice(std::string_view* input, std::size_t count) {
  if (input->empty()) return 0;
  const auto first = static_cast<unsigned char>(input->front());
  input->remove_prefix(1);
  return (first >= 'a' ? first - 'a' : first) % count;
}

// A file in memory that holds an input, for readers that want a path.
class InputFile {
 public:
  explicit InputFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
    Expect(descriptor_ >= 0, "there is memory for the input's file");
    for (std::string_view rest = bytes; !rest.empty();) {
      const ssize_t written = write(descriptor_, rest.data(), rest.size());
      Expect(written > 0, "the input can be written to its file");
      rest.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  ~InputFile() { close(descriptor_); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace latticeworld::fuzz

#endif  // LATTICEWORLD_TESTS_FUZZ_FUZZ_TARGET_H_
