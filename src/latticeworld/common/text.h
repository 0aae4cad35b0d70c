#ifndef LATTICEWORLD_COMMON_TEXT_H_
#define LATTICEWORLD_COMMON_TEXT_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/status.h"

namespace latticeworld {

// OK when text is valid UTF-8 (RFC 3629) of at most max_bytes without NUL; else INVALID_ARGUMENT
// that names `what`, the byte offset or the length given, and the limit.
Status ValidateText(std::string_view what, std::string_view text, std::size_t max_bytes);

inline bool StartsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}
inline bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

std::string ToLowerAscii(std::string_view text);
std::vector<std::string> Split(std::string_view text, char separator);
std::string Join(const std::vector<std::string>& parts, std::string_view separator);

// Shortest text that reads back as the same double ("0.5", "nan", "inf").
std::string FormatDouble(double value);

// text, cut to at most max_bytes at a character boundary with "..." where cut, control characters
// escaped: safe to quote in a message.
std::string Quote(std::string_view text, std::size_t max_bytes = 80);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_TEXT_H_
