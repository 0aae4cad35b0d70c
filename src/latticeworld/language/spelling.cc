#include "latticeworld/language/spelling.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <utility>

#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMinLength = 4;        // by a swap or for a letter left out
constexpr std::size_t kMinEditLength = 5;    // by any edit
constexpr std::size_t kMinDoubleLength = 9;  // by two edits
constexpr std::size_t kMinLeftOut = 7;       // by two letters left out
constexpr std::size_t kMaxLength = 24;

std::size_t StartKey(char first, std::size_t length) {
  return static_cast<unsigned char>(first) * 64 + length;
}

// Restricted Damerau distance (optimal string alignment), limit + 1 where it is more than limit.
// Both words have at most kMaxLength letters.
int DistanceUpTo(std::string_view a, std::string_view b, int limit) {
  std::array<std::array<std::uint8_t, kMaxLength + 1>, 3> rows;
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = static_cast<std::uint8_t>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto& above = rows[(i - 1) % 3];
    const auto& two_above = rows[(i + 1) % 3];
    row[0] = static_cast<std::uint8_t>(i);
    int smallest = row[0];
    for (std::size_t j = 1; j <= b.size(); ++j) {
      int best =
          std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        best = std::min(best, two_above[j - 2] + 1);
      }
      row[j] = static_cast<std::uint8_t>(best);
      smallest = std::min(smallest, best);
    }
    if (smallest > limit) return limit + 1;
  }
  return std::min<int>(rows[a.size() % 3][b.size()], limit + 1);
}

bool IsSwap(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  const auto [i, j] = std::mismatch(a.begin(), a.end(), b.begin());
  if (i == a.end() || i + 1 == a.end()) return false;
  return *i == j[1] && i[1] == *j && std::equal(i + 2, a.end(), j + 2);
}

// How likely the one edit that leads from `meant` to `written` is, the likeliest first: two letters
// swapped or one doubled, one left out, one put in, one changed.
int RankOfEdit(std::string_view written, std::string_view meant) {
  if (written.size() == meant.size()) return IsSwap(written, meant) ? 0 : 3;
  if (written.size() < meant.size()) return 1;
  const auto at = std::mismatch(meant.begin(), meant.end(), written.begin()).second;
  const bool doubled = at != written.begin() && *at == *(at - 1);
  return doubled ? 0 : 2;
}

// The letters of a word, a bit each.
std::uint32_t LettersOf(std::string_view word) {
  std::uint32_t letters = 0;
  for (const char c : word) letters |= 1u << (static_cast<unsigned char>(c) & 31u);
  return letters;
}

// Whether so many edits can lead from one set of letters to the other: each takes one letter out
// and puts one in at most.
bool MayBeWithin(std::uint32_t a, std::uint32_t b, int edits) {
  return static_cast<int>(std::bitset<32>(a ^ b).count()) <= 2 * edits;
}

bool IsVowel(char c) { return std::string_view("aeiou").find(c) != std::string_view::npos; }

// Whether English doubles the last letter of a verb before -ed and -ing: "run", "step", not "row".
bool DoublesItsEnd(std::string_view stem) {
  const std::size_t n = stem.size();
  return n >= 3 && n <= 4 && !IsVowel(stem[n - 1]) && IsVowel(stem[n - 2]) &&
         !IsVowel(stem[n - 3]) &&
         std::string_view("wxy").find(stem[n - 1]) == std::string_view::npos;
}

std::vector<std::string> Copies(const std::vector<std::string_view>& words) {
  std::vector<std::string> copies(words.begin(), words.end());
  std::sort(copies.begin(), copies.end());
  copies.erase(std::unique(copies.begin(), copies.end()), copies.end());
  return copies;
}

}  // namespace

SpellingDictionary::SpellingDictionary(const std::vector<std::string_view>& words,
                                       const std::vector<std::string_view>& known)
    : words_(Copies(words)), known_(Copies(known)) {
  all_.insert(known_.begin(), known_.end());
  all_.insert(words_.begin(), words_.end());
  for (std::size_t i = 0; i < words_.size(); ++i) {
    const std::string& word = words_[i];
    if (word.size() < kMinLength || word.size() > kMaxLength) continue;
    by_start_[StartKey(word[0], word.size())].push_back({i, LettersOf(word)});
  }
}

bool SpellingDictionary::Knows(std::string_view word) const {
  if (Has(word) || Has(Singular(word))) return true;
  std::string stem;
  for (const std::string_view end : {"s", "es", "ed", "ing", "er", "est", "ly", "y", "ness", "less",
                                     "ful", "ward", "wards", "like", "ish", "ers", "ings"}) {
    if (word.size() < end.size() + 3 || word.substr(word.size() - end.size()) != end) continue;
    stem = word.substr(0, word.size() - end.size());
    // "runing" is a mistake.
    const bool doubles =
        (end == "ing" || end == "ed" || end == "er" || end == "est") && DoublesItsEnd(stem);
    // Only before a vowel an e is lost, or a letter doubled: "drons" is a mistake.
    const bool vowel = IsVowel(end.front()) || end == "y";
    if ((Has(stem) && !doubles) || (vowel && Has(stem + 'e'))) return true;
    if (stem.back() == 'i' && Has(stem.substr(0, stem.size() - 1) + 'y')) return true;
    // "stopped"
    const bool doubled = vowel && stem.size() > 2 && stem[stem.size() - 1] == stem[stem.size() - 2];
    if (doubled && Has(stem.substr(0, stem.size() - 1))) return true;
  }
  return false;
}

std::optional<std::string_view> SpellingDictionary::Undoubled(std::string_view word) const {
  const auto ends = [&](std::string_view end) {
    return word.size() > end.size() && word.substr(word.size() - end.size()) == end;
  };
  // "hopping" and "hoping" are both words.
  if (word.size() <= kMinEditLength || ends("ing") || ends("ed") || Has(word)) return std::nullopt;
  // No word begins with a letter twice by a slip of spelling: "ppolar" may be "poplar".
  for (std::size_t i = 2; i < word.size(); ++i) {
    if (word[i] != word[i - 1]) continue;
    std::string once(word);
    once.erase(i, 1);
    const auto found = std::lower_bound(words_.begin(), words_.end(), once);
    if (found != words_.end() && *found == once) return std::string_view(*found);
  }
  return std::nullopt;
}

std::optional<std::string_view> SpellingDictionary::Correct(std::string_view word) const {
  // "forrest" is no superlative of "for".
  if (const auto undoubled = Undoubled(word); undoubled.has_value()) return undoubled;
  if (word.size() < kMinLength || word.size() > kMaxLength || Knows(word)) return std::nullopt;
  const bool long_word = word.size() >= kMinDoubleLength;
  const int limit = word.size() >= kMinLeftOut ? 2 : 1;
  // The distance, and among words one edit away the rank of that edit.
  constexpr int kRanks = 4;
  int best = (limit + 1) * kRanks;
  std::vector<std::string_view> closest;
  const std::uint32_t letters = LettersOf(word);
  const auto consider = [&](char first) {
    const auto reach = static_cast<std::size_t>(limit);
    for (std::size_t length = word.size() - reach; length <= word.size() + reach; ++length) {
      const auto bucket = by_start_.find(StartKey(first, length));
      if (bucket == by_start_.end()) continue;
      for (const Entry& entry : bucket->second) {
        if (!MayBeWithin(letters, entry.letters, limit)) continue;
        const std::string& candidate = words_[entry.index];
        if (word.size() < kMinEditLength && candidate.size() <= word.size() &&
            !IsSwap(word, candidate)) {
          continue;
        }
        if (first != word[0] && !IsSwap(word, candidate)) continue;
        const int distance = DistanceUpTo(word, candidate, std::min(best / kRanks, limit));
        if (distance > limit) continue;
        if (distance == 2 && !long_word && candidate.size() != word.size() + 2) continue;
        const int cost = distance * kRanks + (distance == 1 ? RankOfEdit(word, candidate) : 0);
        if (cost > best) continue;
        if (cost < best) closest.clear();
        best = cost;
        closest.push_back(candidate);
      }
    }
  };
  consider(word[0]);
  if (word[1] != word[0]) consider(word[1]);
  if (closest.size() == 1) return closest.front();
  if (closest.size() == 2) {
    // A word and its plural mean the same here.
    std::sort(closest.begin(), closest.end(),
              [](std::string_view a, std::string_view b) { return a.size() < b.size(); });
    if (Singular(closest[1]) == closest[0]) return closest[0];
  }
  return std::nullopt;
}

}  // namespace latticeworld
