#include "latticeworld/language/grounded/environment/count_reader.h"

#include <algorithm>

#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace {

constexpr int kMany = 1000000;  // no bound

Count Exactly(int value, std::size_t tokens) { return {value, value, value, tokens}; }

Count Product(const Count& outer, const Count& inner) {
  return {CappedProduct(outer.least, inner.least), CappedProduct(outer.value, inner.value),
          CappedProduct(outer.most, inner.most), outer.tokens + inner.tokens};
}

class CountReader {
 public:
  CountReader(const NotedTokens& noted, const EnvironmentWords& words)
      : noted_(noted), tokens_(noted.tokens), words_(words) {}

  Count Read(std::size_t at) const {
    if (at >= tokens_.size() || noted_.notes[at].ignored) return {};
    Count best = Qualified(at);
    if (best.tokens == 0) best = Plain(at);
    return best;
  }

 private:
  // "at least five", "between five and ten", "about thirty".
  Count Qualified(std::size_t at) const {
    struct Qualifier {
      Role role;
      Count (*apply)(int);
    };
    static constexpr Qualifier kQualifiers[] = {
        {Role::kAtLeast,
         [](int n) {
           return Count{n, n, kMany, 0};
         }},
        {Role::kAtMost,
         [](int n) {
           return Count{1, n, n, 0};
         }},
        {Role::kMoreThan,
         [](int n) {
           return Count{n + 1, n + 1 + n / 5, kMany, 0};
         }},
        {Role::kFewerThan,
         [](int n) {
           return Count{1, std::max(1, n - 1), std::max(1, n - 1), 0};
         }},
        {Role::kAbout,
         [](int n) {
           return Count{n - n / 4, n, n + (n + 3) / 4, 0};
         }},
        {Role::kExactly,
         [](int n) {
           return Count{n, n, n, 0};
         }},
    };
    if (const std::size_t between = words_.RoleAt(Role::kBetween, tokens_, at); between > 0) {
      const NumberMatch low = Number(at + between);
      const std::size_t joint = at + between + low.tokens;
      if (low.tokens > 0 && noted_.IsAnyWord(joint, {"and", "to"})) {
        const NumberMatch high = Number(joint + 1);
        if (high.tokens > 0 && high.value > low.value) {
          return {low.value, (low.value + high.value) / 2, high.value,
                  joint + 1 + high.tokens - at};
        }
      }
    }
    Count longest;
    std::size_t length = 0;
    for (const Qualifier& qualifier : kQualifiers) {
      const std::size_t said = words_.RoleAt(qualifier.role, tokens_, at);
      // ", like a hundred" is vague, "I would like a hundred" is not.
      if (noted_.IsWord(at, "like") && at > 0 && !noted_.IsPause(at - 1)) continue;
      if (said <= length) continue;
      Count inner = Plain(at + said);
      if (inner.tokens == 0) continue;
      length = said;
      longest = inner;
      // A vague number keeps the bounds that it has itself.
      if (inner.least == inner.most) longest = qualifier.apply(inner.value);
      longest.tokens = said + inner.tokens;
    }
    return longest;
  }

  // A number, a vague one, or groups of so many.
  Count Plain(std::size_t at) const {
    if (at >= tokens_.size()) return {};
    Count count;
    const Count vague = Vague(at);
    const NumberMatch number = Number(at);
    if (vague.tokens > 0 && vague.tokens >= number.tokens) {
      count = vague;
      // "a flock of thirty"
      if (noted_.IsWord(at + vague.tokens - 1, "of")) {
        Count inner = Read(at + vague.tokens);
        if (inner.tokens > 0) {
          inner.tokens += vague.tokens;
          return inner;
        }
      }
      return count;
    }
    if (number.tokens == 0) return {};
    count = Exactly(number.value, number.tokens);
    std::size_t next = at + count.tokens;
    // "three to five", "3 - 5", "five or six"
    const bool dash = next < tokens_.size() && tokens_[next].kind == TokenKind::kNumber &&
                      tokens_[next].begin > tokens_[next - 1].end;
    const bool joint = noted_.IsAnyWord(next, {"to", "or"});
    if (joint || dash) {
      const NumberMatch high = Number(next + (joint ? 1 : 0));
      if (high.tokens > 0 && high.value > count.value) {
        count.most = high.value;
        count.value = (count.least + high.value + 1) / 2;
        count.tokens += (joint ? 1 : 0) + high.tokens;
        next = at + count.tokens;
      }
    }
    if (noted_.IsWord(next, "strong")) {
      ++count.tokens;
      ++next;
    }
    // "two more flocks of sheep"
    if (noted_.IsAnyWord(next, {"more", "other", "further", "additional"}) &&
        Vague(next + 1).tokens > 0 && IsGroup(next + 1)) {
      ++count.tokens;
      ++next;
    }
    // "two flocks of sheep", "two flocks of ten sheep"
    if (const Count groups = Vague(next); groups.tokens > 0 && IsGroup(next)) {
      Count inner = Read(next + groups.tokens);
      if (inner.tokens > 0) {
        inner.tokens += groups.tokens;
        return Product(count, inner);
      }
      return Product(count, groups);
    }
    return count;
  }

  // A number that counts things: not an hour, nor so many metres.
  NumberMatch Number(std::size_t at) const {
    if (at >= tokens_.size() || noted_.notes[at].measure || noted_.notes[at].ignored) return {};
    const NumberMatch number = MatchNumber(tokens_, at);
    const std::size_t next = at + number.tokens;
    if (number.tokens > 0 && number.value == 0) return {};
    if (noted_.IsAnyWord(
            next, {"m", "am", "pm", "degrees", "degree", "metres", "meters", "metre", "meter", "km",
                   "cm", "percent", "knots", "mph", "th", "hours", "minutes", "times"})) {
      return {};
    }
    // "ten o'clock", but "a dozen o' sheep"
    if (noted_.IsWord(next, "o") &&
        (noted_.IsWord(next + 1, "clock") || noted_.Text(next, next + 1).size() > 4))
      return {};
    const std::size_t end = next == at ? 0 : tokens_[next - 1].end;
    if (number.tokens > 0 && end < noted_.instruction.size() && noted_.instruction[end] == '%') {
      return {};
    }
    return number;
  }

  Count Vague(std::size_t at) const {
    if (at >= tokens_.size()) return {};
    const auto match = words_.quantities.At(tokens_, at);
    if (match.tokens == 0) return {};
    const QuantityWord& word = *match.rows.front();
    return {word.least, word.value, word.most, match.tokens};
  }

  bool IsGroup(std::size_t at) const {
    return words_.quantities.At(tokens_, at).rows.front()->group;
  }

  const NotedTokens& noted_;
  const std::vector<Token>& tokens_;
  const EnvironmentWords& words_;
};

}  // namespace

int CappedProduct(int a, int b) {
  return static_cast<int>(std::min<long long>(kMany, static_cast<long long>(a) * b));
}

Count ReadCount(const NotedTokens& noted, const EnvironmentWords& words, std::size_t at) {
  return CountReader(noted, words).Read(at);
}

Count ReadCollective(const NotedTokens& noted, const EnvironmentWords& words, std::size_t at) {
  if (noted.IsPause(at)) return {};
  const std::string& word = noted.tokens[at].text;
  const std::string singular = Singular(word);
  std::vector<Token> phrase = Tokenize("a " + singular + " of");
  const auto match = words.quantities.At(phrase, 0);
  if (match.tokens != phrase.size() || !match.rows.front()->group) return {};
  const QuantityWord& row = *match.rows.front();
  const int packs = singular == word ? 1 : 2;
  return {row.least * packs, row.value * packs, row.most * packs, 1};
}

}  // namespace latticeworld
