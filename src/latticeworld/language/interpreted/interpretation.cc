#include "latticeworld/language/interpreted/interpretation.h"

#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/interpreted/prompts.h"
#include "latticeworld/language/interpreted/sentences.h"
#include "latticeworld/language/remote/conversation.h"

namespace latticeworld {
namespace {

constexpr char kReadBack[] = "read_back";  // code of what is no violation but a question

}  // namespace

Result<std::string> Interpret(ChatServer* server, const Interpretation& interpretation,
                              const Progress& progress, std::vector<ModelReply>* replies) {
  std::optional<std::vector<std::string>> said;
  int turns = 0;
  Question question;
  question.purpose = interpretation.purpose;
  question.first.messages = interpretation.messages;
  question.first.form = SentencesForm(std::string(interpretation.purpose));
  question.first.max_tokens = interpretation.max_tokens;
  question.first.temperature = interpretation.temperature;
  question.first.seed = interpretation.seed;
  question.repair_turns = interpretation.read_back_turns;
  question.make_listener = [] { return [](std::string_view) { return true; }; };
  question.read = [&](std::string_view answer) {
    ++turns;
    LW_ASSIGN_OR_RETURN(std::vector<std::string> sentences, ReadSentences(answer));
    const bool settled = said == sentences || turns > interpretation.read_back_turns;
    said = std::move(sentences);
    if (settled) return Status();
    return Status::FromViolations(
        "to be looked over", {{kReadBack, "", interpretation.read_back(Join(*said, " ")), ""}});
  };
  question.repair_text = [](const std::vector<Violation>& violations) {
    if (violations.front().code == kReadBack) return ReadBackText(violations.front().message);
    return SentencesRepairText(violations);
  };
  const Status asked = Ask(server, std::move(question), progress, replies);
  if (!asked.ok() && (!said || asked.code() == StatusCode::kCancelled)) return asked;
  return Join(*said, " ");
}

}  // namespace latticeworld
