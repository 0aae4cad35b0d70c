#include <algorithm>
#include <filesystem>
#include <system_error>

#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/language/chat/openai_client.h"
#include "latticeworld/language/chat/server_url.h"

namespace latticeworld {
namespace {

// Returns whether it is a name in capitals, as is the custom: a key that is put there by mistake is
// no such name.
bool IsVariableName(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; };
  return is_letter(name.front()) && std::all_of(name.begin(), name.end(), [&](char c) {
           return is_letter(c) || (c >= '0' && c <= '9');
         });
}

}  // namespace

std::vector<Violation> Validate(const OpenAiOptions& options) {
  constexpr std::size_t kMaxModelBytes = 256;
  constexpr std::size_t kLeastAnswerBytes = 1024;
  constexpr std::size_t kMostAnswerBytes = 64u << 20;
  std::vector<Violation> violations;
  if (const auto url = ParseServerUrl(options.url); !url.ok()) {
    // The address is not repeated: it may hold a password.
    violations.push_back({"bad_url", "url", url.status().message(), ""});
  }
  if (const Status status = ValidateText("model", options.model, kMaxModelBytes); !status.ok()) {
    violations.push_back({"bad_model", "model", status.message(), Quote(options.model)});
  }
  if (NameOf(options.dialect) == "?") {
    violations.push_back({"bad_dialect", "dialect", "must be one of " + LegalNames<ChatDialect>(),
                          std::to_string(static_cast<int>(options.dialect))});
  }
  // What is given may be the key itself, by mistake: it is not repeated.
  if (!options.api_key_variable.empty() && !IsVariableName(options.api_key_variable)) {
    violations.push_back({"bad_variable", "api_key_variable",
                          "must be the name of an environment variable (A-Z, 0-9 and _), "
                          "not the key itself",
                          ""});
  }
  std::error_code error;
  if (!options.ca_file.empty() && !std::filesystem::is_regular_file(options.ca_file, error)) {
    violations.push_back(
        {"no_ca_file", "ca_file", "must be a file of certificates (PEM)", Quote(options.ca_file)});
  }
  CheckRange("connect_timeout_s", options.connect_timeout_s, {0.01, 600}, " s", &violations);
  CheckRange("first_token_timeout_s", options.first_token_timeout_s, {0.01, 3600}, " s",
             &violations);
  CheckRange("total_timeout_s", options.total_timeout_s, {0.01, 7200}, " s", &violations);
  CheckRange("max_retries", options.max_retries, {0, 20}, "", &violations);
  CheckRange("backoff_s", options.backoff_s, {0, 60}, " s", &violations);
  CheckRange("max_answer_bytes", static_cast<double>(options.max_answer_bytes),
             {static_cast<double>(kLeastAnswerBytes), static_cast<double>(kMostAnswerBytes)},
             " bytes", &violations);
  return violations;
}

}  // namespace latticeworld
