#include "tools/server_arguments.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tools/arguments.h"

namespace latticeworld::tools {

void AddServerOptions(CLI::App* command) {
  AddValueOption(command, "--remote-url", "URL",
                 "OpenAI-compatible server, such as http://127.0.0.1:8080/v1.");
  AddValueOption(command, "--remote-model", "NAME", "Its model [the first listed that answers].");
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
  AddValueOption(command, "--remote-max-retries", "N",
                 "After 429, 503 and connections that fail, 0 to 20 [3].");
  AddValueOption(command, "--remote-backoff", "SECONDS",
                 "Before the first retry, doubled each time, 0 to 60 [0.5].");
  AddValueOption(command, "--remote-max-answer-bytes", "N",
                 "Of one answer's body, 1024 to 67108864 [1048576].");
}

OpenAiOptions ReadServerOptions(const CLI::App& command, ArgumentReader* reader) {
  std::vector<std::string> dialects;
  for (const auto& entry : EnumNames(ChatDialect{})) dialects.emplace_back(entry.name);
  OpenAiOptions server;
  server.url = ValueOf(command, "--remote-url").value_or("");
  server.model = ValueOf(command, "--remote-model").value_or("");
  server.api_key_variable = ValueOf(command, "--remote-api-key-variable").value_or("");
  server.ca_file = ValueOf(command, "--remote-ca-file").value_or("");
  server.dialect = *FromName<ChatDialect>(reader->Choice("--remote-dialect", dialects, "openai"));
  server.connect_timeout_s = reader->Number("--remote-connect-timeout", server.connect_timeout_s);
  server.first_token_timeout_s =
      reader->Number("--remote-first-token-timeout", server.first_token_timeout_s);
  server.total_timeout_s = reader->Number("--remote-total-timeout", server.total_timeout_s);
  server.max_retries =
      static_cast<int>(reader->Integer("--remote-max-retries", 0, 20, server.max_retries));
  server.backoff_s = reader->Number("--remote-backoff", server.backoff_s);
  server.max_answer_bytes =
      static_cast<std::size_t>(reader->Integer("--remote-max-answer-bytes", 1024, 64 << 20,
                                               static_cast<std::int64_t>(server.max_answer_bytes)));
  for (const char* option :
       {"--remote-model", "--remote-dialect", "--remote-api-key-variable", "--remote-ca-file",
        "--remote-connect-timeout", "--remote-first-token-timeout", "--remote-total-timeout",
        "--remote-max-retries", "--remote-backoff", "--remote-max-answer-bytes"}) {
    reader->RequireBeside(option, "--remote-url");
  }
  return server;
}

std::string OptionOf(const std::string& prefix, std::string field) {
  if (field.size() > 2 && field.compare(field.size() - 2, 2, "_s") == 0) {
    field.resize(field.size() - 2);
  }
  std::replace(field.begin(), field.end(), '_', '-');
  return prefix + field;
}

}  // namespace latticeworld::tools
