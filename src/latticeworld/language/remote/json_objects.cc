#include "latticeworld/language/remote/json_objects.h"

#include <cstddef>

namespace latticeworld {
namespace {

// Objects of an answer that are looked at: hostile text cannot make the search long.
constexpr int kMostObjects = 16;

// The end of the object that begins at `begin` (one past its brace), or npos where it is cut.
std::size_t EndOfObject(std::string_view text, std::size_t begin) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return i + 1;
    }
  }
  return std::string_view::npos;
}

}  // namespace

std::vector<std::string_view> ObjectsIn(std::string_view text) {
  std::vector<std::string_view> objects;
  std::size_t at = 0;
  for (int i = 0; i < kMostObjects; ++i) {
    const std::size_t begin = text.find('{', at);
    if (begin == std::string_view::npos) break;
    const std::size_t end = EndOfObject(text, begin);
    objects.push_back(text.substr(begin, end - begin));
    // A brace of prose swallows all that follows: what stands within is looked at too.
    at = end == std::string_view::npos ? begin + 1 : end;
  }
  return objects;
}

}  // namespace latticeworld
