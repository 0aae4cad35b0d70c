#ifndef LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_CHAT_TEXT_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_CHAT_TEXT_H_

#include <cstdint>
#include <string_view>
#include <vector>

#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/local/tokens/tokenizer.h"

namespace latticeworld {

// How a conversation is laid out for a model.
enum class ChatStyle : std::uint8_t {
  kPlain,                // "user: ...\n", and "assistant: " before the answer
  kLlama2,               // [INST] <<SYS>> ... <</SYS>> ... [/INST]
  kChatMl,               // <|im_start|>user ... <|im_end|>
  kChatMlWithoutSystem,  // the same, and system messages are left out: small models
                         // that know one task are not told what it is
};

// The style that a model file's `tokenizer.chat_template` is written for: those
// that are known by their marks, else plain.
ChatStyle ChatStyleOf(std::string_view chat_template);

// The tokens of the messages, up to where the answer begins. Marks come from
// the style alone: what a message says is never read as one.
std::vector<TokenId> ChatTokens(const Tokenizer& tokenizer, ChatStyle style,
                                const std::vector<ChatMessage>& messages);
// The token that ends an answer.
TokenId AnswerEnd(const Tokenizer& tokenizer, ChatStyle style);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_CHAT_TEXT_H_
