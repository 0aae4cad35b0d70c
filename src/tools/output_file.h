#ifndef LATTICEWORLD_TOOLS_OUTPUT_FILE_H_
#define LATTICEWORLD_TOOLS_OUTPUT_FILE_H_

#include <filesystem>
#include <string>

#include "latticeworld/common/status.h"

namespace latticeworld::tools {

// Writes a file that a command was asked for. What was there before stays until the new one is
// whole. Errors are those of WriteFile and RenameFile.
Status ReplaceFile(const std::filesystem::path& path, const std::string& content);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_OUTPUT_FILE_H_
