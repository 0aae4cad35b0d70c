#include "latticeworld/generation/fords.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

template <std::size_t kCount>
bool IsOneOf(const std::string& word, const std::array<std::string_view, kCount>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

bool AsksForFords(std::string_view instruction) {
  constexpr std::array<std::string_view, 4> kFords = {"ford", "fords", "forded", "fording"};
  constexpr std::array<std::string_view, 4> kDenials = {"no", "not", "without", "never"};
  constexpr std::array<std::string_view, 3> kBetween = {"a", "any", "the"};
  std::string letters = ToLowerAscii(instruction);
  for (char& letter : letters) {
    if (std::isalpha(static_cast<unsigned char>(letter)) == 0) letter = ' ';
  }
  std::string before;
  for (const std::string& word : Split(letters, ' ')) {
    if (word.empty()) continue;
    if (IsOneOf(word, kFords) && !IsOneOf(before, kDenials)) return true;
    if (!IsOneOf(word, kBetween)) before = word;
  }
  return false;
}

}  // namespace latticeworld
