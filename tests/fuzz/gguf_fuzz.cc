// Model files (GGUF): metadata and tensors, the model's sizes and weights, its tokenizer.

#include "fuzz/fuzz_target.h"
#include "latticeworld/language/local/decoding/llama_model.h"
#include "latticeworld/language/local/tokens/tokenizer.h"
#include "latticeworld/language/local/weights/gguf_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const latticeworld::fuzz::InputFile input(latticeworld::fuzz::TextOf(data, size));
  const auto file = latticeworld::GgufFile::Open(input.path());
  if (!file.ok()) return 0;
  (void)latticeworld::ReadLlamaModel(*file);
  const auto tokenizer = latticeworld::Tokenizer::Read(*file);
  if (tokenizer.ok()) (void)tokenizer->Encode("A lake lies in the north.\n\n 42 \xc3\xa9\xff");
  return 0;
}
