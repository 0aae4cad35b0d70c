// What this project's decoder makes of a model file, in the manner of
// tests/language/local/llama/llama_answers.mjs: one JSON value a line from standard input, each
// answered with one line.
//   {"text": "..."}                   its tokens, without any that control
//   {"tokens": [...], "count": n}     the n tokens that follow, each the likeliest
//   {"tokens": [...]}                 the logits of what follows
//   {"picture": "PATH", "tokens": [...]}   the logits after a height map, which the eyes beside the
//                                     model file show it, and the tokens
//   {"messages": [{"role", "content"}, ...]}   the tokens of a conversation
// Usage: local_answers MODEL.gguf

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/language/local/decoding/height_eyes.h"
#include "latticeworld/language/local/decoding/llama_decoder.h"
#include "latticeworld/language/local/decoding/llama_model.h"
#include "latticeworld/language/local/tokens/chat_text.h"
#include "latticeworld/language/local/tokens/tokenizer.h"
#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

Json Following(LlamaDecoder* decoder, int count) {
  Json answer = Json::array();
  for (int i = 0; i < count; ++i) {
    const auto& logits = decoder->logits();
    const auto best =
        static_cast<TokenId>(std::max_element(logits.begin(), logits.end()) - logits.begin());
    answer.push_back(best);
    if (!decoder->Append({best}, Progress()).ok()) break;
  }
  return answer;
}

Json TokensOfTalk(const Json& messages, const Tokenizer& tokenizer, ChatStyle style) {
  std::vector<ChatMessage> talk;
  for (const Json& message : messages) {
    const std::string role = message.at("role");
    talk.push_back({role == "system"      ? ChatRole::kSystem
                    : role == "assistant" ? ChatRole::kAssistant
                                          : ChatRole::kUser,
                    message.at("content"), ""});
  }
  return ChatTokens(tokenizer, style, talk);
}

Result<Json> Shown(const std::string& picture_path, const std::vector<TokenId>& tokens,
                   const std::string& model_path, LlamaDecoder* decoder) {
  LW_ASSIGN_OR_RETURN(
      const HeightEyes eyes,
      HeightEyes::Open(std::filesystem::path(model_path).replace_extension(".eyes.gguf")));
  LW_ASSIGN_OR_RETURN(const std::string picture, ReadFile(picture_path, 1u << 24));
  LW_ASSIGN_OR_RETURN(const std::vector<float> seen, eyes.See(picture));
  LW_RETURN_IF_ERROR(decoder->AppendEmbeddings(seen.data(), eyes.places(), Progress()));
  LW_RETURN_IF_ERROR(decoder->Append(tokens, Progress()));
  return Json(decoder->logits());
}

Status Run(const std::string& path) {
  LW_ASSIGN_OR_RETURN(const GgufFile file, GgufFile::Open(path));
  LW_ASSIGN_OR_RETURN(const Tokenizer tokenizer, Tokenizer::Read(file));
  LW_ASSIGN_OR_RETURN(LlamaModel read, ReadLlamaModel(file));
  LW_ASSIGN_OR_RETURN(const std::string chat_template, file.Text("tokenizer.chat_template"));
  const auto model = std::make_shared<const LlamaModel>(std::move(read));
  for (std::string line; std::getline(std::cin, line);) {
    const Json asked = Json::parse(line);
    if (asked.contains("text")) {
      std::cout << Json(tokenizer.Encode(asked.at("text").get<std::string>())) << std::endl;
    } else if (asked.contains("messages")) {
      std::cout << TokensOfTalk(asked.at("messages"), tokenizer, ChatStyleOf(chat_template))
                << std::endl;
    } else if (asked.contains("picture")) {
      LlamaDecoder decoder(model);
      LW_ASSIGN_OR_RETURN(const Json logits,
                          Shown(asked.at("picture"), asked.at("tokens"), path, &decoder));
      std::cout << logits << std::endl;
    } else {
      LlamaDecoder decoder(model);
      LW_RETURN_IF_ERROR(
          decoder.Append(asked.at("tokens").get<std::vector<TokenId>>(), Progress()));
      std::cout << (asked.contains("count") ? Following(&decoder, asked.at("count"))
                                            : Json(decoder.logits()))
                << std::endl;
    }
  }
  return Status();
}

}  // namespace
}  // namespace latticeworld

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const latticeworld::Status status = latticeworld::Run(argv[1]);
  if (status.ok()) return 0;
  std::cerr << status.message() << "\n";
  return 1;
}
