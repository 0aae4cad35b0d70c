#ifndef LATTICEWORLD_TOOLS_SERVER_ARGUMENTS_H_
#define LATTICEWORLD_TOOLS_SERVER_ARGUMENTS_H_

#include <string>

#include "latticeworld/language/chat/openai_client.h"

namespace CLI {
class App;
}

namespace latticeworld::tools {

class ArgumentReader;

// The options by which a command is told of a model's server: --remote-url, --remote-model,
// --remote-dialect, --remote-api-key-variable, --remote-ca-file, the three --remote-...-timeout,
// --remote-max-retries, --remote-backoff and --remote-max-answer-bytes.
void AddServerOptions(CLI::App* command);

// What they say, not validated; `reader` gets a violation for each that cannot be read or stands
// without --remote-url. --remote-sees is the command's own.
OpenAiOptions ReadServerOptions(const CLI::App& command, ArgumentReader* reader);

// "--remote-", "first_token_timeout_s" -> "--remote-first-token-timeout": what the option is called
// that a field of that name comes from.
std::string OptionOf(const std::string& prefix, std::string field);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_SERVER_ARGUMENTS_H_
