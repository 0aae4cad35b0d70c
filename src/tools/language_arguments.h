#ifndef LATTICEWORLD_TOOLS_LANGUAGE_ARGUMENTS_H_
#define LATTICEWORLD_TOOLS_LANGUAGE_ARGUMENTS_H_

#include "latticeworld/common/result.h"
#include "latticeworld/generation/language_backends.h"

namespace CLI {
class App;
}

namespace latticeworld::tools {

// The options by which a command is told who reads the words: --generator, --remote-... and
// --local-...
void AddLanguageOptions(CLI::App* command);

// Errors: INVALID_ARGUMENT naming every unusable option.
Result<LanguageBackends> MakeLanguageBackends(const CLI::App& command);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_LANGUAGE_ARGUMENTS_H_
