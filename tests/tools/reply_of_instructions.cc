// What the model that reads replies to a text, greedily, with each kind of instructions that this
// processor has: for each the model is opened anew, and a line of standard output holds the reply
// and the logarithm of its probability, to the last bit, as JSON.
// Usage: reply_of_instructions MODEL.gguf layout|environment TEXT

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "latticeworld/language/local/local.h"
#include "latticeworld/language/local/weights/instructions.h"
#include "latticeworld/language/sentences/sentence_grammar.h"

namespace latticeworld {
namespace {

Status Run(const std::string& model, SentenceKind kind, const std::string& text) {
  ChatRequest request;
  request.messages = {
      {ChatRole::kSystem, kind == SentenceKind::kLayout ? "layout" : "environment", {}},
      {ChatRole::kUser, text, {}}};
  request.form.gbnf = SentenceGrammar(kind);
  request.temperature = 0.0;
  for (const Instructions instructions : kAllInstructions) {
    if (!HasInstructions(instructions)) continue;
    UseInstructions(instructions);
    LW_ASSIGN_OR_RETURN(const auto server, MakeLocalChatServer(model));
    LW_ASSIGN_OR_RETURN(const ChatReply reply, server->Complete(request, {}, Progress()));
    std::cout << nlohmann::json({reply.text, reply.log_probability}) << std::endl;
  }
  return Status();
}

}  // namespace
}  // namespace latticeworld

int main(int argc, char** argv) {
  using latticeworld::SentenceKind;
  if (argc != 4) return 2;
  const auto kind =
      std::string_view(argv[2]) == "layout" ? SentenceKind::kLayout : SentenceKind::kEnvironment;
  const latticeworld::Status status = latticeworld::Run(argv[1], kind, argv[3]);
  if (status.ok()) return 0;
  std::cerr << status.message() << "\n";
  return 1;
}
