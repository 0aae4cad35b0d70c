#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/language/local/chat_text.h"
#include "latticeworld/language/local/gguf_file.h"
#include "latticeworld/language/local/grammar.h"
#include "latticeworld/language/local/llama_decoder.h"
#include "latticeworld/language/local/llama_model.h"
#include "latticeworld/language/local/local.h"
#include "latticeworld/language/local/schema_grammar.h"
#include "latticeworld/language/local/token_choice.h"
#include "latticeworld/language/local/token_mask.h"
#include "latticeworld/language/local/tokenizer.h"

namespace latticeworld {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

class LocalServer : public ChatServer {
 public:
  LocalServer(std::string name, ChatStyle style, Tokenizer tokenizer,
              std::shared_ptr<const LlamaModel> model)
      : name_(std::move(name)),
        style_(style),
        tokenizer_(std::move(tokenizer)),
        tree_(tokenizer_),
        model_(std::move(model)),
        decoder_(model_) {
    for (TokenId token = 0; token < tokenizer_.size(); ++token)
      if (!tokenizer_.BytesOf(token).empty() || token == end()) any_token_.push_back(token);
  }

  bool sees() const override { return false; }

  Result<ChatReply> Complete(const ChatRequest& request, const AnswerListener& listener,
                             const Progress& progress) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    if (!(request.temperature >= 0.0 && request.temperature < 1e6))
      return InvalidArgument("the temperature is " + std::to_string(request.temperature) +
                             "; legal is what is not below 0");
    for (const ChatMessage& message : request.messages)
      if (!message.image_png.empty())
        return InvalidArgument("the model '" + name_ + "' sees no pictures");
    LW_ASSIGN_OR_RETURN(const Grammar* grammar, GrammarOf(request.form));
    return Answer(request, grammar, listener, progress);
  }

 private:
  TokenId end() const { return AnswerEnd(tokenizer_, style_); }

  // Null: any text will do.
  Result<const Grammar*> GrammarOf(const AnswerForm& form) {
    if (form.gbnf.empty() && form.json_schema.empty()) return nullptr;
    const std::string& key = form.gbnf.empty() ? form.json_schema : form.gbnf;
    if (const auto known = grammars_.find(key); known != grammars_.end()) return &known->second;
    std::string gbnf = form.gbnf;
    if (gbnf.empty()) {
      LW_ASSIGN_OR_RETURN(gbnf, SchemaGrammar(form.json_schema));
    }
    LW_ASSIGN_OR_RETURN(Grammar grammar, Grammar::FromGbnf(gbnf));
    // Forms are few; somebody who makes up new ones is not to fill the memory.
    constexpr std::size_t kMostKept = 16;
    if (grammars_.size() >= kMostKept) grammars_.clear();
    return &grammars_.emplace(key, std::move(grammar)).first->second;
  }

  // Makes the decoder stand behind the prompt, of which it keeps what it has
  // read before.
  Status ReadPrompt(const std::vector<TokenId>& prompt, const Progress& progress) {
    std::size_t same = 0;
    while (same < prompt.size() && same < heard_.size() && prompt[same] == heard_[same]) ++same;
    if (same == prompt.size() && same > 0) --same;  // its last token gives the logits
    decoder_.Truncate(same);
    heard_.resize(same);
    return Hear({prompt.begin() + static_cast<std::ptrdiff_t>(same), prompt.end()}, progress);
  }
  Status Hear(const std::vector<TokenId>& tokens, const Progress& progress) {
    const Status status = decoder_.Append(tokens, progress);
    const std::size_t heard = decoder_.length() - heard_.size();  // all but where it was cancelled
    heard_.insert(heard_.end(), tokens.begin(),
                  tokens.begin() + static_cast<std::ptrdiff_t>(heard));
    return status;
  }

  Result<ChatReply> Answer(const ChatRequest& request, const Grammar* grammar,
                           const AnswerListener& listener, const Progress& progress) {
    const Clock::time_point begin = Clock::now();
    const std::vector<TokenId> prompt = ChatTokens(tokenizer_, style_, request.messages);
    if (prompt.empty()) return InvalidArgument("there are no messages to answer");
    LW_RETURN_IF_ERROR(ReadPrompt(prompt, progress));
    ChatReply reply;
    reply.model = name_;
    reply.prompt_tokens = static_cast<int>(prompt.size());
    reply.finish_reason = "length";
    RandomStream random(request.seed, "local answer");
    std::optional<TokenMask> mask;
    if (grammar != nullptr) mask.emplace(*grammar, tokenizer_, tree_, end());
    std::vector<TokenId> unheard;  // that were taken without asking the model
    const std::size_t room = model_->sizes.context - prompt.size();
    while (reply.completion_tokens < request.max_tokens &&
           static_cast<std::size_t>(reply.completion_tokens) < room) {
      const std::vector<TokenId>& allowed = mask ? mask->Allowed() : any_token_;
      if (allowed.empty())
        return InvalidArgument(
            "the model '" + name_ + "' has no token that the form allows after '" +
            reply.text.substr(reply.text.size() - std::min<std::size_t>(reply.text.size(), 40)) +
            "'");
      if (allowed.size() > 1 && !unheard.empty()) {
        LW_RETURN_IF_ERROR(Hear(unheard, progress));
        unheard.clear();
      }
      const TokenId token = allowed.size() == 1 ? allowed.front()
                                                : ChooseToken(decoder_.logits(), allowed,
                                                              request.temperature, &random);
      if (token == end()) {
        reply.finish_reason = "stop";
        break;
      }
      if (mask) mask->Take(token);
      unheard.push_back(token);
      reply.text += tokenizer_.BytesOf(token);
      if (++reply.completion_tokens == 1) reply.first_token_s = SecondsSince(begin);
      if (listener && !listener(reply.text)) {
        reply.finish_reason = "cut";
        break;
      }
      LW_RETURN_IF_ERROR(progress.CheckCancelled());
    }
    reply.total_s = SecondsSince(begin);
    return reply;
  }

  const std::string name_;
  const ChatStyle style_;
  const Tokenizer tokenizer_;
  const TokenTree tree_;
  const std::shared_ptr<const LlamaModel> model_;
  std::vector<TokenId> any_token_;
  std::mutex mutex_;  // guards what follows
  LlamaDecoder decoder_;
  std::vector<TokenId> heard_;  // that decoder_ has read
  std::map<std::string, Grammar> grammars_;
};

}  // namespace

Result<std::shared_ptr<ChatServer>> MakeLocalChatServer(const std::string& model_file) {
  LW_ASSIGN_OR_RETURN(const GgufFile file, GgufFile::Open(model_file));
  const auto context = [&](const Status& status) {
    return status.WithContext("'" + model_file + "'");
  };
  Result<Tokenizer> tokenizer = Tokenizer::Read(file);
  if (!tokenizer.ok()) return context(tokenizer.status());
  Result<LlamaModel> model = ReadLlamaModel(file);
  if (!model.ok()) return context(model.status());
  const Result<std::string> chat_template = file.Text("tokenizer.chat_template");
  const ChatStyle style = ChatStyleOf(chat_template.ok() ? *chat_template : std::string());
  const Result<std::string> name = file.Text("general.name");
  return std::shared_ptr<ChatServer>(std::make_shared<LocalServer>(
      name.ok() && !name->empty() ? *name : std::filesystem::path(model_file).stem().string(),
      style, *std::move(tokenizer), std::make_shared<const LlamaModel>(*std::move(model))));
}

}  // namespace latticeworld
