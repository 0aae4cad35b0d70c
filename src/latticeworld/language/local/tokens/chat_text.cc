#include "latticeworld/language/local/tokens/chat_text.h"

#include <cstddef>
#include <optional>
#include <string>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::string_view kTurnBegin = "<|im_start|>", kTurnEnd = "<|im_end|>";

bool IsChatMl(ChatStyle style) {
  return style == ChatStyle::kChatMl || style == ChatStyle::kChatMlWithoutSystem;
}

std::string_view NameOf(ChatRole role) {
  switch (role) {
    case ChatRole::kSystem:
      return "system";
    case ChatRole::kUser:
      return "user";
    case ChatRole::kAssistant:
      return "assistant";
  }
  return "user";
}

// Whether a template writes no system message: it skips each message whose role is 'system'. One
// that asks this of the first message alone, `messages[0]['role'] != 'system'`, writes them all,
// and one of its own where none comes first (SmolLM2, Qwen2.5); and one that asks `== 'system'` as
// well writes them elsewhere.
bool LeavesSystemOut(std::string_view chat_template) {
  if (chat_template.find("== 'system'") != std::string_view::npos) return false;
  constexpr std::string_view kIsNone = " != 'system'";
  for (std::size_t at = chat_template.find(kIsNone); at != std::string_view::npos;
       at = chat_template.find(kIsNone, at + 1)) {
    const std::string_view whose = chat_template.substr(0, at);
    if (!EndsWith(whose, "messages[0]['role']") && !EndsWith(whose, "messages[0].role"))
      return true;
  }
  return false;
}

class Writer {
 public:
  explicit Writer(const Tokenizer& tokenizer) : tokenizer_(tokenizer) {
    if (tokenizer.begin()) tokens_.push_back(*tokenizer.begin());
  }
  void Text(const std::string& text) {
    // The space that a model's texts begin with.
    const bool first = !begun_ && tokenizer_.adds_space();
    begun_ = true;
    const std::vector<TokenId> tokens = tokenizer_.Encode(first ? " " + text : text);
    tokens_.insert(tokens_.end(), tokens.begin(), tokens.end());
  }
  // The control token of that name; its letters where the model has none.
  void Mark(std::string_view name) {
    if (const std::optional<TokenId> token = tokenizer_.Control(name)) {
      tokens_.push_back(*token);
    } else {
      Text(std::string(name));
    }
  }
  void Control(std::optional<TokenId> token) {
    if (token) tokens_.push_back(*token);
  }
  std::vector<TokenId> Take() { return std::move(tokens_); }

 private:
  const Tokenizer& tokenizer_;
  std::vector<TokenId> tokens_;
  bool begun_ = false;
};

void WriteLlama2(const Tokenizer& tokenizer, const std::vector<ChatMessage>& messages,
                 Writer* writer) {
  std::string system;
  bool first = true;
  for (const ChatMessage& message : messages) {
    if (message.role == ChatRole::kSystem) {
      system += "<<SYS>>\n" + message.text + "\n<</SYS>>\n\n";
    } else if (message.role == ChatRole::kUser) {
      if (!first) writer->Control(tokenizer.begin());
      writer->Text("[INST] " + system + message.text + " [/INST]");
      system.clear();
      first = false;
    } else {
      writer->Text(" " + message.text + " ");
      writer->Control(tokenizer.end());
    }
  }
}

}  // namespace

ChatStyle ChatStyleOf(std::string_view chat_template) {
  const auto says = [&](std::string_view mark) {
    return chat_template.find(mark) != std::string_view::npos;
  };
  if (says(kTurnBegin)) {
    return LeavesSystemOut(chat_template) ? ChatStyle::kChatMlWithoutSystem : ChatStyle::kChatMl;
  }
  if (says("[INST]")) return ChatStyle::kLlama2;
  return ChatStyle::kPlain;
}

std::vector<TokenId> ChatTokens(const Tokenizer& tokenizer, ChatStyle style,
                                const std::vector<ChatMessage>& messages) {
  Writer writer(tokenizer);
  if (style == ChatStyle::kLlama2) {
    WriteLlama2(tokenizer, messages, &writer);
    return writer.Take();
  }
  const bool chat_ml = IsChatMl(style);
  for (const ChatMessage& message : messages) {
    if (style == ChatStyle::kChatMlWithoutSystem && message.role == ChatRole::kSystem) continue;
    const std::string name(NameOf(message.role));
    if (chat_ml) {
      writer.Mark(kTurnBegin);
      writer.Text(name + "\n" + message.text);
      writer.Mark(kTurnEnd);
      writer.Text("\n");
    } else {
      writer.Text(name + ": " + message.text + "\n");
    }
  }
  if (chat_ml) {
    writer.Mark(kTurnBegin);
    writer.Text("assistant\n");
  } else {
    writer.Text("assistant: ");
  }
  return writer.Take();
}

TokenId AnswerEnd(const Tokenizer& tokenizer, ChatStyle style) {
  if (!IsChatMl(style)) return tokenizer.end();
  return tokenizer.Control(kTurnEnd).value_or(tokenizer.end());
}

}  // namespace latticeworld
