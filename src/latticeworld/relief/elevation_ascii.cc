// Arc/Info ASCII grid, as Esri describes it: pairs of a key and a value, then numbers from the
// north-west row by row.
#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/elevation_format.h"

namespace latticeworld::internal {
namespace {

constexpr char kWhat[] = "the Arc/Info ASCII grid ";

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Words {
 public:
  explicit Words(std::string_view bytes) : rest_(bytes) {}

  // The next one; empty at the end.
  std::string_view Next() {
    std::size_t begin = 0;
    while (begin < rest_.size() && IsSpace(rest_[begin])) ++begin;
    std::size_t end = begin;
    while (end < rest_.size() && !IsSpace(rest_[end])) ++end;
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }

 private:
  std::string_view rest_;
};

// Takes what C's strtod takes in the "C" locale, in decimal.
bool IsNumber(std::string_view word) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  return result.ptr == end && result.ec != std::errc::invalid_argument;
}

struct Header {
  std::int64_t cols = -1;
  std::int64_t rows = -1;
  std::string_view first;  // number after it
};

Result<Header> ReadHeader(Words* words) {
  constexpr int kMostKeys = 16;
  Header header;
  for (int i = 0; i < kMostKeys; ++i) {
    const std::string_view key = words->Next();
    if (key.empty() || IsNumber(key)) {
      header.first = key;
      break;
    }
    const std::string name = ToLowerAscii(key);
    const std::string_view value = words->Next();
    if (!IsNumber(value)) {
      return InvalidArgument(kWhat + ("has " + Quote(key)) + " " + Quote(value) +
                             " in its header; legal there is a key and a number");
    }
    if (name != "ncols" && name != "nrows") continue;
    std::int64_t side = -1;
    const auto result = std::from_chars(value.data(), value.data() + value.size(), side);
    if (result.ec != std::errc() || result.ptr != value.data() + value.size()) {
      return InvalidArgument(kWhat + ("has " + name) + " " + Quote(value) + "; legal is 2 to " +
                             std::to_string(kMaxDataSide));
    }
    (name == "ncols" ? header.cols : header.rows) = side;
  }
  if (header.cols < 0 || header.rows < 0) {
    return InvalidArgument(kWhat + std::string(header.cols < 0 ? "has no ncols" : "has no nrows") +
                           " in its header; legal are ncols, nrows, xllcorner, yllcorner, cellsize "
                           "and NODATA_value, each with a number");
  }
  return header;
}

}  // namespace

Status CheckArcAscii(std::string_view bytes) {
  Words words(bytes);
  LW_ASSIGN_OR_RETURN(const Header header, ReadHeader(&words));
  LW_RETURN_IF_ERROR(CheckDataSize(header.cols, header.rows));
  const std::int64_t needed = header.cols * header.rows;
  std::int64_t found = 0;
  for (std::string_view word = header.first; !word.empty(); word = words.Next()) {
    ++found;
    if (!IsNumber(word)) {
      return InvalidArgument(kWhat + ("has " + Quote(word)) + " in place of number " +
                             std::to_string(found));
    }
    if (found > needed) break;
  }
  if (found == needed) return Status();
  return InvalidArgument(kWhat + ("of " + std::to_string(header.cols)) + " x " +
                         std::to_string(header.rows) + " samples needs " + std::to_string(needed) +
                         " numbers and has " +
                         (found > needed ? "more" : std::to_string(found) + ": it is cut off"));
}

}  // namespace latticeworld::internal
