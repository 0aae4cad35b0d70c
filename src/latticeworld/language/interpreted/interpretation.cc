#include "latticeworld/language/interpreted/interpretation.h"

#include <cstddef>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/interpreted/prompts.h"
#include "latticeworld/language/interpreted/sentences.h"
#include "latticeworld/language/reading/coverage.h"
#include "latticeworld/language/remote/conversation.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {
namespace {

// What is wrong with the sentences, and what they leave out.
std::vector<Violation> Check(const Interpretation& interpretation,
                             const std::vector<std::string>& sentences) {
  std::vector<Violation> violations;
  for (std::size_t i = 0; i < sentences.size(); ++i) {
    if (ReadSentence(sentences[i], interpretation.kind).has_value()) continue;
    violations.push_back({"no_form", "/sentences/" + std::to_string(i),
                          Quote(sentences[i]) + " has none of the forms", Quote(sentences[i])});
  }
  const TextCoverage coverage =
      CoverageOf(interpretation.text, sentences, interpretation.kind, interpretation.vocabulary);
  for (const std::string& words : coverage.lost) {
    violations.push_back({"lost_words", "",
                          "no sentence says anything of " + Quote(words) +
                              " in the description; where it asks for nothing leave it out again",
                          Quote(words)});
  }
  return violations;
}

}  // namespace

Result<std::vector<std::string>> Interpret(ChatServer* server, const Interpretation& interpretation,
                                           const Progress& progress,
                                           std::vector<ModelReply>* replies) {
  std::optional<std::vector<std::string>> said;
  int turns = 0;
  Question question;
  question.purpose = interpretation.purpose;
  question.first.messages = interpretation.messages;
  question.first.form = SentencesForm(std::string(interpretation.purpose));
  question.first.max_tokens = interpretation.max_tokens;
  question.first.temperature = interpretation.temperature;
  question.first.seed = interpretation.seed;
  question.repair_turns = interpretation.repair_turns;
  question.make_listener = [] { return [](std::string_view) { return true; }; };
  question.read = [&](std::string_view answer) {
    ++turns;
    LW_ASSIGN_OR_RETURN(std::vector<std::string> sentences, ReadSentences(answer));
    const bool settled = said == sentences || turns > interpretation.repair_turns;
    said = std::move(sentences);
    if (settled) return Status();
    return Status::FromViolations("to be said another way", Check(interpretation, *said));
  };
  question.repair_text = SentencesRepairText;
  const Status asked = Ask(server, std::move(question), progress, replies);
  if (!asked.ok() && (!said || asked.code() == StatusCode::kCancelled)) return asked;
  return *said;
}

}  // namespace latticeworld
