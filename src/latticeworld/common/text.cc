#include "latticeworld/common/text.h"

#include <charconv>
#include <cmath>

namespace latticeworld {
namespace {

// Length of the well-formed UTF-8 sequence at `offset` (RFC 3629, table in section 4), 0 if none.
std::size_t SequenceLength(std::string_view text, std::size_t offset) {
  const auto byte = [&](std::size_t i) {
    return offset + i < text.size() ? static_cast<unsigned char>(text[offset + i]) : 0;
  };
  const auto within = [&](std::size_t i, int low, int high) {
    return byte(i) >= low && byte(i) <= high;
  };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  if (within(0, 0xC2, 0xDF)) return within(1, 0x80, 0xBF) ? 2 : 0;
  if (within(0, 0xE0, 0xEF)) {
    const int low = lead == 0xE0 ? 0xA0 : 0x80;
    const int high = lead == 0xED ? 0x9F : 0xBF;
    return within(1, low, high) && within(2, 0x80, 0xBF) ? 3 : 0;
  }
  if (within(0, 0xF0, 0xF4)) {
    const int low = lead == 0xF0 ? 0x90 : 0x80;
    const int high = lead == 0xF4 ? 0x8F : 0xBF;
    return within(1, low, high) && within(2, 0x80, 0xBF) && within(3, 0x80, 0xBF) ? 4 : 0;
  }
  return 0;
}

}  // namespace

Status ValidateText(std::string_view what, std::string_view text, std::size_t max_bytes) {
  if (text.size() > max_bytes) {
    return InvalidArgument(std::string(what) + " is " + std::to_string(text.size()) +
                           " bytes long; at most " + std::to_string(max_bytes) + " are legal");
  }
  for (std::size_t offset = 0; offset < text.size();) {
    if (text[offset] == '\0') {
      return InvalidArgument(std::string(what) + " has a NUL character at byte " +
                             std::to_string(offset) + "; it must be text");
    }
    const std::size_t length = SequenceLength(text, offset);
    if (length == 0) {
      return InvalidArgument(std::string(what) + " is not valid UTF-8 at byte " +
                             std::to_string(offset));
    }
    offset += length;
  }
  return Status();
}

std::string ToLowerAscii(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::vector<std::string> Split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string_view::npos;
       end = text.find(separator, begin)) {
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.emplace_back(text.substr(begin));
  return parts;
}

std::string Join(const std::vector<std::string>& parts, std::string_view separator) {
  std::string joined;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) joined += separator;
    joined += parts[i];
  }
  return joined;
}

std::string FormatDouble(double value) {
  if (std::isnan(value)) return "nan";
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, result.ptr);
}

std::string Quote(std::string_view text, std::size_t max_bytes) {
  std::string quoted = "\"";
  std::size_t offset = 0;
  while (offset < text.size()) {
    const std::size_t length = SequenceLength(text, offset);
    if (offset + std::max<std::size_t>(length, 1) > max_bytes) break;
    const unsigned char lead = static_cast<unsigned char>(text[offset]);
    if (length == 0 || lead < 0x20 || lead == 0x7F) {
      static constexpr char kDigits[] = "0123456789abcdef";
      quoted += "\\x";
      quoted += kDigits[lead >> 4];
      quoted += kDigits[lead & 15];
      ++offset;
    } else {
      quoted += text.substr(offset, length);
      offset += length;
    }
  }
  quoted += offset < text.size() ? "...\"" : "\"";
  return quoted;
}

}  // namespace latticeworld
