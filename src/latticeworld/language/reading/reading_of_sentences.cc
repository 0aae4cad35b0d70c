#include "latticeworld/language/reading/reading_of_sentences.h"

#include <map>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/layout_of_sentences.h"
#include "latticeworld/language/reading/text_warnings.h"

namespace latticeworld {
namespace {

// The words of a text that sentences come from, in the place of the sentences.
class Quotes {
 public:
  Quotes(std::string_view text, const std::vector<std::string>& sentences, SentenceKind kind,
         Vocabulary vocabulary) {
    const QuotedText quoted(text, kind, vocabulary);
    for (const std::string& sentence : sentences) {
      const auto [entry, is_new] = quote_of_.try_emplace(sentence);
      if (is_new) entry->second = quoted.QuoteOf(sentence);
    }
  }

  void Quote(std::string* words) const {
    if (const auto quote = quote_of_.find(*words); quote != quote_of_.end()) *words = quote->second;
  }

 private:
  std::map<std::string, std::string> quote_of_;
};

}  // namespace

LayoutReading ReadingOfSentences(const LayoutRequest& request, std::vector<std::string> sentences) {
  LayoutReading reading;
  reading.sentences = std::move(sentences);
  reading.of_sentences = true;
  reading.plan = LayoutOfSentences(reading.sentences, request.vocabulary);
  WarnOfText(request.instruction, SentenceKind::kLayout, &reading.plan.warnings);
  reading.coverage =
      CoverageOf(request.instruction, reading.sentences, SentenceKind::kLayout, request.vocabulary);
  AddLost(reading.coverage, {}, &reading.plan.not_understood);
  const Quotes quotes(request.instruction, reading.sentences, SentenceKind::kLayout,
                      request.vocabulary);
  for (Claim& claim : reading.plan.claims) quotes.Quote(&claim.words);
  return reading;
}

EnvironmentReading ReadingOfSentences(const EnvironmentRequest& request,
                                      std::vector<std::string> sentences) {
  EnvironmentReading reading;
  reading.sentences = std::move(sentences);
  reading.heard = EnvironmentOfSentences(reading.sentences, *request.catalogue);
  WarnOfText(request.instruction, SentenceKind::kEnvironment, &reading.heard.warnings);
  const Vocabulary vocabulary = request.layout->vocabulary;
  reading.coverage =
      CoverageOf(request.instruction, reading.sentences, SentenceKind::kEnvironment, vocabulary);
  AddLost(reading.coverage, {}, &reading.heard.not_understood);
  const Quotes quotes(request.instruction, reading.sentences, SentenceKind::kEnvironment,
                      vocabulary);
  for (HeardCoarse& coarse : reading.heard.coarse) quotes.Quote(&coarse.words);
  for (FineWish& wish : reading.heard.fine) quotes.Quote(&wish.claim.words);
  for (AgentWish& wish : reading.heard.agents) quotes.Quote(&wish.words);
  for (EnvironmentClaim& claim : reading.heard.absences) quotes.Quote(&claim.words);
  return reading;
}

}  // namespace latticeworld
