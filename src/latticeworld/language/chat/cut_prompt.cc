#include "latticeworld/language/chat/cut_prompt.h"

#include <algorithm>
#include <cstddef>

namespace latticeworld {
namespace {

// No vocabulary comes to as many characters a token in English prose (4 to 5) or JSON (2 to 4).
constexpr std::size_t kMostCharactersPerToken = 6;
// A shorter prompt fills a context by chance.
constexpr std::size_t kFewestCharactersPerToken = 2;
constexpr int kSmallestContext = 1024;

// Counts the characters of all messages: of UTF-8, the bytes that begin one.
std::size_t Characters(const ChatRequest& request) {
  std::size_t count = 0;
  for (const ChatMessage& message : request.messages) {
    count += static_cast<std::size_t>(
        std::count_if(message.text.begin(), message.text.end(),
                      [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
  }
  return count;
}

bool IsPowerOfTwo(int number) { return (number & (number - 1)) == 0; }

// What Ollama leaves of a prompt that is too long: a whole context, or half of one and its first
// two tokens more.
bool FillsContext(int tokens) {
  return tokens >= kSmallestContext && (IsPowerOfTwo(tokens) || IsPowerOfTwo(tokens - 2));
}

}  // namespace

std::string CutPromptWarning(const ChatRequest& request, int prompt_tokens) {
  if (prompt_tokens <= 0) return "";
  const std::size_t characters = Characters(request);
  const auto tokens = static_cast<std::size_t>(prompt_tokens);
  const bool too_few = tokens * kMostCharactersPerToken < characters;
  const bool full = FillsContext(prompt_tokens) && tokens * kFewestCharactersPerToken < characters;
  if (!too_few && !full) return "";
  return "the chat server has cut the prompt: it counted " + std::to_string(prompt_tokens) +
         " tokens in " + std::to_string(characters) + " characters, " +
         (too_few ? "which cannot hold them" : "just what fits a context") +
         "; give it a longer context (Ollama: OLLAMA_CONTEXT_LENGTH or num_ctx)";
}

}  // namespace latticeworld
