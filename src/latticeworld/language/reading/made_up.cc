#include "latticeworld/language/reading/made_up.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/reading_of_sentences.h"
#include "latticeworld/language/reading/text_units.h"
#include "latticeworld/language/reading/words/table_words.h"
#include "latticeworld/language/reading/words/topics.h"

namespace latticeworld {
namespace {

using Numbers = std::map<std::string, int>;  // how often each is said

Numbers NumbersIn(const std::vector<std::string>& texts, Vocabulary vocabulary) {
  Numbers numbers;
  for (const std::string& text : texts) {
    for (const TextUnit& unit : UnitsOf(text, SentenceKind::kEnvironment, vocabulary)) {
      for (const std::string& key : unit.keys)
        if (StartsWith(key, "number ")) ++numbers[key];
    }
  }
  return numbers;
}

}  // namespace

bool AreOfSame(const FineWish& one, const FineWish& other) {
  const EnvironmentClaim& a = one.claim;
  const EnvironmentClaim& b = other.claim;
  return a.kind == b.kind && a.asset == b.asset && a.variant_key == b.variant_key &&
         a.parameter_key == b.parameter_key;
}

MadeUp::MadeUp(const EnvironmentRequest& request, const EnvironmentReading& reading)
    : request_(request), reading_(reading) {}

bool MadeUp::Is(const FineWish& wish, const FineWish& other) const {
  const EnvironmentClaim& mine = wish.claim;
  const EnvironmentClaim& theirs = other.claim;
  if (mine.kind != EnvironmentClaimKind::kParameter) return false;
  if (mine.parameter_key == ParameterKey::kRotationYaw) return false;
  if (mine.least <= theirs.most && theirs.least <= mine.most) return false;
  std::vector<std::string> saying;
  std::copy_if(reading_.sentences.begin(), reading_.sentences.end(), std::back_inserter(saying),
               [&](const std::string& sentence) {
                 const std::vector<FineWish> fine = HeardOf(sentence).fine;
                 return std::any_of(fine.begin(), fine.end(), [&wish](const FineWish& said) {
                   return AreOfSame(said, wish);
                 });
               });
  return AreNumbersOf(saying);
}

bool MadeUp::Is(const EnvironmentClaim& absence) const {
  if (absence.kind != EnvironmentClaimKind::kTotalAgents) return false;
  int least = 0;
  for (const AgentWish& wish : reading_.heard.agents) least += wish.least;
  if (absence.most_quantity >= least) return false;
  std::vector<std::string> saying;
  std::copy_if(reading_.sentences.begin(), reading_.sentences.end(), std::back_inserter(saying),
               [this](const std::string& sentence) {
                 const std::vector<EnvironmentClaim> absences = HeardOf(sentence).absences;
                 return !absences.empty() &&
                        absences.front().kind == EnvironmentClaimKind::kTotalAgents;
               });
  return AreNumbersOf(saying);
}

bool MadeUp::AreNumbersOf(const std::vector<std::string>& sentences) const {
  const Vocabulary vocabulary = request_.layout->vocabulary;
  const Numbers of_text = NumbersIn({request_.instruction}, vocabulary);
  const Numbers own = NumbersIn(sentences, vocabulary);
  const Numbers of_all = NumbersIn(reading_.sentences, vocabulary);
  return !own.empty() && std::none_of(own.begin(), own.end(), [&](const auto& number) {
    const auto in_text = of_text.find(number.first);
    return in_text != of_text.end() && in_text->second >= of_all.at(number.first);
  });
}

HeardEnvironment MadeUp::HeardOf(const std::string& sentence) const {
  return EnvironmentOfSentences({sentence}, *request_.catalogue);
}

EnvironmentReading WithoutUnspoken(const EnvironmentRequest& request, EnvironmentReading reading,
                                   const std::vector<std::string>& second) {
  std::set<std::string> topics_of_second;
  for (const std::string& sentence : second) {
    const std::vector<std::string> topics = TopicsOf(sentence);
    topics_of_second.insert(topics.begin(), topics.end());
  }
  const std::set<std::string> words = TableWordsOf(request.instruction);
  std::vector<std::string> kept, unspoken;
  for (const std::string& sentence : reading.sentences) {
    const std::vector<std::string> topics = TopicsOf(sentence);
    const bool is_spoken = std::any_of(topics.begin(), topics.end(), [&](const std::string& topic) {
      return topics_of_second.count(topic) > 0 || SpeakOf(words, topic);
    });
    (topics.empty() || is_spoken ? kept : unspoken).push_back(sentence);
  }
  if (unspoken.empty()) return reading;
  EnvironmentReading rest = ReadingOfSentences(request, std::move(kept));
  rest.log_probability = reading.log_probability;
  for (std::string& sentence : unspoken) sentence = Quote(sentence);
  rest.heard.warnings.push_back("left out, for no word of the text speaks of it: " +
                                Join(unspoken, ", "));
  return rest;
}

}  // namespace latticeworld
