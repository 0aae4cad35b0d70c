#include "latticeworld/language/local/tokens/byte_pairs.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
};

// The character that begins there; a byte that begins none stands for itself.
Character CharacterAt(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const std::uint32_t first = byte(at);
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
  if (bytes == 1) return {first, 1};
  std::uint32_t code = first & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(at + i) & 0xC0u) != 0x80u) return {first, 1};
    code = code << 6 | (byte(at + i) & 0x3Fu);
  }
  return {code, bytes};
}

enum class Sort { kLetter, kNumber, kSpace, kOther };

struct Block {
  std::uint32_t first;
  std::uint32_t last;
  Sort sort;
};
// Beyond ASCII; what lies in none of them is a letter.
constexpr Block kBlocks[] = {
    {0x80, 0x84, Sort::kOther},        {0x85, 0x85, Sort::kSpace},
    {0x86, 0x9F, Sort::kOther},        {0xA0, 0xA0, Sort::kSpace},
    {0xA1, 0xA9, Sort::kOther},        {0xAB, 0xB1, Sort::kOther},
    {0xB2, 0xB3, Sort::kNumber},       {0xB4, 0xB4, Sort::kOther},
    {0xB6, 0xB8, Sort::kOther},        {0xB9, 0xB9, Sort::kNumber},
    {0xBB, 0xBB, Sort::kOther},        {0xBC, 0xBE, Sort::kNumber},
    {0xBF, 0xBF, Sort::kOther},        {0xD7, 0xD7, Sort::kOther},
    {0xF7, 0xF7, Sort::kOther},        {0x2C2, 0x2C5, Sort::kOther},
    {0x2D2, 0x2DF, Sort::kOther},      {0x300, 0x36F, Sort::kOther},
    {0x660, 0x669, Sort::kNumber},     {0x6F0, 0x6F9, Sort::kNumber},
    {0x2000, 0x200A, Sort::kSpace},    {0x200B, 0x2027, Sort::kOther},
    {0x2028, 0x2029, Sort::kSpace},    {0x202A, 0x202E, Sort::kOther},
    {0x202F, 0x202F, Sort::kSpace},    {0x2030, 0x205E, Sort::kOther},
    {0x205F, 0x205F, Sort::kSpace},    {0x2060, 0x206F, Sort::kOther},
    {0x2070, 0x2070, Sort::kNumber},   {0x2074, 0x2079, Sort::kNumber},
    {0x207A, 0x207E, Sort::kOther},    {0x2080, 0x2089, Sort::kNumber},
    {0x208A, 0x208E, Sort::kOther},    {0x20A0, 0x20FF, Sort::kOther},
    {0x2150, 0x2182, Sort::kNumber},   {0x2190, 0x245F, Sort::kOther},
    {0x2460, 0x249B, Sort::kNumber},   {0x249C, 0x2BFF, Sort::kOther},
    {0x2E00, 0x2E7F, Sort::kOther},    {0x3000, 0x3000, Sort::kSpace},
    {0x3001, 0x3004, Sort::kOther},    {0x3008, 0x3020, Sort::kOther},
    {0x3030, 0x3030, Sort::kOther},    {0xFE00, 0xFE0F, Sort::kOther},
    {0xFE30, 0xFE6B, Sort::kOther},    {0xFF01, 0xFF0F, Sort::kOther},
    {0xFF10, 0xFF19, Sort::kNumber},   {0xFF1A, 0xFF20, Sort::kOther},
    {0xFFE0, 0xFFFF, Sort::kOther},    {0x1F000, 0x1FAFF, Sort::kOther},
    {0xE0000, 0x10FFFF, Sort::kOther},
};

Sort SortOf(std::uint32_t code) {
  if (code < 0x80) {
    const bool letter = (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z');
    if (letter) return Sort::kLetter;
    if (code >= '0' && code <= '9') return Sort::kNumber;
    return code == ' ' || (code >= 9 && code <= 13) ? Sort::kSpace : Sort::kOther;
  }
  for (const Block& block : kBlocks)
    if (code >= block.first && code <= block.last) return block.sort;
  return Sort::kLetter;
}

// Bytes of the contraction that begins there ("'s", "'ll"); 0: none does.
std::size_t ContractionAt(std::string_view text) {
  for (const std::string_view each : {"'s", "'t", "'re", "'ve", "'m", "'ll", "'d"})
    if (StartsWith(text, each)) return each.size();
  return 0;
}

// Returns where the run of characters of that sort ends that begins at `at` [bytes].
std::size_t EndOfRun(std::string_view text, std::size_t at, Sort sort) {
  while (at < text.size()) {
    const Character next = CharacterAt(text, at);
    if (SortOf(next.code) != sort) break;
    at += next.bytes;
  }
  return at;
}

// Bytes of the word that a text which is not empty begins with.
std::size_t WordBytes(std::string_view text) {
  if (const std::size_t contraction = ContractionAt(text); contraction > 0) return contraction;
  const std::size_t begin = text[0] == ' ' && text.size() > 1 ? 1 : 0;
  const Sort sort = SortOf(CharacterAt(text, begin).code);
  if (sort != Sort::kSpace) return EndOfRun(text, begin, sort);
  // Blanks: the last one goes to the word behind them.
  const std::size_t end = EndOfRun(text, 0, Sort::kSpace);
  if (end == text.size()) return end;
  std::size_t last = 0;
  for (std::size_t at = 0; at < end; at += CharacterAt(text, at).bytes) last = at;
  return last > 0 ? last : end;
}

// GPT-2's alphabet: printable bytes stand for themselves, the others for characters from 256 on.
std::array<std::uint32_t, 256> ByteAlphabet() {
  std::array<std::uint32_t, 256> alphabet{};
  std::uint32_t next = 256;
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    const bool printable =
        (byte >= 0x21 && byte <= 0x7E) || (byte >= 0xA1 && byte <= 0xAC) || byte >= 0xAE;
    alphabet[byte] = printable ? byte : next++;
  }
  return alphabet;
}

constexpr std::uint64_t Key(TokenId left, TokenId right) {
  return static_cast<std::uint64_t>(left) << 32 | right;
}

}  // namespace

std::string BytesOfPiece(std::string_view piece) {
  static const std::unordered_map<std::uint32_t, char> byte_of = [] {
    std::unordered_map<std::uint32_t, char> bytes;
    const std::array<std::uint32_t, 256> alphabet = ByteAlphabet();
    for (std::size_t byte = 0; byte < 256; ++byte) {
      bytes.emplace(alphabet[byte], static_cast<char>(byte));
    }
    return bytes;
  }();
  std::string bytes;
  for (std::size_t at = 0; at < piece.size();) {
    const Character character = CharacterAt(piece, at);
    const auto found = byte_of.find(character.code);
    if (found == byte_of.end()) return {};
    bytes += found->second;
    at += character.bytes;
  }
  return bytes;
}

std::vector<std::string_view> ByteLevelWords(std::string_view text, bool single_digits) {
  std::vector<std::string_view> words;
  const auto split = [&words](std::string_view part) {
    while (!part.empty()) {
      const std::size_t bytes = WordBytes(part);
      words.push_back(part.substr(0, bytes));
      part.remove_prefix(bytes);
    }
  };
  if (!single_digits) {
    split(text);
    return words;
  }
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size();) {
    const Character character = CharacterAt(text, at);
    if (SortOf(character.code) == Sort::kNumber) {
      split(text.substr(begin, at - begin));
      words.push_back(text.substr(at, character.bytes));
      begin = at + character.bytes;
    }
    at += character.bytes;
  }
  split(text.substr(begin));
  return words;
}

Result<BytePairs> BytePairs::Make(const std::vector<std::string>& pieces,
                                  const std::vector<std::string>& merges, bool single_digits) {
  BytePairs pairs;
  pairs.single_digits_ = single_digits;
  std::unordered_map<std::string_view, TokenId> token_of;
  for (TokenId token = 0; token < pieces.size(); ++token) token_of.emplace(pieces[token], token);
  for (const auto& [piece, token] : token_of) {
    const std::string bytes = BytesOfPiece(piece);
    if (bytes.size() == 1) pairs.of_byte_[static_cast<unsigned char>(bytes[0])] = token;
  }
  for (std::size_t byte = ' '; byte <= '~'; ++byte) {
    if (!pairs.of_byte_[byte].has_value()) {
      return DataLoss("the vocabulary has no token for the byte " + std::to_string(byte));
    }
  }
  for (std::size_t rank = 0; rank < merges.size(); ++rank) {
    const std::string& merge = merges[rank];
    const std::size_t blank = merge.find(' ');
    const auto find = [&](std::string_view piece) {
      const auto found = token_of.find(piece);
      return found == token_of.end() ? std::numeric_limits<TokenId>::max() : found->second;
    };
    const std::string_view left = std::string_view(merge).substr(0, blank);
    const std::string_view right =
        blank == std::string::npos ? std::string_view() : std::string_view(merge).substr(blank + 1);
    const std::string both = std::string(left) + std::string(right);
    const TokenId none = std::numeric_limits<TokenId>::max();
    if (find(left) == none || find(right) == none || find(both) == none) {
      return DataLoss("the merge " + Quote(merge) + " is not of tokens into a token");
    }
    pairs.merges_.emplace(Key(find(left), find(right)), Merge{static_cast<int>(rank), find(both)});
  }
  return pairs;
}

std::vector<TokenId> BytePairs::Encode(std::string_view text) const {
  std::vector<TokenId> tokens;
  for (const std::string_view word : ByteLevelWords(text, single_digits_)) {
    EncodeWord(word, &tokens);
  }
  return tokens;
}

const BytePairs::Merge* BytePairs::Find(TokenId left, TokenId right) const {
  const auto found = merges_.find(Key(left, right));
  return found == merges_.end() ? nullptr : &found->second;
}

void BytePairs::EncodeWord(std::string_view word, std::vector<TokenId>* tokens) const {
  // Words of people are short; a run of signs that is not is cut, so that time stays linear.
  constexpr std::size_t kMostBytes = 256;
  for (; word.size() > kMostBytes; word.remove_prefix(kMostBytes)) {
    EncodeWord(word.substr(0, kMostBytes), tokens);
  }
  std::vector<TokenId> symbols;
  for (const char c : word) {
    const std::optional<TokenId>& token = of_byte_[static_cast<unsigned char>(c)];
    if (token.has_value()) symbols.push_back(*token);
  }
  while (symbols.size() > 1) {
    const Merge* best = nullptr;
    std::size_t place = 0;
    for (std::size_t i = 0; i + 1 < symbols.size(); ++i) {
      const Merge* merge = Find(symbols[i], symbols[i + 1]);
      if (merge != nullptr && (best == nullptr || merge->rank < best->rank)) {
        best = merge;
        place = i;
      }
    }
    if (best == nullptr) break;
    symbols[place] = best->token;
    symbols.erase(symbols.begin() + static_cast<std::ptrdiff_t>(place) + 1);
  }
  tokens->insert(tokens->end(), symbols.begin(), symbols.end());
}

}  // namespace latticeworld
