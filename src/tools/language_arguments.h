#ifndef LATTICEWORLD_TOOLS_LANGUAGE_ARGUMENTS_H_
#define LATTICEWORLD_TOOLS_LANGUAGE_ARGUMENTS_H_

#include "latticeworld/common/result.h"
#include "latticeworld/generation/bundle/load_language.h"

namespace CLI {
class App;
}

namespace latticeworld::tools {

// The options by which a command is told who reads the words and who answers them: --reader,
// --generator, --reader-..., --remote-... and --local-...
void AddLanguageOptions(CLI::App* command);

// Errors: INVALID_ARGUMENT naming every unusable option.
Result<LanguageStack> LoadLanguage(const CLI::App& command);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_LANGUAGE_ARGUMENTS_H_
