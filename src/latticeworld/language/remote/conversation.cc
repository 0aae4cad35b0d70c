#include "latticeworld/language/remote/conversation.h"

#include <cstddef>
#include <set>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/language/chat/kept_form.h"
#include "latticeworld/language/remote/thinking_filter.h"

namespace latticeworld {
namespace {

// At most this much of an answer goes back to the model; a whole environment has about 3000 bytes.
constexpr std::size_t kMostAnswerBytesSaid = 12000;
// A known failing of models in a JSON grammar: blanks without end.
constexpr std::size_t kMostTrailingBlanks = 1000;

bool EndsInBlanks(std::string_view text) {
  if (text.size() < kMostTrailingBlanks) return false;
  return text.substr(text.size() - kMostTrailingBlanks).find_first_not_of(" \t\r\n") ==
         std::string_view::npos;
}

// UTF-8 without NUL, whatever came: what is recorded and sent back must be text.
std::string MakeText(std::string text) {
  if (ValidateText("answer", text, text.size()).ok()) return text;
  for (char& c : text) {
    if (static_cast<unsigned char>(c) >= 0x80 || c == '\0') c = '?';
  }
  return text;
}

// The answer as the model sees it again: without its thinking, cut when it is long.
std::string AnswerSaid(std::string_view answer) {
  const std::string text = WithoutThinking(answer);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return "(no answer)";
  if (text.size() <= kMostAnswerBytesSaid) return text;
  // The cut is before a character and not within one.
  std::size_t end = kMostAnswerBytesSaid;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + " [...]";
}

std::uint64_t SeedOfTurn(std::uint64_t seed, int turn) {
  return turn == 0 ? seed : StreamSeed(seed, "language repair " + std::to_string(turn));
}

ModelReply Record(std::string_view purpose, const ChatReply& reply) {
  ModelReply record;
  record.purpose = std::string(purpose);
  record.model = reply.model;
  record.text = reply.text;
  record.finish_reason = reply.finish_reason;
  record.prompt_tokens = reply.prompt_tokens;
  record.completion_tokens = reply.completion_tokens;
  record.retries = reply.retries;
  record.seconds = reply.total_s;
  record.warnings = reply.warnings;
  return record;
}

// The warning that a server enforces nothing, or "": its answer is out of the form that it was told
// in a language of its own.
std::string FormWarning(const ChatReply& reply, const AnswerForm& form) {
  const std::string answer = WithoutThinking(reply.text);
  const bool whole = reply.finish_reason != "length" && reply.finish_reason != "cut";
  if (KeepsForm(answer, whole, form, reply.form) != KeptForm::kNo) return "";
  return "the chat server does not enforce the form of answers: one that it was told the form of "
         "begins " +
         Quote(answer, 60) + "; name its own dialect, or update it (docs/language.md)";
}

}  // namespace

std::vector<std::string> ServerWarnings(const std::vector<ModelReply>& replies, std::size_t from) {
  std::vector<std::string> warnings;
  std::set<std::string> kinds;
  for (std::size_t i = from; i < replies.size(); ++i) {
    for (const std::string& warning : replies[i].warnings) {
      if (kinds.insert(warning.substr(0, warning.find(':'))).second) warnings.push_back(warning);
    }
  }
  return warnings;
}

Status Ask(ChatServer* server, Question question, const Progress& progress,
           std::vector<ModelReply>* replies) {
  ChatRequest request = std::move(question.first);
  const std::size_t opening = request.messages.size();
  const std::uint64_t seed = request.seed;
  const std::size_t before = replies->size();
  for (int turn = 0;; ++turn) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    // Each turn is a request with a seed of its own.
    request.seed = SeedOfTurn(seed, turn);
    const AnswerListener listener = question.make_listener();
    Result<ChatReply> reply = server->Complete(
        request,
        [&listener](std::string_view text) { return listener(text) && !EndsInBlanks(text); },
        progress);
    if (!reply.ok()) {
      if (turn == 0) return reply.status();
      return reply.status().WithContext("repair turn " + std::to_string(turn));
    }
    // The reply is recorded as text that is legal UTF-8, whatever the server sent.
    reply->text = MakeText(std::move(reply->text));
    reply->model = MakeText(std::move(reply->model));
    reply->finish_reason = MakeText(std::move(reply->finish_reason));
    const std::string out_of_form = FormWarning(*reply, request.form);
    if (!out_of_form.empty()) reply->warnings.push_back(out_of_form);
    replies->push_back(Record(question.purpose, *reply));

    const Status read = question.read(reply->text);
    if (read.ok()) return Status();
    // What is wrong with it goes back to the model, or ends the conversation after the last turn.
    std::vector<Violation> violations = read.violations();
    if (violations.empty()) violations.push_back({"unusable", "", read.message(), ""});
    if (reply->finish_reason == "length") {
      violations.push_back({"cut_answer", "",
                            "the answer was cut at its limit of " +
                                std::to_string(request.max_tokens) +
                                " tokens; think briefly and write nothing but what is asked for",
                            ""});
    }
    if (turn >= question.repair_turns) {
      for (const std::string& warning : ServerWarnings(*replies, before)) {
        violations.push_back({"server", "", warning, ""});
      }
      const Status last = Status::FromViolations(
          "the language model gave no legal " + std::string(question.purpose) + " in " +
              std::to_string(turn + 1) + (turn == 0 ? " answer" : " answers; the last"),
          std::move(violations));
      return Status(StatusCode::kDataLoss, last.message(), last.violations());
    }
    // The next turn has the opening, the last answer and what is wrong with it.
    request.messages.resize(opening);
    request.messages.push_back({ChatRole::kAssistant, AnswerSaid(reply->text), ""});
    request.messages.push_back({ChatRole::kUser, question.repair_text(violations), ""});
  }
}

}  // namespace latticeworld
