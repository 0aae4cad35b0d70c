#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/common/work_crew.h"
#include "latticeworld/language/local/decoding/height_eyes.h"
#include "latticeworld/language/local/decoding/llama_model.h"
#include "latticeworld/language/local/heard_text.h"
#include "latticeworld/language/local/local.h"
#include "latticeworld/language/local/tokens/chat_text.h"
#include "latticeworld/language/local/tokens/grammar.h"
#include "latticeworld/language/local/tokens/schema_grammar.h"
#include "latticeworld/language/local/tokens/token_choice.h"
#include "latticeworld/language/local/tokens/token_mask.h"
#include "latticeworld/language/local/tokens/tokenizer.h"
#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Says after which words of an answer something was: " after '...'".
std::string After(const std::string& text) {
  return " after '" + text.substr(text.size() - std::min<std::size_t>(text.size(), 40)) + "'";
}

class LocalServer : public ChatServer {
 public:
  LocalServer(std::string name, ChatStyle style, Tokenizer tokenizer,
              std::shared_ptr<const LlamaModel> model, std::optional<HeightEyes> eyes,
              float guidance, int threads)
      : name_(std::move(name)),
        style_(style),
        tokenizer_(std::move(tokenizer)),
        tree_(tokenizer_),
        model_(std::move(model)),
        eyes_(std::move(eyes)),
        guidance_(guidance),
        crew_(std::make_shared<WorkCrew>(threads)),
        asked_(model_, crew_) {
    if (guidance_ != 1.0f) unasked_.emplace(model_, crew_);
    for (TokenId token = 0; token < tokenizer_.size(); ++token)
      if (!tokenizer_.BytesOf(token).empty() || token == end()) any_token_.push_back(token);
  }

  bool sees() const override { return eyes_.has_value(); }

  Result<ChatReply> Complete(const ChatRequest& request, const AnswerListener& listener,
                             const Progress& progress) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    if (!(request.temperature >= 0.0 && request.temperature < 1e6))
      return InvalidArgument("the temperature is " + std::to_string(request.temperature) +
                             "; legal is what is not below 0");
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

  // What the eyes make of the pictures of the messages, one behind the other.
  Result<std::vector<float>> Seen(const std::vector<ChatMessage>& messages) const {
    std::vector<float> seen;
    for (const ChatMessage& message : messages) {
      if (message.image_png.empty()) continue;
      if (!eyes_) return InvalidArgument("the model '" + name_ + "' sees no pictures");
      LW_ASSIGN_OR_RETURN(const std::vector<float> more, eyes_->See(message.image_png));
      seen.insert(seen.end(), more.begin(), more.end());
    }
    return seen;
  }

  Status Hear(const std::vector<TokenId>& tokens, const Progress& progress) {
    LW_RETURN_IF_ERROR(asked_.Add(tokens, progress));
    return unasked_ ? unasked_->Add(tokens, progress) : Status();
  }

  // Logits of what was asked; guided ones have moved away from what the model would say to nothing
  // (classifier-free guidance: Ho and Salimans 2022; of language models: Sanchez et al. 2023).
  const std::vector<float>& Logits() {
    if (!unasked_) return asked_.logits();
    guided_ = unasked_->logits();
    for (std::size_t i = 0; i < guided_.size(); ++i)
      guided_[i] += guidance_ * (asked_.logits()[i] - guided_[i]);
    return guided_;
  }

  Result<ChatReply> Answer(const ChatRequest& request, const Grammar* grammar,
                           const AnswerListener& listener, const Progress& progress) {
    const Clock::time_point begin = Clock::now();
    // The model hears the pictures and messages; with guidance it also hears a chat without any.
    const std::vector<TokenId> prompt = ChatTokens(tokenizer_, style_, request.messages);
    if (prompt.empty()) return InvalidArgument("there are no messages to answer");
    const auto most = static_cast<std::size_t>(std::max(0, request.max_prompt_tokens));
    if (most > 0 && prompt.size() > most)
      return ResourceExhausted("the messages have " + std::to_string(prompt.size()) +
                               " tokens; the model '" + name_ + "' is given " +
                               std::to_string(most) + " at most");
    LW_ASSIGN_OR_RETURN(const std::vector<float> seen, Seen(request.messages));
    if (most > 0) asked_.Reserve(most + static_cast<std::size_t>(std::max(0, request.max_tokens)));
    LW_RETURN_IF_ERROR(asked_.Begin(seen, prompt, progress));
    if (unasked_)
      LW_RETURN_IF_ERROR(unasked_->Begin({}, ChatTokens(tokenizer_, style_, {}), progress));
    // The answer grows token by token until it ends, is cut, or fills what it may.
    ChatReply reply;
    reply.model = name_;
    reply.prompt_tokens = static_cast<int>(prompt.size());
    reply.finish_reason = "length";
    RandomStream random(request.seed, "local answer");
    std::optional<TokenMask> mask;
    if (grammar != nullptr) mask.emplace(*grammar, tokenizer_, tree_, end());
    std::vector<TokenId> unheard;  // that were taken without asking the model
    const std::size_t room =
        model_->sizes.context - seen.size() / model_->sizes.width - prompt.size();
    while (reply.completion_tokens < request.max_tokens &&
           static_cast<std::size_t>(reply.completion_tokens) < room) {
      const std::vector<TokenId>& allowed = mask ? mask->Allowed() : any_token_;
      if (allowed.empty())
        return InvalidArgument("the model '" + name_ + "' has no token that the form allows" +
                               After(reply.text));
      // The model is asked only if there is a choice. It first hears what was taken without it.
      if (allowed.size() > 1 && !unheard.empty()) {
        LW_RETURN_IF_ERROR(Hear(unheard, progress));
        unheard.clear();
      }
      const std::optional<TokenId> chosen =
          allowed.size() == 1 ? allowed.front()
                              : ChooseToken(Logits(), allowed, request.temperature, &random);
      if (!chosen)
        return DataLoss("the model '" + name_ + "' gives no number to any token" +
                        (mask ? " that the form allows" : "") + After(reply.text) +
                        ": its weights are damaged or overflow");
      const TokenId token = *chosen;
      if (mask && allowed.size() > 1 && request.temperature <= 0.0)
        reply.log_probability += LogProbability(Logits(), allowed, token);
      // The token ends the answer, or is added to it and told to the listener.
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
  const std::optional<HeightEyes> eyes_;
  const float guidance_;  // 1: none
  std::vector<TokenId> any_token_;
  std::mutex mutex_;  // guards what follows
  const std::shared_ptr<WorkCrew> crew_;
  HeardText asked_;
  std::optional<HeardText> unasked_;  // the answer as if nothing had been asked, where guided
  std::vector<float> guided_;
  std::map<std::string, Grammar> grammars_;
};

// How far answers move away from what the model says to nothing; models that were trained without a
// prompt now and then say so of themselves.
Result<float> ReadGuidance(const GgufFile& file) {
  constexpr std::string_view kKey = "latticeworld.guidance";
  if (!file.Has(kKey)) return 1.0f;
  LW_ASSIGN_OR_RETURN(const double guidance, file.Number(kKey));
  if (!(guidance >= 1.0 && guidance <= 20.0))
    return DataLoss("'" + std::string(kKey) + "' is " + std::to_string(guidance) +
                    "; legal are 1 to 20");
  return static_cast<float>(guidance);
}

// The eyes of a model that was trained with some: "layouts.eyes.gguf" beside "layouts.gguf".
Result<std::optional<HeightEyes>> ReadEyes(const std::string& model_file, const LlamaModel& model) {
  const std::string path = std::filesystem::path(model_file).replace_extension(".eyes.gguf");
  LW_ASSIGN_OR_RETURN(HeightEyes eyes, HeightEyes::Open(path));
  if (eyes.embedding() != model.sizes.width)
    return DataLoss("'" + path + "' makes embeddings of " + std::to_string(eyes.embedding()) +
                    " values, where those of '" + model_file + "' have " +
                    std::to_string(model.sizes.width));
  return std::optional<HeightEyes>(std::move(eyes));
}

}  // namespace

Result<std::shared_ptr<ChatServer>> MakeLocalChatServer(const std::string& model_file,
                                                        int threads) {
  LW_ASSIGN_OR_RETURN(const GgufFile file, GgufFile::Open(model_file));
  const auto context = [&](const Status& status) {
    return status.WithContext("'" + model_file + "'");
  };
  Result<Tokenizer> tokenizer = Tokenizer::Read(file);
  if (!tokenizer.ok()) return context(tokenizer.status());
  Result<LlamaModel> model = ReadLlamaModel(file);
  if (!model.ok()) return context(model.status());
  const Result<float> guidance = ReadGuidance(file);
  if (!guidance.ok()) return context(guidance.status());
  std::optional<HeightEyes> eyes;
  if (file.Has("latticeworld.sees")) {
    LW_ASSIGN_OR_RETURN(eyes, ReadEyes(model_file, *model));
  }
  const Result<std::string> chat_template = file.Text("tokenizer.chat_template");
  const ChatStyle style = ChatStyleOf(chat_template.ok() ? *chat_template : std::string());
  if (*guidance != 1.0f && ChatTokens(*tokenizer, style, {}).empty())
    return context(
        DataLoss("'latticeworld.guidance' asks what the model says to nothing, which "
                 "needs a token that begins texts; the tokenizer has none"));
  const Result<std::string> name = file.Text("general.name");
  return std::shared_ptr<ChatServer>(std::make_shared<LocalServer>(
      name.ok() && !name->empty() ? *name : std::filesystem::path(model_file).stem().string(),
      style, *std::move(tokenizer), std::make_shared<const LlamaModel>(*std::move(model)),
      std::move(eyes), *guidance, threads));
}

}  // namespace latticeworld
