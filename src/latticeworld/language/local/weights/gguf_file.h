#ifndef LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_GGUF_FILE_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_GGUF_FILE_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

// How the numbers of a tensor are stored; the values are those of the format.
enum class GgufType : std::uint32_t {
  kFloat32 = 0,
  kFloat16 = 1,
  kQ4_1 = 3,  // blocks of 32: a float16 step, a float16 least value and 32 half bytes
  kQ8_0 = 8,  // blocks of 32: a float16 scale and 32 int8
};
inline constexpr std::size_t kQ8BlockValues = 32;
inline constexpr std::size_t kQ8BlockBytes = 34;
inline constexpr std::size_t kQ4BlockBytes = 20;

// Row-major: `columns` runs fastest. A vector has one row.
struct GgufTensor {
  GgufType type = GgufType::kFloat32;
  std::size_t rows = 0;
  std::size_t columns = 0;
  const std::byte* data = nullptr;  // within the file; 32-byte steps from its data's beginning
};

// A model file in the format GGUF, version 2 or 3, little endian
// (https://github.com/ggml-org/ggml/blob/master/docs/gguf.md), mapped into
// memory. Everything in it is checked against the file's length before anybody
// reads it.
class GgufFile {
 public:
  using Value = std::variant<bool, std::uint64_t, std::int64_t, double, std::string,
                             std::vector<double>, std::vector<std::string>>;

  // Errors: NOT_FOUND, PERMISSION_DENIED, INVALID_ARGUMENT (no regular file);
  // DATA_LOSS, naming the place in the file: no GGUF, cut short, sizes that
  // cannot be, tensors beyond the end or of more than two dimensions or of a
  // type that is not read here (naming those that are).
  static Result<GgufFile> Open(const std::string& path);
  ~GgufFile();
  GgufFile(GgufFile&& other) noexcept;
  GgufFile& operator=(GgufFile&&) = delete;

  const std::map<std::string, Value, std::less<>>& metadata() const { return metadata_; }
  const std::map<std::string, GgufTensor, std::less<>>& tensors() const { return tensors_; }

  // Errors: DATA_LOSS naming the key where it is absent or of another kind, or
  // not in the range.
  Result<std::uint64_t> Integer(std::string_view key, std::uint64_t low, std::uint64_t high) const;
  Result<double> Number(std::string_view key) const;
  Result<std::string> Text(std::string_view key) const;
  bool Has(std::string_view key) const { return metadata_.find(key) != metadata_.end(); }
  // Errors: DATA_LOSS where there is none of that name and shape, saying what
  // there is.
  Result<GgufTensor> Tensor(std::string_view name, std::size_t rows, std::size_t columns) const;
  // Gives the memory of a tensor back to the system, for one that was copied: else a model would be
  // held twice as it is read. Whoever looks at it again reads the file again.
  void Release(const GgufTensor& tensor) const;

 private:
  GgufFile(const std::byte* begin, std::size_t size) : begin_(begin), size_(size) {}
  Status Read();

  const std::byte* begin_ = nullptr;  // null: moved from
  std::size_t size_ = 0;
  std::map<std::string, Value, std::less<>> metadata_;
  std::map<std::string, GgufTensor, std::less<>> tensors_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_GGUF_FILE_H_
