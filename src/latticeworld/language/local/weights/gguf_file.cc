#include "latticeworld/language/local/weights/gguf_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "latticeworld/language/local/weights/gguf_reader.h"

namespace latticeworld {
namespace {

// What the names of tensors and keys, sizes and offsets take at the least.
constexpr std::size_t kLeastEntryBytes = 13, kLeastTensorBytes = 32;
constexpr std::uint64_t kMostValues = std::uint64_t{1} << 40;
constexpr std::uint32_t kMostDimensions = 2;

Status Unopened(const std::string& path) {
  const std::string why = "'" + path + "': " + std::strerror(errno);
  if (errno == EACCES || errno == EPERM) return PermissionDenied(why);
  return NotFound(why);
}

// Bytes of a row; 0 where it cannot be one.
std::size_t RowBytes(GgufType type, std::size_t columns) {
  switch (type) {
    case GgufType::kFloat32:
      return columns * 4;
    case GgufType::kFloat16:
      return columns * 2;
    case GgufType::kQ4_1:
      return columns % kQ8BlockValues != 0 ? 0 : columns / kQ8BlockValues * kQ4BlockBytes;
    case GgufType::kQ8_0:
      return columns % kQ8BlockValues != 0 ? 0 : columns / kQ8BlockValues * kQ8BlockBytes;
  }
  return 0;
}

std::string Shape(std::size_t rows, std::size_t columns) {
  return std::to_string(rows) + " x " + std::to_string(columns);
}

struct Entry {
  std::string name;
  GgufTensor tensor;
  std::uint64_t offset = 0;
};

Entry ReadEntry(GgufReader* reader) {
  constexpr const char* kWhat = "what a tensor is";
  Entry entry;
  entry.name = reader->String("the name of a tensor");
  const auto dimensions = reader->Take<std::uint32_t>(kWhat);
  if (dimensions < 1 || dimensions > kMostDimensions) {
    reader->Fail("tensor '" + entry.name + "' has " + std::to_string(dimensions) +
                 " dimensions; legal are 1 and 2");
    return entry;
  }
  std::uint64_t sizes[kMostDimensions] = {1, 1};
  for (std::uint32_t i = 0; i < dimensions; ++i) sizes[i] = reader->Take<std::uint64_t>(kWhat);
  const auto type = reader->Take<std::uint32_t>(kWhat);
  entry.offset = reader->Take<std::uint64_t>(kWhat);
  if (sizes[0] < 1 || sizes[1] < 1 || sizes[0] > kMostValues || sizes[1] > kMostValues / sizes[0])
    reader->Fail("tensor '" + entry.name + "' is of a size that cannot be");
  if (type != 0 && type != 1 && type != 3 && type != 8)
    reader->Fail("tensor '" + entry.name + "' is of type " + std::to_string(type) +
                 "; read here are 0 (f32), 1 (f16), 3 (q4_1) and 8 (q8_0)");
  entry.tensor.type = static_cast<GgufType>(type);
  entry.tensor.columns = sizes[0];
  entry.tensor.rows = sizes[1];
  return entry;
}

}  // namespace

Result<GgufFile> GgufFile::Open(const std::string& path) {
  // O_NONBLOCK keeps this from waiting for a writer if the path names a pipe.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return Unopened(path);
  struct stat about {};
  if (::fstat(file, &about) != 0 || !S_ISREG(about.st_mode)) {
    ::close(file);
    return InvalidArgument("'" + path + "' is no regular file");
  }
  const auto size = static_cast<std::size_t>(about.st_size);
  void* begin = size == 0 ? MAP_FAILED : ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  ::close(file);
  if (size == 0) return DataLoss("'" + path + "' is empty");
  if (begin == MAP_FAILED) return Unopened(path);
  GgufFile opened(static_cast<const std::byte*>(begin), size);
  if (Status status = opened.Read(); !status.ok()) return status.WithContext("'" + path + "'");
  return opened;
}

GgufFile::~GgufFile() {
  if (begin_ != nullptr) ::munmap(const_cast<std::byte*>(begin_), size_);
}

GgufFile::GgufFile(GgufFile&& other) noexcept
    : begin_(std::exchange(other.begin_, nullptr)),
      size_(other.size_),
      metadata_(std::move(other.metadata_)),
      tensors_(std::move(other.tensors_)) {}

Status GgufFile::Read() {
  GgufReader reader(begin_, size_);
  // The head tells the name, the version, and how much follows.
  if (size_ < 4 || std::memcmp(begin_, "GGUF", 4) != 0)
    return DataLoss("no GGUF: it does not begin with these four letters");
  reader.Take<std::uint32_t>("the format's name");
  const auto version = reader.Take<std::uint32_t>("the version");
  if (reader.status().ok() && version != 2 && version != 3)
    return DataLoss("GGUF of version " + std::to_string(version) +
                    "; read here are 2 and 3, little endian");
  const std::uint64_t tensor_count = reader.Count(kLeastTensorBytes, "tensors");
  const std::uint64_t key_count = reader.Count(kLeastEntryBytes, "keys");
  // Metadata and the list of tensors follow one another; the reader keeps the first error.
  for (std::uint64_t i = 0; i < key_count && reader.status().ok(); ++i) {
    std::string key = reader.String("a key of the metadata");
    Value value = reader.Value();
    if (!metadata_.emplace(key, std::move(value)).second)
      reader.Fail("the key '" + key + "' comes twice");
  }
  std::vector<Entry> entries;
  for (std::uint64_t i = 0; i < tensor_count && reader.status().ok(); ++i)
    entries.push_back(ReadEntry(&reader));
  LW_RETURN_IF_ERROR(reader.status());

  // The tensors' bytes begin at the next multiple of the alignment.
  std::uint64_t alignment = 32;
  if (Has("general.alignment")) {
    LW_ASSIGN_OR_RETURN(alignment, Integer("general.alignment", 8, 1u << 20));
    if ((alignment & (alignment - 1)) != 0)
      return DataLoss("general.alignment is " + std::to_string(alignment) +
                      "; legal are powers of two");
  }
  const std::size_t data = (reader.offset() + alignment - 1) / alignment * alignment;
  // Each tensor must lie within the file before its place is kept.
  for (Entry& entry : entries) {
    const std::size_t row_bytes = RowBytes(entry.tensor.type, entry.tensor.columns);
    if (row_bytes == 0)
      return DataLoss("tensor '" + entry.name + "' has rows of " +
                      std::to_string(entry.tensor.columns) +
                      " values; q4_1 and q8_0 need multiples of 32");
    if (data > size_ || entry.offset % alignment != 0 || entry.offset > size_ - data ||
        entry.tensor.rows > (size_ - data - entry.offset) / row_bytes)
      return DataLoss("tensor '" + entry.name + "' (" +
                      Shape(entry.tensor.rows, entry.tensor.columns) +
                      ") does not lie within the file");
    entry.tensor.data = begin_ + data + entry.offset;
    if (!tensors_.emplace(entry.name, entry.tensor).second)
      return DataLoss("the tensor '" + entry.name + "' comes twice");
  }
  return Status();
}

Result<std::uint64_t> GgufFile::Integer(std::string_view key, std::uint64_t low,
                                        std::uint64_t high) const {
  const auto found = metadata_.find(key);
  if (found == metadata_.end()) return DataLoss("the key '" + std::string(key) + "' is missing");
  std::uint64_t number = 0;
  if (const auto* whole = std::get_if<std::uint64_t>(&found->second)) {
    number = *whole;
  } else if (const auto* with_sign = std::get_if<std::int64_t>(&found->second);
             with_sign != nullptr && *with_sign >= 0) {
    number = static_cast<std::uint64_t>(*with_sign);
  } else {
    return DataLoss("'" + std::string(key) + "' is no whole number from 0 on");
  }
  if (number < low || number > high)
    return DataLoss("'" + std::string(key) + "' is " + std::to_string(number) + "; legal are " +
                    std::to_string(low) + " to " + std::to_string(high));
  return number;
}

Result<double> GgufFile::Number(std::string_view key) const {
  const auto found = metadata_.find(key);
  if (found == metadata_.end()) return DataLoss("the key '" + std::string(key) + "' is missing");
  if (const auto* number = std::get_if<double>(&found->second)) return *number;
  return DataLoss("'" + std::string(key) + "' is no floating point number");
}

Result<std::string> GgufFile::Text(std::string_view key) const {
  const auto found = metadata_.find(key);
  if (found == metadata_.end()) return DataLoss("the key '" + std::string(key) + "' is missing");
  if (const auto* text = std::get_if<std::string>(&found->second)) return *text;
  return DataLoss("'" + std::string(key) + "' is no text");
}

Result<GgufTensor> GgufFile::Tensor(std::string_view name, std::size_t rows,
                                    std::size_t columns) const {
  const auto found = tensors_.find(name);
  if (found == tensors_.end()) return DataLoss("the tensor '" + std::string(name) + "' is missing");
  const GgufTensor& tensor = found->second;
  if (tensor.rows != rows || tensor.columns != columns)
    return DataLoss("the tensor '" + std::string(name) + "' is " +
                    Shape(tensor.rows, tensor.columns) + ", where " + Shape(rows, columns) +
                    " is needed");
  return tensor;
}

void GgufFile::Release(const GgufTensor& tensor) const {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const auto begin = static_cast<std::size_t>(tensor.data - begin_);
  const std::size_t end = begin + tensor.rows * RowBytes(tensor.type, tensor.columns);
  // Pages at its ends hold what lies beside it.
  const std::size_t first = (begin + page - 1) / page * page;
  const std::size_t last = end / page * page;
  if (first < last) ::madvise(const_cast<std::byte*>(begin_) + first, last - first, MADV_DONTNEED);
}

}  // namespace latticeworld
