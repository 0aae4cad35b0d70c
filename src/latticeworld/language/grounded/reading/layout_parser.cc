#include "latticeworld/language/grounded/reading/layout_parser.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/chunk.h"
#include "latticeworld/language/grounded/reading/claims_of_plan.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/discourse.h"
#include "latticeworld/language/grounded/reading/elided_words.h"
#include "latticeworld/language/grounded/reading/named_places.h"
#include "latticeworld/language/grounded/reading/plain/wording/plain_words.h"
#include "latticeworld/language/grounded/reading/sense.h"
#include "latticeworld/language/grounded/reading/settle_plan.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/spelling.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMinRepeatedTokens = 4;
constexpr std::size_t kMaxNotUnderstood = 40;
constexpr std::size_t kMaxCorrections = 20;  // that are warned of

// The tokens without sentences that stood there before in the same words; these are said once.
std::vector<Token> WithoutRepeats(std::string_view instruction, std::vector<Token> tokens,
                                  std::vector<std::string>* warnings) {
  std::vector<Token> kept;
  std::unordered_set<std::string> said;
  std::string first;
  std::size_t repeated = 0;
  for (std::size_t begin = 0; begin < tokens.size();) {
    std::size_t end = begin;
    while (end < tokens.size() && tokens[end].kind != TokenKind::kStop) ++end;
    const bool again =
        end - begin >= kMinRepeatedTokens && !said.insert(JoinWords(tokens, begin, end)).second;
    if (again) {
      if (repeated++ == 0) {
        first = instruction.substr(tokens[begin].begin, tokens[end - 1].end - tokens[begin].begin);
      }
    } else {
      for (std::size_t i = begin; i < std::min(end + 1, tokens.size()); ++i) {
        kept.push_back(std::move(tokens[i]));
      }
    }
    begin = end + 1;
  }
  if (repeated > 0) {
    warnings->push_back("said more than once and laid once: " + Quote(first) +
                        (repeated > 1 ? " and " + std::to_string(repeated - 1) + " more" : ""));
  }
  return kept;
}

// The words of an instruction: what classes, places and senses are made of, and common English.
const SpellingDictionary& Dictionary() {
  static const SpellingDictionary dictionary = [] {
    std::vector<std::string_view> words = LayoutWords();
    const std::vector<std::string_view> senses = SenseWords();
    words.insert(words.end(), senses.begin(), senses.end());
    return SpellingDictionary(words, CommonEnglishWords());
  }();
  return dictionary;
}

// Mistakes in words too short, or too near to other words, for the dictionary to tell, and what is
// meant by them.
constexpr std::pair<std::string_view, std::string_view> kShortMistakes[] = {
    {"teh", "the"},
    {"hte", "the"},
    {"adn", "and"},
    {"nad", "and"},
    {"edg", "edge"},
    {"fo", "of"},
    {"taht", "that"},
    {"wiht", "with"},
    {"wich", "which"},
    {"thier", "their"},
    {"forrest", "forest"},
    {"forrests", "forests"},
    {"untill", "until"},
    {"rigth", "right"},
    {"rihgt", "right"},
    {"lef", "left"},
    {"wnat", "want"},
    {"thre", "three"},
    {"tow", "two"},
    {"noth", "north"},
    {"sout", "south"},
    {"botom", "bottom"},
    {"lak", "lake"},
    {"laks", "lakes"},
    {"rver", "river"},
    {"beetwen", "between"},
    {"els", "else"},
    {"est", "east"},
    {"bolder", "boulder"},
    {"bolders", "boulders"},
    {"toch", "touch"},
    {"moutain", "mountain"},
    {"rode", "road"},
    {"rite", "right"},
    {"nd", "and"},
    {"thru", "through"},
    {"feild", "field"},
    {"feilds", "fields"},
    {"smal", "small"},
    {"larg", "large"},
    {"midle", "middle"},
    {"litle", "little"},
    {"hous", "house"},
    {"betwen", "between"},
    {"mosty", "mostly"},
    {"arond", "around"},
    {"ned", "need"},
    {"inbetwen", "between"},
    {"inbetween", "between"},
    {"wal", "wall"},
    {"lefft", "left"},
    {"surounded", "surrounded"},
    {"wod", "wood"},
    {"wods", "woods"},
    {"rok", "rock"},
    {"roks", "rocks"},
    {"rivr", "river"},
    {"tres", "trees"},
    {"souther", "southern"},
    {"norther", "northern"},
    {"streem", "stream"},
    {"streems", "streams"},
    {"leaveing", "leaving"},
    {"entring", "entering"},
    {"iland", "island"},
    {"ilands", "islands"},
    {"runing", "running"},
    {"rt", "right"},
    {"lft", "left"},
    {"btm", "bottom"},
    {"ctr", "center"},
    {"rd", "road"},
    {"btwn", "between"},
    {"boths", "both"},
};

// What is meant by such a mistake; nullopt: the word is none.
std::optional<std::string_view> ShortMistake(std::string_view word) {
  for (const auto& [mistake, meant] : kShortMistakes) {
    if (word == mistake) return meant;
  }
  return std::nullopt;
}

// "the down part" is the lower one.
std::optional<std::string_view> SideWord(const std::vector<Token>& tokens, std::size_t at) {
  const bool before_part =
      at + 1 < tokens.size() && (tokens[at + 1].text == "part" || tokens[at + 1].text == "half" ||
                                 tokens[at + 1].text == "corner" || tokens[at + 1].text == "zone");
  // "takes up half of the map" says no place.
  const bool verb =
      at > 0 && IsOneOf(tokens[at - 1].text, {"take", "takes", "taking", "taken", "make", "makes",
                                              "making", "fill", "fills", "filling", "use", "uses"});
  if (!before_part || verb) return std::nullopt;
  if (tokens[at].text == "down") return "lower";
  if (tokens[at].text == "up") return "upper";
  return std::nullopt;
}

// Mistyped words are read as what was meant, with a warning for each.
void CorrectSpelling(std::string_view instruction, std::vector<Token>* tokens,
                     std::vector<std::string>* warnings) {
  std::size_t corrected = 0;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    Token& token = (*tokens)[at];
    if (token.kind != TokenKind::kWord) continue;
    std::optional<std::string_view> meant = SideWord(*tokens, at);
    if (!meant.has_value()) meant = ShortMistake(token.text);
    if (!meant.has_value()) meant = Dictionary().Correct(token.text);
    if (!meant.has_value()) continue;
    token.text = *meant;
    if (++corrected > kMaxCorrections) continue;
    warnings->push_back("read " + Quote(instruction.substr(token.begin, token.end - token.begin)) +
                        " as " + Quote(*meant));
  }
}

// Unread words that stand side by side make one phrase.
std::vector<std::string> Phrases(std::string_view instruction,
                                 std::vector<std::pair<std::size_t, std::size_t>> spans) {
  std::sort(spans.begin(), spans.end());
  std::vector<std::pair<std::size_t, std::size_t>> joined;
  for (const auto& span : spans) {
    const bool beside =
        !joined.empty() && span.first >= joined.back().second &&
        instruction.substr(joined.back().second, span.first - joined.back().second) == " ";
    if (beside) {
      joined.back().second = span.second;
    } else if (joined.empty() || span.first >= joined.back().second) {
      joined.push_back(span);
    }
  }
  std::vector<std::string> phrases;
  for (const auto& [begin, end] : joined) {
    if (phrases.size() == kMaxNotUnderstood) break;
    phrases.emplace_back(instruction.substr(begin, end - begin));
  }
  return phrases;
}

}  // namespace

LayoutPlan ParseLayoutInstruction(std::string_view instruction, Vocabulary vocabulary) {
  Discourse discourse(instruction, vocabulary);
  std::vector<Token> tokens =
      WithoutRepeats(instruction, Tokenize(instruction), &discourse.plan().warnings);
  CorrectSpelling(instruction, &tokens, &discourse.plan().warnings);
  tokens = WithElidedWords(WithPlainWords(WithNamedPlaces(std::move(tokens))));
  const Chunks chunks = ChunkLayout(tokens);
  ClauseReader(chunks.chunks, &discourse).Read();
  LayoutPlan plan = discourse.Finish();
  plan.not_understood = Phrases(instruction, chunks.unread);
  SettlePlan(&plan);
  plan.claims = ClaimsOfPlan(plan);
  return plan;
}

}  // namespace latticeworld
