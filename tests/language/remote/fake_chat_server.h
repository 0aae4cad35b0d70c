#ifndef LATTICEWORLD_TESTS_LANGUAGE_REMOTE_FAKE_CHAT_SERVER_H_
#define LATTICEWORLD_TESTS_LANGUAGE_REMOTE_FAKE_CHAT_SERVER_H_

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/chat/chat_server.h"

namespace latticeworld {

// A chat server that says what a test wrote down for it, a piece at a time, and remembers what it
// was asked. It stops when its listener wants no more.
class FakeChatServer final : public ChatServer {
 public:
  struct Answer {
    Status error;  // not OK: instead of an answer
    std::string text;
    std::string finish_reason = "stop";
    std::size_t piece_bytes = 7;
    std::function<void()> before = [] {};  // called when it is asked
    FormLanguage form = FormLanguage::kNone;
    std::vector<std::string> warnings{};
    double log_probability = 0.0;
  };

  bool sees() const override { return sees_; }
  Result<ChatReply> Complete(const ChatRequest& request, const AnswerListener& listener,
                             const Progress& progress) override;

  void set_sees(bool sees) { sees_ = sees; }
  FakeChatServer& Say(std::string text) { return Say(Answer{Status(), std::move(text)}); }
  FakeChatServer& Say(Answer answer) {
    answers_.push_back(std::move(answer));
    return *this;
  }
  FakeChatServer& Fail(Status error) { return Say(Answer{std::move(error), ""}); }

  const std::vector<ChatRequest>& requests() const { return requests_; }
  // Characters that were said of all answers: less than their lengths where they were cut short.
  std::size_t said() const { return said_; }

 private:
  bool sees_ = false;
  std::vector<Answer> answers_;
  std::vector<ChatRequest> requests_;
  std::size_t said_ = 0;
};

// 32 rows of 32 legal letters, no two rows alike.
std::string LegalMatrix();
// The same with `row` (from 0) replaced.
std::string MatrixWithRow(int row, const std::string& text);
// A legal environment as JSON.
std::string LegalEnvironment();

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_REMOTE_FAKE_CHAT_SERVER_H_
