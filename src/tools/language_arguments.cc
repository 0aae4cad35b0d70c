#include "tools/language_arguments.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tools/arguments.h"

namespace latticeworld::tools {
namespace {

std::vector<std::string> NamesOfDialects() {
  std::vector<std::string> names;
  for (const auto& entry : EnumNames(ChatDialect{})) names.emplace_back(entry.name);
  return names;
}

// "remote", "first_token_timeout_s" -> "--remote-first-token-timeout"
std::string OptionOf(const char* backend, std::string field) {
  if (field.size() > 2 && field.compare(field.size() - 2, 2, "_s") == 0) {
    field.resize(field.size() - 2);
  }
  std::replace(field.begin(), field.end(), '_', '-');
  return "--" + std::string(backend) + "-" + field;
}

}  // namespace

void AddLanguageOptions(CLI::App* command) {
  AddValueOption(
      command, "--generator", "NAME",
      "Who reads the words: grounded (embedded), remote (a model behind --remote-url), or "
      "local (a model in this process, --local-model) [remote where --remote-url is "
      "given, else local where --local-model is, else grounded].");
  AddValueOption(command, "--local-model", "FILE",
                 "GGUF file of LLaMA's architecture (f32, f16 or q8_0) that draws layouts.");
  AddValueOption(command, "--local-environment-model", "FILE",
                 "The same for environments, or grounded for the embedded back end "
                 "[that of --local-model].");
  AddValueOption(command, "--local-temperature", "NUMBER", "0 to 2 [0.7].");
  command->add_flag("--local-fallback",
                    "Where its answer stays illegal, grounded answers, with a warning.");
  AddValueOption(command, "--remote-url", "URL",
                 "OpenAI-compatible server, such as http://127.0.0.1:8080/v1.");
  AddValueOption(command, "--remote-model", "NAME", "Its model [the first that it lists].");
  AddValueOption(command, "--remote-dialect", "NAME",
                 "How it is told the form of an answer: llama.cpp, vllm, ollama, openai or none "
                 "[openai].");
  AddValueOption(command, "--remote-api-key-variable", "NAME",
                 "Environment variable with the key [no key].");
  AddValueOption(command, "--remote-ca-file", "FILE",
                 "PEM of certificate authorities [the system's].");
  AddValueOption(command, "--remote-connect-timeout", "SECONDS", "0.01 to 600 [5].");
  AddValueOption(command, "--remote-first-token-timeout", "SECONDS", "0.01 to 3600 [60].");
  AddValueOption(command, "--remote-total-timeout", "SECONDS",
                 "Of one answer with all retries, 0.01 to 7200 [180].");
  AddValueOption(command, "--remote-repair-turns", "N",
                 "Times that what is wrong with an answer goes back to the model, 0 to 8 [2].");
  AddValueOption(command, "--remote-temperature", "NUMBER", "0 to 2 [0.7].");
  command->add_flag("--remote-sees", "The model looks at images: it gets the relief as one.");
  command->add_flag("--remote-fallback",
                    "Where the server cannot be had, grounded answers, with a warning.");
}

Result<LanguageBackends> MakeLanguageBackends(const CLI::App& command) {
  RemoteBackendOptions remote;
  remote.server.url = ValueOf(command, "--remote-url").value_or("");
  remote.server.model = ValueOf(command, "--remote-model").value_or("");
  remote.server.api_key_variable = ValueOf(command, "--remote-api-key-variable").value_or("");
  remote.server.ca_file = ValueOf(command, "--remote-ca-file").value_or("");
  remote.server.sees = command.count("--remote-sees") > 0;
  remote.fallback = command.count("--remote-fallback") > 0;
  ArgumentReader arguments(&command);
  const std::string dialect = arguments.Choice("--remote-dialect", NamesOfDialects(), "openai");
  remote.server.dialect = *FromName<ChatDialect>(dialect);
  remote.server.connect_timeout_s =
      arguments.Number("--remote-connect-timeout", remote.server.connect_timeout_s);
  remote.server.first_token_timeout_s =
      arguments.Number("--remote-first-token-timeout", remote.server.first_token_timeout_s);
  remote.server.total_timeout_s =
      arguments.Number("--remote-total-timeout", remote.server.total_timeout_s);
  remote.model.repair_turns =
      static_cast<int>(arguments.Integer("--remote-repair-turns", 0, 8, remote.model.repair_turns));
  remote.model.temperature = arguments.Number("--remote-temperature", remote.model.temperature);
  for (const char* option :
       {"--remote-model", "--remote-dialect", "--remote-api-key-variable", "--remote-ca-file",
        "--remote-connect-timeout", "--remote-first-token-timeout", "--remote-total-timeout",
        "--remote-repair-turns", "--remote-temperature"}) {
    arguments.RequireBeside(option, "--remote-url");
  }
  LocalBackendOptions local;
  local.layout_model = ValueOf(command, "--local-model").value_or("");
  local.environment_model = ValueOf(command, "--local-environment-model").value_or("");
  local.fallback = command.count("--local-fallback") > 0;
  local.temperature = arguments.Number("--local-temperature", local.temperature);
  for (const char* option : {"--local-environment-model", "--local-temperature"})
    arguments.RequireBeside(option, "--local-model");
  LW_RETURN_IF_ERROR(arguments.status());

  std::vector<Violation> violations = Validate(remote);
  for (Violation& violation : violations) violation.pointer = OptionOf("remote", violation.pointer);
  for (Violation& violation : Validate(local)) {
    violation.pointer = OptionOf("local", violation.pointer);
    violations.push_back(std::move(violation));
  }
  LW_RETURN_IF_ERROR(Status::FromViolations("unusable arguments", std::move(violations)));
  return latticeworld::MakeLanguageBackends(remote, local);
}

}  // namespace latticeworld::tools
