#include "latticeworld/language/chat/model_list.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// Families of models that answer nothing, as they stand alone in names: "bge-m3", "tts-1".
constexpr std::string_view kOtherFamilies[] = {"bge", "e5",  "gte",     "minilm",     "paraphrase",
                                               "tts", "asr", "whisper", "moderation", "dall"};

bool BeginsOtherWord(std::string_view word) {
  return StartsWith(word, "embed") || StartsWith(word, "rerank");
}

// The letters and digits of a name between its other characters, in lower case. A folder before
// the name says nothing of the model.
std::vector<std::string> WordsOf(std::string_view name) {
  std::vector<std::string> words(1);
  for (const char c : ToLowerAscii(name.substr(name.find_last_of('/') + 1))) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      words.back() += c;
    } else {
      words.emplace_back();
    }
  }
  return words;
}

bool SeemsToAnswer(std::string_view name) {
  for (const std::string& word : WordsOf(name)) {
    if (BeginsOtherWord(word) || std::find(std::begin(kOtherFamilies), std::end(kOtherFamilies),
                                           word) != std::end(kOtherFamilies)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::string FirstModel(std::string_view list) {
  using Json = nlohmann::json;
  const Json json = Json::parse(list, nullptr, /*allow_exceptions=*/false);
  std::string first;
  for (const auto& [array, name] : {std::pair{"data", "id"}, std::pair{"models", "name"}}) {
    if (!json.is_object() || !json.contains(array) || !json[array].is_array()) continue;
    for (const Json& model : json[array]) {
      if (!model.is_object() || !model.contains(name) || !model[name].is_string()) continue;
      const auto& found = model[name].get_ref<const std::string&>();
      if (SeemsToAnswer(found)) return found;
      if (first.empty()) first = found;
    }
  }
  return first;
}

}  // namespace latticeworld
