// Instruction -> tokens, with slips of the pen mended -> scopes of negations and figures of speech
// -> measures, agents, fine attributes, coarse attributes, each by its own reader over the same
// tokens.

#include "latticeworld/language/grounded/environment/environment_parser.h"

#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/environment/agent_reader.h"
#include "latticeworld/language/grounded/environment/coarse_reader.h"
#include "latticeworld/language/grounded/environment/fine_reader.h"
#include "latticeworld/language/grounded/environment/known_spelling.h"
#include "latticeworld/language/grounded/environment/measure_reader.h"
#include "latticeworld/language/grounded/environment/token_notes.h"
#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/places.h"

namespace latticeworld {
namespace {

void MendSpelling(std::vector<Token>* tokens, std::vector<std::string>* warnings) {
  for (Token& token : *tokens) {
    if (token.kind != TokenKind::kWord) continue;
    const std::string_view mended = MendedWord(token.text);
    if (mended.empty()) continue;
    warnings->push_back("read " + Quote(token.text) + " as " + Quote(mended));
    token.text = std::string(mended);
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

HeardEnvironment ParseEnvironmentInstruction(std::string_view instruction) {
  const EnvironmentWords& words = GetEnvironmentWords();
  HeardEnvironment heard;
  std::vector<Token> tokens = Tokenize(instruction);
  MendSpelling(&tokens, &heard.warnings);
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
