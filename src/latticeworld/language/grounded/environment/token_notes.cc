#include "latticeworld/language/grounded/environment/token_notes.h"

#include <algorithm>
#include <utility>

#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace {

constexpr std::size_t kLongestScope = 16;  // tokens that one negation reaches

// Follows the words from which a negation reaches on, and where it ends.
class ScopeMarker {
 public:
  ScopeMarker(const EnvironmentWords& words, NotedTokens* noted)
      : words_(words), tokens_(noted->tokens), noted_(noted) {}

  void Run() {
    for (std::size_t at = 0; at < tokens_.size();) at += Step(at);
  }

 private:
  std::size_t Role(enum Role role, std::size_t at) const {
    return words_.RoleAt(role, tokens_, at);
  }

  std::size_t Step(std::size_t at) {
    if (tokens_[at].kind == TokenKind::kComma || tokens_[at].kind == TokenKind::kStop) return 1;
    if (IsException(at)) {
      MarkScope(at, at + 1);
      return 1;
    }
    if (const std::size_t aside = HabitAt(at); aside > 0) {
      noted_->Mark(at, at + aside, &TokenNote::ignored);
      return aside;
    }
    if (const std::size_t out = OutAfter(at); out > 0) {
      for (std::size_t i = at; i <= out; ++i) noted_->notes[i].known = true;
      for (std::size_t i = at + 1; i < out; ++i) noted_->notes[i].negated = true;
      return out + 1 - at;
    }
    const std::size_t ignored = Role(Role::kIgnored, at);
    const std::size_t negator = Role(Role::kNot, at);
    if (noted_->IsAnyWord(at, {"prefer", "preferred"})) MarkDispreferred(at);
    if (noted_->IsWord(at, "rather") && !noted_->IsWord(at + 1, "than")) MarkRatherThan(at);
    if (noted_->IsAnyWord(at, {"leave", "keep", "take"})) MarkLeftOut(at);
    // "no more than", "no wait" and "nobody" are no negations of what follows.
    const std::size_t other =
        std::max({Role(Role::kAtLeast, at), Role(Role::kAtMost, at), Role(Role::kCorrection, at),
                  Role(Role::kNobody, at), Role(Role::kSomeOfThem, at)});
    const std::size_t function =
        std::max({Role(Role::kFunction, at), Role(Role::kBut, at), other, Role(Role::kMore, at),
                  Role(Role::kAbout, at), Role(Role::kExactly, at), Role(Role::kNear, at),
                  Role(Role::kIn, at), Role(Role::kMoreThan, at), Role(Role::kFewerThan, at),
                  Role(Role::kOthers, at), Role(Role::kThey, at), Role(Role::kBeforeSpecies, at)});
    for (std::size_t i = 0; i < function; ++i) noted_->notes[at + i].known = true;
    if (ignored > negator && ignored >= other) {
      noted_->Mark(at, at + ignored, &TokenNote::ignored);
      return ignored;
    }
    if (negator == 0 || other > negator) return std::max<std::size_t>(1, other);
    for (std::size_t i = 0; i < negator; ++i) noted_->notes[at + i].known = true;
    // "nobody except a shepherd": there is one.
    if (noted_->IsWord(at, "except") && DeniedBefore(at)) return negator;
    MarkScope(at, at + negator);
    return negator;
  }

  // "I prefer autumn to winter and dusk to dawn": not winter, not dawn.
  void MarkDispreferred(std::size_t prefer) {
    for (std::size_t at = prefer + 2; !noted_->IsPause(at) && at < prefer + kLongestScope; ++at) {
      if (!noted_->IsAnyWord(at, {"to", "over"}) || noted_->IsPause(at + 1)) continue;
      if (Role(Role::kFunction, at + 1) > 0 && !noted_->IsAnyWord(at + 1, {"a", "an", "the"})) {
        return;
      }
      for (++at; !noted_->IsPause(at) && !noted_->IsWord(at, "and"); ++at) {
        noted_->notes[at].negated = true;
      }
    }
  }

  // "I would rather have goats than sheep"
  void MarkRatherThan(std::size_t rather) {
    constexpr std::size_t kReach = 8;
    for (std::size_t at = rather + 2; !noted_->IsPause(at) && at < rather + kReach; ++at) {
      if (!noted_->IsWord(at, "than")) continue;
      for (++at; !noted_->IsPause(at) && !noted_->IsWord(at, "and") && !IsPreposition(at); ++at) {
        noted_->notes[at].negated = true;
      }
      return;
    }
  }

  // "leave the animals out"
  void MarkLeftOut(std::size_t verb) {
    constexpr std::size_t kReach = 6;
    for (std::size_t at = verb + 2; !noted_->IsPause(at) && at < verb + kReach; ++at) {
      if (!noted_->IsAnyWord(at, {"out", "away"}) || noted_->IsAnyWord(at + 1, {"of", "from"})) {
        continue;
      }
      for (std::size_t i = verb + 1; i < at; ++i) noted_->notes[i].negated = true;
      return;
    }
  }

  bool DeniedBefore(std::size_t at) const {
    for (std::size_t i = at; i > 0 && i + kLongestScope > at && !noted_->IsEnd(i - 1); --i) {
      if (Role(Role::kNot, i - 1) > 0 || Role(Role::kNobody, i - 1) > 0) return true;
    }
    return false;
  }

  void MarkScope(std::size_t negator, std::size_t first) {
    const std::string& word = tokens_[negator].text;
    const bool joins_by_and = word != "no" && word != "not" && word != "never";
    int content = 0;
    for (std::size_t at = first; !noted_->IsEnd(at) && at < first + kLongestScope; ++at) {
      if (tokens_[at].kind == TokenKind::kComma) {
        // "What I do not want: wolves or goblins."
        if (content == 0 && tokens_[at].text == ":" && word != "no") continue;
        if (content == 0 || !ListGoesOn(at + 1)) return;
        continue;
      }
      // "not by the lake"
      const bool place = at == first && noted_->IsWord(at, "by");
      if (Role(Role::kBut, at) > 0 && !noted_->IsWord(at, "for") && !place) return;
      if (noted_->IsWord(at, "and") && (!joins_by_and || !IsBare(at + 1))) return;
      // "instead of sheep I would like horses"
      if (content > 0 && noted_->IsAnyWord(at, {"i", "we", "please", "let", "put"})) return;
      // "instead of rain take fog"
      const bool swaps = word == "instead" || word == "rather" || word == "in";
      if (content > 0 && swaps &&
          noted_->IsAnyWord(at, {"take", "use", "make", "give", "show", "choose", "pick", "have",
                                 "add", "place", "set", "try", "get"})) {
        return;
      }
      const bool determiner = noted_->IsAnyWord(at, {"a", "an", "the", "it", "they", "there"});
      const bool after_or =
          at > first && (noted_->IsWord(at - 1, "or") || noted_->IsWord(at - 1, "nor"));
      if (content > 0 && !after_or) {
        if (determiner || IsPreposition(at) || MatchNumber(tokens_, at).tokens > 0) return;
      }
      noted_->notes[at].negated = true;
      if (Role(Role::kFunction, at) == 0 && !determiner) ++content;
    }
  }

  // "any season but winter"
  bool IsException(std::size_t at) const {
    if (!noted_->IsWord(at, "but") || at < 2) return false;
    return noted_->IsAnyWord(at - 2, {"any", "every", "whatever"}) ||
           noted_->IsAnyWord(at - 1, {"anything", "everything", "any"});
  }

  // "leave the fog out": where "out" stands; 0: it does not.
  std::size_t OutAfter(std::size_t at) const {
    if (!noted_->IsAnyWord(at, {"leave", "leaving", "keep", "take", "cut"})) return 0;
    if (noted_->IsWord(at + 1, "out")) return 0;
    for (std::size_t i = at + 2; i < at + 6 && !noted_->IsPause(i); ++i) {
      if (noted_->IsWord(i, "out")) return noted_->IsAnyWord(i + 1, {"of", "in"}) ? 0 : i;
      if (IsPreposition(i) || noted_->IsWord(i, "and")) return 0;
    }
    return 0;
  }

  // "robots that normally haul timber are parked": tokens of what they do at other times; 0: none.
  std::size_t HabitAt(std::size_t at) const {
    constexpr std::size_t kLongest = 10;
    if (!noted_->IsAnyWord(at, {"that", "which", "who"})) return 0;
    if (!noted_->IsAnyWord(at + 1, {"normally", "usually", "ordinarily", "otherwise", "typically",
                                    "generally", "once", "formerly", "used"})) {
      return 0;
    }
    for (std::size_t end = at + 2; end < at + kLongest && !noted_->IsEnd(end); ++end) {
      const bool comma = tokens_[end].kind == TokenKind::kComma;
      if (comma || noted_->IsAnyWord(end, {"are", "is", "have", "has", "now", "stand", "stands",
                                           "lie", "lies", "sit", "sits", "wait", "waits"})) {
        return end - at;
      }
    }
    return 0;
  }

  bool IsPreposition(std::size_t at) const {
    return Role(Role::kIn, at) > 0 || Role(Role::kNear, at) > 0 ||
           noted_->IsAnyWord(at, {"during", "after", "before"});
  }

  // "no rain, fog or snow": the list ends with "or".
  bool ListGoesOn(std::size_t at) const {
    for (const std::size_t last = at + kLongestScope; at < last && !noted_->IsEnd(at); ++at) {
      if (noted_->IsAnyWord(at, {"or", "nor", "included", "either"})) return true;
      if (noted_->IsAnyWord(at, {"and", "a", "an", "the", "is", "are", "it"}) ||
          IsPreposition(at) || Role(Role::kNot, at) > 0 || Role(Role::kBut, at) > 0 ||
          MatchNumber(tokens_, at).tokens > 0) {
        return false;
      }
    }
    return false;
  }

  // "without goblins and wolves": another bare noun.
  bool IsBare(std::size_t at) const {
    return !noted_->IsPause(at) && MatchNumber(tokens_, at).tokens == 0 &&
           words_.quantities.LengthAt(tokens_, at) == 0 && Role(Role::kFunction, at) == 0;
  }

  const EnvironmentWords& words_;
  const std::vector<Token>& tokens_;
  NotedTokens* noted_;
};

}  // namespace

std::string_view NotedTokens::Text(std::size_t first, std::size_t last) const {
  if (first >= last || last > tokens.size()) return {};
  return instruction.substr(tokens[first].begin, tokens[last - 1].end - tokens[first].begin);
}

NotedTokens NoteScopes(std::string_view instruction, std::vector<Token> tokens,
                       const EnvironmentWords& words) {
  NotedTokens noted;
  noted.instruction = instruction;
  noted.tokens = std::move(tokens);
  noted.notes.resize(noted.tokens.size());
  ScopeMarker(words, &noted).Run();
  return noted;
}

}  // namespace latticeworld
