#ifndef LATTICEWORLD_DATASET_SOURCES_SOURCE_FILES_H_
#define LATTICEWORLD_DATASET_SOURCES_SOURCE_FILES_H_

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

// The whole of a source's file. Errors: NOT_FOUND, PERMISSION_DENIED, INVALID_ARGUMENT (no regular
// file), RESOURCE_EXHAUSTED (more than 512 MiB); each names the file.
Result<std::string> ReadSourceFile(const std::filesystem::path& path);

// Names in a folder, in order: of files that end with `extension` ("" as extension: of folders).
// What is hidden (".name") is left out. Errors: NOT_FOUND, PERMISSION_DENIED, INVALID_ARGUMENT (no
// folder).
Result<std::vector<std::string>> NamesIn(const std::filesystem::path& folder,
                                         std::string_view extension);

// A folder's or a file's name in letters, digits, '_' and '-' alone; other characters become '_'.
std::string SafeName(std::string_view name);

// Makes names unique: later ones of the same name get "_2", "_3" and so on.
void MakeUnique(std::vector<std::string>* names);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_SOURCE_FILES_H_
