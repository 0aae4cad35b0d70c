#include "language/remote/fake_chat_server.h"

#include <algorithm>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {

Result<ChatReply> FakeChatServer::Complete(const ChatRequest& request,
                                           const AnswerListener& listener,
                                           const Progress& progress) {
  const std::size_t turn = requests_.size();
  requests_.push_back(request);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  if (turn >= answers_.size()) return Internal("the test's server was asked too often");
  const Answer& answer = answers_[turn];
  answer.before();
  if (!answer.error.ok()) return answer.error;
  ChatReply reply;
  reply.model = "fake";
  reply.prompt_tokens = 100 + static_cast<int>(turn);
  reply.completion_tokens = 10 + static_cast<int>(turn);
  reply.retries = static_cast<int>(turn);
  reply.total_s = 0.25 * static_cast<double>(turn + 1);
  reply.finish_reason = answer.finish_reason;
  reply.form = answer.form;
  reply.warnings = answer.warnings;
  reply.log_probability = answer.log_probability;
  for (std::size_t at = 0; at < answer.text.size(); at += answer.piece_bytes) {
    reply.text += answer.text.substr(at, answer.piece_bytes);
    if (listener && !listener(reply.text)) {
      reply.finish_reason = "cut";
      break;
    }
  }
  said_ += reply.text.size();
  return reply;
}

std::string LegalMatrix() {
  const std::string letters = "ABDFGRW";
  std::string text;
  for (int row = 0; row < 32; ++row) {
    for (int col = 0; col < 32; ++col) {
      text += letters[static_cast<std::size_t>(row * row + 3 * col + row * col) % letters.size()];
    }
    text += '\n';
  }
  return text;
}

std::string MatrixWithRow(int row, const std::string& text) {
  std::vector<std::string> lines = Split(LegalMatrix(), '\n');
  lines[static_cast<std::size_t>(row)] = text;
  return Join(lines, "\n");
}

std::string LegalEnvironment() {
  EnvironmentConfig environment;
  environment.coarse.season = Season::kAutumn;
  environment.fine = DeriveFineAttributes(environment.coarse);
  environment.agents = {{AgentCategory::kSheep, 9, AgentState::kGrazing, Region::kLowerLeft}};
  return ToJson(environment);
}

}  // namespace latticeworld
