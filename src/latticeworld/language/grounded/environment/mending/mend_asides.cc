#include "latticeworld/language/grounded/environment/mending/mend_asides.h"

#include <cstddef>
#include <string_view>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool EndsWith(std::string_view word, std::string_view end) {
  return word.size() > end.size() && word.substr(word.size() - end.size()) == end;
}

// "Make it nine, twelve is too much for my laptop": make it nine. "Ten whales. Ten is too many.
// Two.": ten whales. No, two.
void MendTooMany(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 4;  // words up to "too"
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const std::size_t verb = at + MatchNumber(*tokens, at).tokens;
    if (verb == at || !IsOneOf(WordAt(*tokens, verb), {"is", "are", "was", "were", "would"})) {
      continue;
    }
    std::size_t too = verb + 1;
    while (too < verb + kReach && !IsPauseAt(*tokens, too) && WordAt(*tokens, too) != "too") ++too;
    const bool many = WordAt(*tokens, too) == "too" &&
                      IsOneOf(WordAt(*tokens, too + 1), {"much", "many", "few", "crowded", "slow"});
    if (!many) continue;
    const std::size_t end = PauseAfter(*tokens, at);
    const std::size_t instead = MatchNumber(*tokens, end + 1).tokens;
    const bool corrected = instead > 0 && IsPauseAt(*tokens, end + 1 + instead);
    const Token beside = (*tokens)[at];
    EraseTokens(tokens, at, end + (corrected ? 1 : 0) - at);
    if (corrected) InsertTokens(tokens, at, {WordLike("no", beside), CommaLike(beside)});
  }
}

// "As for animals, three eagles", "as for the goblins, they sleep": three eagles; the goblins, they
// sleep.
void MendTopics(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (at > 0 && !IsStopAt(*tokens, at - 1)) continue;
    std::size_t noun = at;
    if (WordAt(*tokens, at) == "as" && IsOneOf(WordAt(*tokens, at + 1), {"for", "to"})) {
      noun = at + 2;
    } else if (IsOneOf(WordAt(*tokens, at), {"regarding", "concerning"})) {
      noun = at + 1;
    } else if (IsOneOf(WordAt(*tokens, at), {"with", "in"}) &&
               IsOneOf(WordAt(*tokens, at + 1), {"regard", "respect", "regards"}) &&
               WordAt(*tokens, at + 2) == "to") {
      noun = at + 3;
    }
    if (noun == at) continue;
    const std::size_t name = noun + (WordAt(*tokens, noun) == "the" ? 1 : 0);
    const auto topic = words.species.At(*tokens, name);
    const std::size_t end = name + topic.tokens;
    if (topic.tokens == 0 || end >= tokens->size()) continue;
    if ((*tokens)[end].kind != TokenKind::kComma) continue;
    const bool kind = topic.rows.front()->categories.size() > 1;
    EraseTokens(tokens, at, kind ? end + 1 - at : noun - at);
  }
}

// "Two rovers inspect the road, another two the bridge": another two at the bridge.
void MendGaps(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    const bool opens = (*tokens)[at - 1].kind == TokenKind::kComma ||
                       IsOneOf(WordAt(*tokens, at - 1), {"and", "another"});
    const std::size_t the = at + MatchNumber(*tokens, at).tokens;
    if (!opens || the == at || WordAt(*tokens, the) != "the") continue;
    const std::size_t land = words.features.LengthAt(*tokens, the + 1);
    if (land == 0 || !IsPauseAt(*tokens, the + 1 + land)) continue;
    InsertTokens(tokens, the, {WordLike("at", (*tokens)[the])});
  }
}

// "My kids", "the students", for whom a world is made; 0: others are meant.
std::size_t AudienceAt(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsOneOf(WordAt(tokens, at), {"the", "my", "our", "his", "her"})) return 0;
  std::size_t noun = at + 1 + MatchNumber(tokens, at + 1).tokens;
  if (IsOneOf(WordAt(tokens, noun), {"little", "small", "young", "older", "younger"})) ++noun;
  const bool audience = IsOneOf(
      WordAt(tokens, noun),
      {"children", "kids",       "kid",        "child",         "pupils",    "students",
       "class",    "daughter",   "son",        "grandchildren", "grandson",  "granddaughter",
       "boss",     "colleague",  "colleagues", "customer",      "customers", "client",
       "audience", "viewers",    "players",    "wife",          "husband",   "friend",
       "friends",  "mother",     "father",     "parents",       "brother",   "sister",
       "teacher",  "supervisor", "professor"});
  return audience ? noun + 1 - at : 0;
}

// "My kids want ten sheep", "the children will not look at it": want ten sheep, will not look at
// it; but "the children will play by the lake".
void MendAudience(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::size_t verb = at + AudienceAt(*tokens, at);
    if (verb == at) continue;
    const bool wishes =
        IsOneOf(WordAt(*tokens, verb), {"want", "wants", "wanted", "need", "needs", "ask", "asks",
                                        "asked", "wish", "wishes", "prefer", "prefers", "like",
                                        "likes", "love", "loves", "say", "says", "said"}) &&
        WordAt(*tokens, verb + 1) != "to";
    bool acts = false;
    for (std::size_t i = verb + 1; !IsPauseAt(*tokens, i); ++i) {
      acts = acts || words.states.LengthAt(*tokens, i) > 0;
    }
    const bool may = IsOneOf(WordAt(*tokens, verb), {"will", "would", "can", "could", "should",
                                                     "may", "might", "must", "do", "does"});
    if (wishes || (may && !acts)) EraseTokens(tokens, at, verb - at);
  }
}

// Whether somebody speaks of himself or of another here: "I", "she".
bool IsSpeakerAt(const std::vector<Token>& tokens, std::size_t at) {
  return IsOneOf(WordAt(tokens, at), {"i", "we", "he", "she", "everyone", "everybody"});
}

// The token behind "I hate", "I'm tired of", "we have had enough of"; `at`: nothing of the kind.
std::size_t DislikeAt(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsSpeakerAt(tokens, at)) return at;
  std::size_t next = at + 1;
  while (IsOneOf(WordAt(tokens, next), {"am", "are", "is", "really", "just", "have", "has", "had",
                                        "so", "all", "quite"})) {
    ++next;
  }
  if (IsOneOf(WordAt(tokens, next), {"hate", "hates", "dislike", "dislikes", "loathe"})) {
    return next + 1;
  }
  const bool tired =
      IsOneOf(WordAt(tokens, next), {"tired", "sick", "enough", "bored", "afraid"}) &&
      IsOneOf(WordAt(tokens, next + 1), {"of", "with"});
  return tired ? next + 2 : at;
}

// "I am tired of the rain, give me sun", "I hate snow": give me sun.
void MendDislikes(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    std::size_t end = DislikeAt(*tokens, at);
    if (end == at) continue;
    while (!IsPauseAt(*tokens, end) && !IsOneOf(WordAt(*tokens, end), {"so", "but"})) ++end;
    EraseTokens(tokens, at, end - at);
  }
}

// "She finds the realistic one boring": nothing.
void MendBores(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const bool finds =
        IsSpeakerAt(*tokens, at) && IsOneOf(WordAt(*tokens, at + 1), {"find", "finds", "found"});
    if (!finds) continue;
    const std::size_t end = PauseAfter(*tokens, at);
    const bool bores =
        IsOneOf(WordAt(*tokens, end - 1), {"boring", "dull", "ugly", "scary", "tiresome",
                                           "depressing", "confusing", "distracting", "annoying"});
    if (bores) EraseTokens(tokens, at, end - at);
  }
}

// "She loves horses, so five horses please": so five horses please.
void MendLoves(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const std::size_t noun = at + 2;
    const bool loves = IsSpeakerAt(*tokens, at) &&
                       IsOneOf(WordAt(*tokens, at + 1), {"love", "loves", "like", "likes"});
    const auto loved = words.species.At(*tokens, noun);
    if (!loves || loved.tokens == 0 || !IsPauseAt(*tokens, noun + loved.tokens)) continue;
    bool named = false;
    for (std::size_t i = noun + loved.tokens; i < tokens->size(); ++i) {
      const auto again = words.species.At(*tokens, i);
      named = named || (again.tokens > 0 &&
                        again.rows.front()->categories == loved.rows.front()->categories);
    }
    if (named) EraseTokens(tokens, at, noun + loved.tokens - at);
  }
}

// "Reed instead of ordinary grass": reed, which is grass itself.
void MendInstead(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "instead" || WordAt(*tokens, at + 1) != "of") continue;
    const auto kind = words.variants.At(*tokens, at - 1);
    std::size_t noun = at + 2;
    while (IsOneOf(WordAt(*tokens, noun), {"the", "ordinary", "normal", "usual", "plain", "common",
                                           "regular", "simple", "any", "just"})) {
      ++noun;
    }
    const auto asset = words.assets.At(*tokens, noun);
    if (kind.tokens != 1 || asset.tokens == 0 || !IsPauseAt(*tokens, noun + asset.tokens)) continue;
    if (kind.rows.front()->asset != asset.rows.front()->asset) continue;
    EraseTokens(tokens, at, noun + asset.tokens - at);
  }
}

// "They go on patrolling", "they continue to graze": they patrolling, they graze.
void MendGoingOn(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    std::size_t verb = at;
    if (IsOneOf(WordAt(*tokens, at), {"go", "goes", "carry", "carries", "keep", "keeps"})) {
      verb = at + 1 + (WordAt(*tokens, at + 1) == "on" ? 1 : 0);
      if (verb == at + 1 && WordAt(*tokens, at).substr(0, 4) != "keep") continue;
    } else if (IsOneOf(WordAt(*tokens, at), {"continue", "continues"})) {
      verb = at + 1;
      if (WordAt(*tokens, verb) == "to") ++verb;
    }
    const bool does = verb > at && verb < tokens->size() &&
                      words.states.LengthAt(*tokens, verb) > 0 &&
                      (EndsWith(WordAt(*tokens, verb), "ing") || WordAt(*tokens, verb - 1) == "to");
    if (does) EraseTokens(tokens, at, verb - at);
  }
}

}  // namespace

void MendAsides(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendTooMany(tokens);
  MendTopics(words, tokens);
  MendGaps(words, tokens);
  MendAudience(words, tokens);
  MendDislikes(tokens);
  MendBores(tokens);
  MendLoves(words, tokens);
  MendInstead(words, tokens);
  MendGoingOn(words, tokens);
}

}  // namespace latticeworld
