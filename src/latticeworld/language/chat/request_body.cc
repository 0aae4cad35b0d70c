#include "latticeworld/language/chat/request_body.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "latticeworld/common/base64.h"
#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// Keeps the order of members: grammars made from a schema demand the members in its order.
using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxTextBytes = 4u << 20;

std::string_view RoleName(ChatRole role) {
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

Json MessageJson(const ChatMessage& message, bool sees) {
  Json content = message.text;
  if (sees && !message.image_png.empty()) {
    const std::string url = "data:image/png;base64," + Base64(message.image_png);
    content = Json::array();
    content.push_back({{"type", "text"}, {"text", message.text}});
    content.push_back({{"type", "image_url"}, {"image_url", {{"url", url}}}});
  }
  return {{"role", RoleName(message.role)}, {"content", std::move(content)}};
}

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

std::vector<Violation> Validate(const ChatRequest& request) {
  std::vector<Violation> violations;
  if (request.messages.empty()) {
    violations.push_back({"no_messages", "messages", "must have at least one", "0"});
  }
  const auto check_text = [&](const std::string& where, std::string_view text) {
    if (const Status status = ValidateText(where, text, kMaxTextBytes); !status.ok()) {
      violations.push_back({"not_text", where, status.message(), Quote(text)});
    }
  };
  for (std::size_t i = 0; i < request.messages.size(); ++i) {
    check_text("message " + std::to_string(i), request.messages[i].text);
  }
  constexpr std::size_t kMaxNameBytes = 64;
  const std::string& name = request.form.name;
  if (name.size() > kMaxNameBytes || !std::all_of(name.begin(), name.end(), IsNameCharacter)) {
    violations.push_back(
        {"not_a_name", "form.name", "must be of at most 64 letters, digits, _ and -", Quote(name)});
  }
  check_text("form.gbnf", request.form.gbnf);
  check_text("form.regex", request.form.regex);
  CheckRange("max_tokens", request.max_tokens, {1, 1e9}, "", &violations);
  CheckRange("temperature", request.temperature, {0, 2}, "", &violations);
  if (!request.form.json_schema.empty() &&
      !Json::parse(request.form.json_schema, nullptr, /*allow_exceptions=*/false).is_object()) {
    violations.push_back({"not_a_schema", "form.json_schema", "must be one JSON object",
                          Quote(request.form.json_schema)});
  }
  return violations;
}

void AddForm(const AnswerForm& form, ChatDialect dialect, Json* body) {
  const bool is_llama_cpp = dialect == ChatDialect::kLlamaCpp;
  switch (FormLanguageOf(form, dialect)) {
    case FormLanguage::kNone:
      break;
    case FormLanguage::kGbnf:
      if (is_llama_cpp) {
        (*body)["grammar"] = form.gbnf;
      } else {
        (*body)["structured_outputs"] = {{"grammar", form.gbnf}};
      }
      break;
    case FormLanguage::kRegex:
      (*body)["structured_outputs"] = {{"regex", form.regex}};
      break;
    case FormLanguage::kJsonSchema: {
      Json schema = Json::parse(form.json_schema);
      if (is_llama_cpp) {
        (*body)["json_schema"] = std::move(schema);
        break;
      }
      Json named = {{"name", form.name.empty() ? "answer" : form.name},
                    {"schema", std::move(schema)}};
      if (dialect == ChatDialect::kOpenAi) named["strict"] = true;
      (*body)["response_format"] = {{"type", "json_schema"}, {"json_schema", std::move(named)}};
    }
  }
}

}  // namespace

FormLanguage FormLanguageOf(const AnswerForm& form, ChatDialect dialect) {
  const FormLanguage schema =
      form.json_schema.empty() ? FormLanguage::kNone : FormLanguage::kJsonSchema;
  switch (dialect) {
    case ChatDialect::kLlamaCpp:
      return form.gbnf.empty() ? schema : FormLanguage::kGbnf;
    case ChatDialect::kVllm:
      if (schema != FormLanguage::kNone) return schema;
      if (!form.regex.empty()) return FormLanguage::kRegex;
      return form.gbnf.empty() ? FormLanguage::kNone : FormLanguage::kGbnf;
    case ChatDialect::kOllama:
    case ChatDialect::kOpenAi:
      return schema;
    case ChatDialect::kNone:
      break;
  }
  return FormLanguage::kNone;
}

Result<std::string> CompletionBody(const ChatRequest& request, std::string_view model,
                                   const OpenAiOptions& options, const AcceptedMembers& accepted) {
  LW_RETURN_IF_ERROR(Status::FromViolations("chat request", Validate(request)));
  Json body;
  body["model"] = model;
  body["messages"] = Json::array();
  for (const ChatMessage& message : request.messages) {
    body["messages"].push_back(MessageJson(message, options.sees));
  }
  body[accepted.max_tokens ? "max_tokens" : "max_completion_tokens"] = request.max_tokens;
  if (accepted.temperature) body["temperature"] = request.temperature;
  if (accepted.seed) body["seed"] = (request.seed ^ request.seed >> 32) & 0x7FFFFFFFu;
  body["stream"] = true;
  if (accepted.stream_options) body["stream_options"] = {{"include_usage", true}};
  AddForm(request.form, options.dialect, &body);
  return body.dump();
}

bool NoteRefusal(const ErrorBody& refusal, AcceptedMembers* accepted) {
  const auto says = [&](std::string_view text) {
    return refusal.message.find(text) != std::string::npos;
  };
  if (accepted->max_tokens && says("max_completion_tokens")) {
    accepted->max_tokens = false;
    return true;
  }
  // "Unsupported value: 'temperature' does not support 0.7 with this model"; "Extra inputs are not
  // permitted" of servers that know no more than their own members.
  const bool unsupported = refusal.code == "unsupported_parameter" ||
                           refusal.code == "unsupported_value" || refusal.type == "extra_forbidden";
  const std::pair<std::string_view, bool AcceptedMembers::*> members[] = {
      {"temperature", &AcceptedMembers::temperature},
      {"seed", &AcceptedMembers::seed},
      {"stream_options", &AcceptedMembers::stream_options}};
  for (const auto& [name, member] : members) {
    if (unsupported && refusal.param == name && accepted->*member) {
      accepted->*member = false;
      return true;
    }
  }
  return false;
}

}  // namespace latticeworld
