#ifndef LATTICEWORLD_TESTS_LANGUAGE_LOCAL_TINY_MODEL_H_
#define LATTICEWORLD_TESTS_LANGUAGE_LOCAL_TINY_MODEL_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace latticeworld {

// A model of LLaMA's architecture with random weights. Its tokens are the 256 bytes, the printable
// ASCII characters, the newline and some pieces of several letters.
struct TinyModel {
  std::uint32_t weight_type = 0;  // as the format counts them: 0 f32, 1 f16, 8 q8_0
  std::size_t layers = 2;
  std::size_t width = 64;
  std::size_t heads = 4;
  std::size_t kv_heads = 2;
  std::size_t hidden = 96;
  std::size_t context = 4096;
  bool ties_output = false;  // the embeddings serve as output weights
  bool adds_space = false;
  std::size_t end_token = 2;         // the number of the token that ends texts
  std::optional<float> guidance;     // what the file says of it
  bool sees = false;                 // the same: it has eyes
  std::string chat_template;         // "": none
  std::vector<std::string> without;  // keys and tensors that are left out
  std::string spoilt;                // a tensor whose weights are all the same
  float spoilt_with = 1.0f;          // these; not 0
  std::uint64_t seed = 1;
};

// The bytes of its GGUF file.
std::string TinyGguf(const TinyModel& model);

// A file in a folder of its own, removed with the object.
class ModelFile {
 public:
  explicit ModelFile(const std::string& content);
  ~ModelFile();
  ModelFile(const ModelFile&) = delete;
  ModelFile& operator=(const ModelFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_LOCAL_TINY_MODEL_H_
