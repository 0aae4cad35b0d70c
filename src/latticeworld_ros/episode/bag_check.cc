#include "latticeworld_ros/episode/bag_check.h"

#include <bzlib.h>
#include <roslz4/lz4s.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// http://wiki.ros.org/Bags/Format/2.0: a line, then records of a header and data, each preceded by
// its length, little endian. A header is fields, each preceded by its length: NAME=VALUE.
constexpr std::string_view kFirstLine = "#ROSBAG V2.0\n";
constexpr std::uint32_t kMostHeaderBytes = 1u << 20;
constexpr std::uint32_t kMostChunkBytes = 1u << 30;
constexpr std::uint32_t kIndexEntryBytes = 12, kChunkInfoEntryBytes = 8;
enum Op : unsigned char {
  kMessage = 2,
  kFileHeader = 3,
  kIndex = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7
};

template <typename Number>
Number NumberOf(std::string_view bytes) {
  Number number = 0;
  for (std::size_t i = sizeof(Number); i-- > 0;) {
    number = static_cast<Number>(number << 8 | static_cast<unsigned char>(bytes[i]));
  }
  return number;
}

// The fields of a header by their names; nullopt: it is none.
using Fields = std::map<std::string, std::string, std::less<>>;
std::optional<Fields> FieldsOf(std::string_view header) {
  Fields fields;
  while (!header.empty()) {
    if (header.size() < 4) return std::nullopt;
    const auto length = NumberOf<std::uint32_t>(header);
    header.remove_prefix(4);
    if (length > header.size()) return std::nullopt;
    const std::string_view field = header.substr(0, length);
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    fields[std::string(field.substr(0, equals))] = std::string(field.substr(equals + 1));
    header.remove_prefix(length);
  }
  return fields;
}

template <typename Number>
std::optional<Number> NumberIn(const Fields& fields, std::string_view name) {
  const auto found = fields.find(name);
  if (found == fields.end() || found->second.size() != sizeof(Number)) return std::nullopt;
  return NumberOf<Number>(found->second);
}

std::optional<unsigned char> OpOf(const Fields& fields) {
  return NumberIn<unsigned char>(fields, "op");
}

// Where the records of a chunk begin, each with the op of the record.
using ChunkRecords = std::map<std::uint32_t, unsigned char>;

std::optional<ChunkRecords> RecordsIn(std::string_view chunk) {
  ChunkRecords records;
  std::size_t at = 0;
  const auto take = [&chunk, &at](std::string_view* bytes) {
    if (chunk.size() - at < 4) return false;
    const auto length = NumberOf<std::uint32_t>(chunk.substr(at));
    at += 4;
    if (length > chunk.size() - at) return false;
    *bytes = chunk.substr(at, length);
    at += length;
    return true;
  };
  while (at < chunk.size()) {
    const auto begin = static_cast<std::uint32_t>(at);
    std::string_view header, data;
    if (!take(&header) || !take(&data)) return std::nullopt;
    const auto fields = FieldsOf(header);
    const auto op = fields ? OpOf(*fields) : std::nullopt;
    if (op != kMessage && op != kConnection) return std::nullopt;
    records[begin] = *op;
  }
  return records;
}

// What a chunk holds; nullopt: it does not unpack to that size.
std::optional<std::string> Unpacked(std::string packed, const std::string& compression,
                                    std::uint32_t size) {
  if (compression == "none") {
    return size == packed.size() ? std::optional(std::move(packed)) : std::nullopt;
  }
  std::string chunk(size, '\0');
  unsigned length = size;
  if (compression == "lz4") {
    const int result = roslz4_buffToBuffDecompress(
        packed.data(), static_cast<unsigned>(packed.size()), chunk.data(), &length);
    return result == ROSLZ4_OK && length == size ? std::optional(std::move(chunk)) : std::nullopt;
  }
  const int result = BZ2_bzBuffToBuffDecompress(chunk.data(), &length, packed.data(),
                                                static_cast<unsigned>(packed.size()), 0, 0);
  return result == BZ_OK && length == size ? std::optional(std::move(chunk)) : std::nullopt;
}

class BagChecker {
 public:
  explicit BagChecker(const std::filesystem::path& bag) : in_(bag, std::ios::binary) {
    in_.seekg(0, std::ios::end);
    size_ = in_ ? static_cast<std::uint64_t>(in_.tellg()) : 0;
  }

  Status Check() {
    if (!in_) return NotFound("cannot be read");
    if (!Holds(kFirstLine.size()) || Bytes(kFirstLine.size()) != kFirstLine) {
      return Wrong("it does not begin with " + Quote(kFirstLine));
    }
    LW_ASSIGN_OR_RETURN(const Record first, ReadRecord());
    if (first.op != kFileHeader) return Wrong("its first record is no file header");
    const auto index = NumberIn<std::uint64_t>(first.fields, "index_pos");
    if (!index) return Wrong("its header has no index_pos");
    if (*index == 0) return Status();
    const auto encryptor = first.fields.find("encryptor");
    if (encryptor != first.fields.end() && !encryptor->second.empty() &&
        encryptor->second != "rosbag/NoEncryptor") {
      return Wrong("it is encrypted by " + Quote(encryptor->second));
    }
    std::set<std::uint64_t> begins;
    while (at_ < size_) {
      begins.insert(at_);
      LW_RETURN_IF_ERROR(CheckRecord());
    }
    if (begins.count(*index) == 0 && *index != size_)
      return Wrong("its index is not where it says");
    for (const std::uint64_t chunk : wanted_chunks_) {
      if (chunks_.count(chunk) == 0) return Wrong("its index names a chunk that is none");
    }
    return Status();
  }

 private:
  struct Record {
    Fields fields;
    unsigned char op = 0;
    std::uint64_t data = 0;        // where its data begins
    std::uint32_t data_bytes = 0;  // how long it is
  };

  bool Holds(std::uint64_t bytes) const { return bytes <= size_ - at_; }
  std::string Bytes(std::uint64_t count) {
    std::string bytes(count, '\0');
    in_.seekg(static_cast<std::streamoff>(at_));
    in_.read(bytes.data(), static_cast<std::streamsize>(count));
    at_ += count;
    return bytes;
  }
  Status Wrong(const std::string& what) const {
    return DataLoss("byte " + std::to_string(at_) + ": " + what);
  }

  // Reads the record that begins here, but for its data, and goes to its end.
  Result<Record> ReadRecord() {
    if (!Holds(4)) return Wrong("a record is cut off");
    const auto header_bytes = NumberOf<std::uint32_t>(Bytes(4));
    if (header_bytes > kMostHeaderBytes || !Holds(std::uint64_t{header_bytes} + 4)) {
      return Wrong("a header of " + std::to_string(header_bytes) + " bytes");
    }
    const auto fields = FieldsOf(Bytes(header_bytes));
    const auto op = fields ? OpOf(*fields) : std::nullopt;
    if (!op) return Wrong("a header is damaged");
    Record record{*fields, *op, 0, NumberOf<std::uint32_t>(Bytes(4))};
    record.data = at_;
    if (!Holds(record.data_bytes)) return Wrong("the data of a record is cut off");
    at_ += record.data_bytes;
    return record;
  }

  std::string DataOf(const Record& record) {
    at_ = record.data;
    return Bytes(record.data_bytes);
  }

  Status CheckRecord() {
    const std::uint64_t begin = at_;
    LW_ASSIGN_OR_RETURN(const Record record, ReadRecord());
    switch (record.op) {
      case kChunk:
        chunks_.insert(begin);
        return CheckChunk(record);
      case kIndex:
        return CheckIndex(record);
      case kChunkInfo:
        return CheckChunkInfo(record);
      case kConnection:
        return FieldsOf(DataOf(record)) ? Status() : Wrong("a connection is damaged");
      default:
        return Wrong("a record of kind " + std::to_string(record.op));
    }
  }

  Status CheckChunk(const Record& record) {
    const auto size = NumberIn<std::uint32_t>(record.fields, "size");
    const auto compression = record.fields.find("compression");
    const bool known = compression != record.fields.end() &&
                       (compression->second == "none" || compression->second == "lz4" ||
                        compression->second == "bz2");
    if (!size || !known) return Wrong("a chunk lacks its size, or a compression that is known");
    // A byte of LZ4 unpacks to 255 at most, one of bz2 to some 20000.
    const std::uint64_t most =
        std::uint64_t{record.data_bytes} * (compression->second == "bz2" ? 32768 : 256) +
        kMostHeaderBytes;
    if (*size > kMostChunkBytes || record.data_bytes > kMostChunkBytes || *size > most) {
      return Wrong("a chunk of " + std::to_string(*size) + " bytes");
    }
    const auto chunk = Unpacked(DataOf(record), compression->second, *size);
    if (!chunk) return Wrong("a chunk does not unpack to " + std::to_string(*size) + " bytes");
    auto records = RecordsIn(*chunk);
    if (!records) return Wrong("the records of a chunk do not lie within it");
    records_ = *std::move(records);
    return Status();
  }

  // Of the last chunk. rosbag looks for the first message at or after the place of an entry.
  Status CheckIndex(const Record& record) {
    const auto count = NumberIn<std::uint32_t>(record.fields, "count");
    if (!count || std::uint64_t{*count} * kIndexEntryBytes != record.data_bytes) {
      return Wrong("an index is not as long as it says");
    }
    const std::string data = DataOf(record);
    for (std::size_t at = 0; at < data.size(); at += kIndexEntryBytes) {
      auto found = records_.find(NumberOf<std::uint32_t>(std::string_view(data).substr(at + 8)));
      while (found != records_.end() && found->second != kMessage) ++found;
      if (found == records_.end()) return Wrong("an index leads to no message");
    }
    return Status();
  }

  Status CheckChunkInfo(const Record& record) {
    const auto count = NumberIn<std::uint32_t>(record.fields, "count");
    const auto chunk = NumberIn<std::uint64_t>(record.fields, "chunk_pos");
    if (!chunk || !count || std::uint64_t{*count} * kChunkInfoEntryBytes != record.data_bytes) {
      return Wrong("what is said of a chunk is not as long as it says");
    }
    wanted_chunks_.insert(*chunk);
    return Status();
  }

  std::ifstream in_;
  std::uint64_t size_ = 0, at_ = 0;
  ChunkRecords records_;  // of the last chunk
  std::set<std::uint64_t> chunks_, wanted_chunks_;
};

}  // namespace

Status CheckBag(const std::filesystem::path& bag) { return BagChecker(bag).Check(); }

}  // namespace latticeworld
