#ifndef LATTICEWORLD_CAMPAIGN_REPORTS_RESULT_FILES_H_
#define LATTICEWORLD_CAMPAIGN_REPORTS_RESULT_FILES_H_

#include <filesystem>
#include <string_view>

#include "latticeworld/common/result.h"

namespace latticeworld {

// Writes a file whole or not at all: beside it under a name of this process, synced, then renamed.
// What was there before is replaced. Errors: those of WriteFile, which name a full disk.
Status WriteWhole(const std::filesystem::path& path, std::string_view content);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_REPORTS_RESULT_FILES_H_
