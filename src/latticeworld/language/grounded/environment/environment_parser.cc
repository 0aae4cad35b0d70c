// Instruction -> tokens, with slips of the pen mended -> scopes of negations and figures of speech
// -> measures, agents, fine attributes, coarse attributes, each by its own reader over the same
// tokens.

#include "latticeworld/language/grounded/environment/environment_parser.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/environment/agents/agent_reader.h"
#include "latticeworld/language/grounded/environment/attributes/added_values.h"
#include "latticeworld/language/grounded/environment/attributes/coarse_reader.h"
#include "latticeworld/language/grounded/environment/attributes/fine_reader.h"
#include "latticeworld/language/grounded/environment/attributes/measure_reader.h"
#include "latticeworld/language/grounded/environment/known_spelling.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_counts.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_each.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_measures.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_multiples.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_nones.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_numerals.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_ranges.h"
#include "latticeworld/language/grounded/environment/mending/amounts/mend_shares.h"
#include "latticeworld/language/grounded/environment/mending/mend_asides.h"
#include "latticeworld/language/grounded/environment/mending/mend_compounds.h"
#include "latticeworld/language/grounded/environment/mending/mend_denials.h"
#include "latticeworld/language/grounded/environment/mending/mend_exceptions.h"
#include "latticeworld/language/grounded/environment/mending/mend_fields.h"
#include "latticeworld/language/grounded/environment/mending/mend_labels.h"
#include "latticeworld/language/grounded/environment/mending/mend_lacks.h"
#include "latticeworld/language/grounded/environment/mending/mend_robots.h"
#include "latticeworld/language/grounded/environment/mending/mend_sides.h"
#include "latticeworld/language/grounded/environment/mending/mend_speakers.h"
#include "latticeworld/language/grounded/environment/mending/mend_surfaces.h"
#include "latticeworld/language/grounded/environment/mending/mend_times.h"
#include "latticeworld/language/grounded/environment/mending/mend_ways.h"
#include "latticeworld/language/grounded/environment/token_notes.h"
#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/places.h"

namespace latticeworld {
namespace {

// Mistakes in words too short, or too near to other words, for the dictionary to tell.
std::string_view ShortMistake(std::string_view word) {
  constexpr std::pair<std::string_view, std::string_view> kMistakes[] = {
      {"teh", "the"},      {"hte", "the"},       {"adn", "and"},      {"wiht", "with"},
      {"lft", "left"},     {"rigth", "right"},   {"rihgt", "right"},  {"suny", "sunny"},
      {"flys", "flies"},   {"obove", "above"},   {"abov", "above"},   {"wheet", "wheat"},
      {"nite", "night"},   {"rian", "rain"},     {"fogy", "foggy"},   {"rode", "road"},
      {"gras", "grass"},   {"els", "else"},      {"leafs", "leaves"}, {"wolfs", "wolves"},
      {"twelf", "twelve"}, {"twelfe", "twelve"}, {"tree", "three"},   {"sheeps", "sheep"}};
  for (const auto& [mistake, meant] : kMistakes) {
    if (word == mistake) return meant;
  }
  return {};
}

// Whether agents are named behind the token, more than one, as behind a number.
bool CountsAgents(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t at) {
  if (at + 1 >= tokens.size() || tokens[at + 1].kind != TokenKind::kWord) return false;
  if (at > 0 && tokens[at - 1].kind == TokenKind::kWord && tokens[at - 1].text != "and") {
    return false;
  }
  const auto species = words.species.At(tokens, at + 1);
  return species.tokens > 0 && species.rows.front()->plural && species.rows.front()->exact;
}

void MendSpelling(const AddedValueWords& added, const EnvironmentWords& words,
                  std::vector<Token>* tokens, std::vector<std::string>* warnings) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    Token& token = (*tokens)[at];
    if (token.kind != TokenKind::kWord || added.known.count(token.text) > 0) continue;
    std::string_view mended = ShortMistake(token.text);
    // "six warriors rode", but "by the rode", "a drown flying".
    const std::string_view before =
        at > 0 ? std::string_view((*tokens)[at - 1].text) : std::string_view();
    const bool noun = before == "the" || before == "a" || before == "one";
    if (token.text == "rode" && !noun) mended = {};
    // "tree drones"
    if (token.text == "tree" && !CountsAgents(words, *tokens, at)) mended = {};
    if (token.text == "gras" && before == "mardi") mended = {};
    if (token.text == "drown" && noun) mended = "drone";
    if (mended.empty()) mended = MendedWord(token.text);
    if (mended.empty()) continue;
    warnings->push_back("read " + Quote(token.text) + " as " + Quote(mended));
    token.text = std::string(mended);
  }
}

// "up right" and "right up" are the upper right.
void MendPlaces(std::vector<Token>* tokens) {
  const auto word = [&](std::size_t at) -> std::string_view {
    return at < tokens->size() ? std::string_view((*tokens)[at].text) : std::string_view();
  };
  const auto is_end = [&](std::size_t at) {
    if (at >= tokens->size() || (*tokens)[at].kind == TokenKind::kComma ||
        (*tokens)[at].kind == TokenKind::kStop) {
      return true;
    }
    for (const std::string_view end :
         {"corner", "side", "part", "zone", "area", "and", "quarter", "by", "near"}) {
      if (word(at) == end) return true;
    }
    return false;
  };
  const auto level = [](std::string_view said) -> std::string_view {
    return said == "up" ? "upper" : said == "down" ? "lower" : "";
  };
  const auto is_side = [](std::string_view said) { return said == "left" || said == "right"; };
  // "the left-hand corner" is the left one.
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    if (word(at) == "hand" && is_side(word(at - 1))) {
      tokens->erase(tokens->begin() + static_cast<std::ptrdiff_t>(at));
    }
  }
  // "up at left"
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const bool apart = !level(word(at)).empty() && (word(at + 1) == "at" || word(at + 1) == "to") &&
                       is_side(word(at + 2)) && is_end(at + 3);
    if (apart) (*tokens)[at + 1].text = "the";
    if (apart) std::swap((*tokens)[at].text, (*tokens)[at + 1].text);
    if (apart) (*tokens)[at + 1].text = std::string(level(word(at + 1)));
  }
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    // "up to the left", "down on the right"
    const bool apart = (word(at + 1) == "to" || word(at + 1) == "on" || word(at + 1) == "in") &&
                       word(at + 2) == "the" && is_side(word(at + 3)) && is_end(at + 4);
    if (level(word(at)).empty() || !apart) continue;
    (*tokens)[at + 2].text = std::string(level(word(at)));
    (*tokens)[at].text = "at";
    (*tokens)[at + 1].text = "the";
  }
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (!is_end(at + 2)) continue;
    if (!level(word(at)).empty() && is_side(word(at + 1))) {
      (*tokens)[at].text = std::string(level(word(at)));
    } else if (is_side(word(at)) && !level(word(at + 1)).empty()) {
      const std::string side = (*tokens)[at].text;
      (*tokens)[at].text = std::string(level(word(at + 1)));
      (*tokens)[at + 1].text = side;
    } else {
      continue;
    }
    // "the corner up right"
    if (at > 0 && word(at - 1) == "corner") {
      std::swap((*tokens)[at - 1].text, (*tokens)[at].text);
      std::swap((*tokens)[at].text, (*tokens)[at + 1].text);
    }
  }
}

// "Twelve deer, take horses if you have no deer": the nearest there is stands in by itself.
void DropSubstitutes(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 5;
  const auto word = [&](std::size_t at) -> std::string_view {
    return at < tokens->size() ? std::string_view((*tokens)[at].text) : std::string_view();
  };
  const auto is_pause = [&](std::size_t at) {
    return at >= tokens->size() || (*tokens)[at].kind != TokenKind::kWord;
  };
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const bool takes = word(at) == "take" || word(at) == "use" || word(at) == "or" ||
                       word(at) == "else" || word(at) == "otherwise";
    if (!takes) continue;
    std::size_t condition = at + 1;
    while (condition < at + kReach && !is_pause(condition) && word(condition) != "if") ++condition;
    if (word(condition) != "if") continue;
    std::size_t end = condition;
    bool none = false;
    for (; !is_pause(end); ++end) {
      none = none || word(end) == "no" || word(end) == "without" || word(end) == "not" ||
             word(end) == "lack" || word(end) == "unavailable";
    }
    if (!none) continue;
    tokens->erase(tokens->begin() + static_cast<std::ptrdiff_t>(at),
                  tokens->begin() + static_cast<std::ptrdiff_t>(end));
  }
}

// Numbers and places are known wherever they stand.
void NoteCommonPhrases(NotedTokens* noted) {
  for (std::size_t at = 0; at < noted->size(); ++at) {
    const std::size_t known =
        std::max(MatchNumber(noted->tokens, at).tokens, MatchPlace(noted->tokens, at).tokens);
    for (std::size_t i = 0; i < known; ++i) noted->notes[at + i].known = true;
  }
}

// Every word that some table has is known, even where nothing could be made of it.
void NoteKnownWords(const EnvironmentWords& words, NotedTokens* noted) {
  for (std::size_t at = 0; at < noted->size(); ++at) {
    const std::size_t known = std::max(
        {words.assets.LengthAt(noted->tokens, at), words.quantities.LengthAt(noted->tokens, at),
         words.features.LengthAt(noted->tokens, at), words.densities.LengthAt(noted->tokens, at)});
    for (std::size_t i = 0; i < known; ++i) noted->notes[at + i].known = true;
  }
}

// Unknown words, neighbours together.
std::vector<std::string> NotUnderstoodIn(const NotedTokens& noted) {
  std::vector<std::string> unknown;
  std::size_t first = 0;
  bool open = false;
  for (std::size_t at = 0; at <= noted.size(); ++at) {
    const bool is_unknown = at < noted.size() && !noted.IsPause(at) && !noted.notes[at].known;
    if (is_unknown && !open) first = at;
    if (!is_unknown && open) unknown.emplace_back(noted.Text(first, at));
    open = is_unknown;
  }
  return unknown;
}

}  // namespace

HeardEnvironment ParseEnvironmentInstruction(std::string_view instruction,
                                             const Catalogue& catalogue) {
  const AddedValueWords added = AddedValueWordsOf(catalogue);
  const EnvironmentWords& words = added.words ? *added.words : GetEnvironmentWords();
  HeardEnvironment heard;
  std::vector<Token> tokens = Tokenize(instruction);
  MendSpelling(added, words, &tokens, &heard.warnings);
  MendPlaces(&tokens);
  DropSubstitutes(&tokens);
  MendCompounds(words, instruction, &tokens);
  MendTimes(words, &tokens);
  MendAsides(words, &tokens);
  MendFields(words, &tokens);
  MendRanges(words, instruction, &tokens);
  MendLabels(words, &tokens);
  MendExceptions(words, &tokens);
  MendNones(words, &tokens);
  MendLacks(words, instruction, &tokens);
  MendSurfaces(words, &tokens);
  MendDenials(words, &tokens);
  MendRobots(words, &tokens);
  MendShares(words, &tokens);
  MendNumerals(words, &tokens);
  MendEach(words, &tokens);
  MendCounts(words, &tokens);
  MendSpeakers(&tokens);
  MendMultiples(words, &tokens);
  MendMeasures(&tokens);
  MendSides(words, &tokens);
  MendWays(&tokens);
  NotedTokens noted = NoteScopes(instruction, std::move(tokens), words);
  std::vector<HeardMeasure> measures = ReadMeasures(&noted);
  ReadAgents(words, &noted, &heard);
  ReadFine(words, &measures, &noted, &heard);
  ReadCoarse(words, measures, &noted, &heard);
  NoteCommonPhrases(&noted);
  NoteKnownWords(words, &noted);
  heard.not_understood = NotUnderstoodIn(noted);
  return heard;
}

}  // namespace latticeworld
