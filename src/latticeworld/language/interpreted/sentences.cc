#include "latticeworld/language/interpreted/sentences.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/language/remote/json_objects.h"
#include "latticeworld/language/remote/thinking_filter.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostSentences = 64;

Status NoSentences(std::string_view answer) {
  return Status::FromViolations(
      "no sentences", {{"no_sentences", "",
                        "there is no JSON object {\"sentences\": [\"...\"]} of strings in the "
                        "answer " +
                            Quote(answer),
                        Quote(answer)}});
}

// The strings of an object, or false where it has none.
bool ReadObject(std::string_view object, std::vector<std::string>* sentences) {
  // Not ordered_json, which copies members, by recursion, as an object grows.
  const auto json = nlohmann::json::parse(object, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || !json.contains("sentences") || !json["sentences"].is_array())
    return false;
  sentences->clear();
  for (const nlohmann::json& sentence : json["sentences"]) {
    if (!sentence.is_string()) return false;
    std::string text(Trimmed(sentence.get_ref<const std::string&>()));
    if (text.empty()) continue;
    while (!text.empty() && (text.back() == '.' || text.back() == '!')) text.pop_back();
    if (text.empty()) continue;
    sentences->push_back(std::move(text));
  }
  return true;
}

}  // namespace

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

AnswerForm SentencesForm(std::string name) {
  const Json list = {
      {"type", "array"}, {"items", {{"type", "string"}}}, {"maxItems", kMostSentences}};
  const Json schema = {{"type", "object"},
                       {"properties", {{"sentences", list}}},
                       {"required", {"sentences"}},
                       {"additionalProperties", false}};
  AnswerForm form;
  form.name = std::move(name);
  form.json_schema = schema.dump();
  return form;
}

Result<std::vector<std::string>> ReadSentences(std::string_view answer) {
  const std::string text = WithoutThinking(answer);
  const std::vector<std::string_view> objects = ObjectsIn(text);
  std::vector<std::string> sentences;
  bool found = false;
  for (auto object = objects.rbegin(); object != objects.rend() && !found; ++object)
    found = ReadObject(*object, &sentences);
  if (!found) return NoSentences(text);
  std::size_t bytes = 0;
  for (const std::string& sentence : sentences) bytes += sentence.size() + 1;
  if (sentences.size() > kMostSentences || bytes > kMaxInstructionBytes) {
    return Status::FromViolations(
        "too many sentences",
        {{"too_long", "/sentences",
          std::to_string(sentences.size()) + " sentences of " + std::to_string(bytes) +
              " bytes; at most " + std::to_string(kMostSentences) + " of " +
              std::to_string(kMaxInstructionBytes) + " bytes together are legal",
          std::to_string(sentences.size())}});
  }
  return sentences;
}

}  // namespace latticeworld
