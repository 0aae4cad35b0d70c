#include "latticeworld/language/chat/kept_form.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

namespace latticeworld {
namespace {

using Json = nlohmann::json;

// Longer answers are not matched: a regular expression may need stack for every letter.
constexpr std::size_t kMostMatched = 16384;

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

bool HasMembers(const Json& answer, const Json& schema) {
  for (const Json& name : schema.value("required", Json::array())) {
    if (!answer.contains(name.get_ref<const std::string&>())) return false;
  }
  if (schema.value("additionalProperties", Json()) != Json(false)) return true;
  const Json legal = schema.value("properties", Json::object());
  for (const auto& member : answer.items()) {
    if (!legal.contains(member.key())) return false;
  }
  return true;
}

KeptForm KeepsSchema(std::string_view text, bool whole, const std::string& schema_text) {
  const Json schema = Json::parse(schema_text, nullptr, /*allow_exceptions=*/false);
  if (!schema.is_object()) return KeptForm::kUnknown;
  const bool wants_object = schema.value("type", Json()) == "object";
  const Json answer = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (answer.is_discarded()) {
    const bool may_become_one = !whole && (!wants_object || text.front() == '{');
    return may_become_one ? KeptForm::kUnknown : KeptForm::kNo;
  }
  if (!wants_object) return KeptForm::kYes;
  return answer.is_object() && HasMembers(answer, schema) ? KeptForm::kYes : KeptForm::kNo;
}

KeptForm Matches(std::string_view text, bool whole, const std::string& regex) {
  if (regex.empty() || !whole || text.size() > kMostMatched) return KeptForm::kUnknown;
  try {
    return std::regex_match(text.begin(), text.end(), std::regex(regex)) ? KeptForm::kYes
                                                                         : KeptForm::kNo;
  } catch (const std::regex_error&) {  // one of another tongue
    return KeptForm::kUnknown;
  }
}

}  // namespace

KeptForm KeepsForm(std::string_view text, bool whole, const AnswerForm& form,
                   FormLanguage language) {
  text = Trimmed(text);
  if (text.empty()) return KeptForm::kUnknown;
  switch (language) {
    case FormLanguage::kNone:
      break;
    case FormLanguage::kGbnf:
    case FormLanguage::kRegex:
      return Matches(text, whole, form.regex);
    case FormLanguage::kJsonSchema:
      return KeepsSchema(text, whole, form.json_schema);
  }
  return KeptForm::kUnknown;
}

}  // namespace latticeworld
