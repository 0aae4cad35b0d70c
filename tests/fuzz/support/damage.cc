#include "fuzz/support/damage.h"

#include <algorithm>
#include <cstddef>
#include <random>
#include <string_view>

namespace latticeworld::fuzz {
namespace {

constexpr int kMostDamages = 4;
constexpr std::size_t kMostCopied = 64;

constexpr std::string_view kNumbers[] = {
    "-1",  "0",     "255",     "65536", "2147483648", "4294967296", "-9223372036854775808",
    "1e9", "1e308", "1e99999", "-0.0",  "nan",        "inf",        "18446744073709551616",
    "007", "0x10",  "1.0e-320"};
constexpr std::string_view kTokens[] = {"\"", "{", "}",  "[",    "]",        ",",        ":",
                                        "\n", " ", "\\", "\xff", "\xed\xa0", "\xef\xbb", "null",
                                        "%s", "#", "//", "../",  "&a",       "*a",       "\r\n"};

class Damager {
 public:
  Damager(const std::vector<std::string>& others, std::uint64_t seed)
      : others_(others), random_(seed) {}

  void Damage(std::string* bytes) {
    switch (Draw(9)) {
      case 0:
        return TurnBit(bytes);
      case 1:
        return SetByte(bytes);
      case 2:
        return SetInteger(bytes);
      case 3:
        return GrowNumber(bytes);
      case 4:
        return CutOut(bytes);
      case 5:
        return bytes->resize(Draw(bytes->size() + 1));
      case 6:
        return Copy(*bytes, bytes);
      case 7:
        return Copy(others_[Draw(others_.size())], bytes);
      default:
        bytes->insert(Draw(bytes->size() + 1), kTokens[Draw(std::size(kTokens))]);
    }
  }

  // In [0, end), or 0. No std::uniform_int_distribution, whose numbers differ between libraries.
  std::size_t Draw(std::size_t end) { return end == 0 ? 0 : random_() % end; }

 private:
  void TurnBit(std::string* bytes) {
    if (!bytes->empty()) (*bytes)[Draw(bytes->size())] ^= static_cast<char>(1 << Draw(8));
  }

  void SetByte(std::string* bytes) {
    if (!bytes->empty()) (*bytes)[Draw(bytes->size())] = static_cast<char>(Draw(256));
  }

  // An integer of two to eight bytes, as lengths and counts of binary files are: all ones, all
  // zeros, the largest with a sign, or a small one, in either order of bytes.
  void SetInteger(std::string* bytes) {
    const std::size_t width = std::size_t{2} << Draw(3);
    if (bytes->size() < width) return;
    std::string value(width, Draw(2) == 0 ? '\xff' : '\0');
    if (Draw(2) == 0) value[0] = value[0] == '\0' ? static_cast<char>(Draw(16)) : '\x7f';
    if (Draw(2) == 0) std::reverse(value.begin(), value.end());
    bytes->replace(Draw(bytes->size() - width + 1), width, value);
  }

  // Another number in the place of one that is written in digits.
  void GrowNumber(std::string* bytes) {
    constexpr std::string_view kDigits = "0123456789";
    std::size_t begin = bytes->find_first_of(kDigits, Draw(bytes->size() + 1));
    if (begin == std::string::npos) begin = bytes->find_first_of(kDigits);
    if (begin == std::string::npos) return;
    const std::size_t end = bytes->find_first_not_of("0123456789.eE+-", begin);
    const std::size_t length = (end == std::string::npos ? bytes->size() : end) - begin;
    bytes->replace(begin, length, kNumbers[Draw(std::size(kNumbers))]);
  }

  void CutOut(std::string* bytes) { bytes->erase(Draw(bytes->size() + 1), 1 + Draw(kMostCopied)); }

  // A part of one input put into another or over it.
  void Copy(const std::string& from, std::string* bytes) {
    const std::string part = from.substr(Draw(from.size() + 1), 1 + Draw(kMostCopied));
    const std::size_t at = Draw(bytes->size() + 1);
    bytes->replace(at, Draw(2) == 0 ? part.size() : 0, part);
  }

  const std::vector<std::string>& others_;
  std::mt19937_64 random_;
};

}  // namespace

std::string Damaged(const std::string& input, const std::vector<std::string>& others,
                    std::uint64_t seed) {
  Damager damager(others, seed);
  std::string bytes = input;
  const std::size_t damages = 1 + damager.Draw(kMostDamages);
  for (std::size_t i = 0; i < damages; ++i) damager.Damage(&bytes);
  return bytes;
}

}  // namespace latticeworld::fuzz
