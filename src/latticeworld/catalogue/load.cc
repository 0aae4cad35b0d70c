// Catalogue::Load: the files of a user.

#include <utility>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/catalogue/limits.h"
#include "latticeworld/common/data_files.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

// One failure as it is; several with the first one's code and a violation for each.
Status AllOf(const std::vector<Status>& failures) {
  if (failures.size() == 1) return failures.front();
  std::vector<Violation> violations;
  for (const Status& failure : failures) {
    violations.push_back({"unreadable", "", failure.message(), ""});
  }
  LimitViolations(&violations);
  const Status all = Status::FromViolations("unreadable catalogue files", violations);
  return Status(failures.front().code(), all.message(), std::move(violations));
}

}  // namespace

Result<std::shared_ptr<const Catalogue>> Catalogue::Load(const std::vector<fs::path>& paths) {
  std::vector<CatalogueFile> files;
  std::vector<Status> failures;
  std::size_t bytes = 0;
  for (const fs::path& path : paths) {
    const Result<std::vector<fs::path>> found = JsonFilesAt(path, kMaxCatalogueFiles);
    if (!found.ok()) {
      failures.push_back(found.status());
      continue;
    }
    for (const fs::path& file : *found) {
      Result<std::string> read = ReadFile(file, kMaxCatalogueFileBytes);
      if (!read.ok()) {
        failures.push_back(read.status());
        continue;
      }
      std::string text = *std::move(read);
      bytes += text.size();
      if (bytes > kMaxCatalogueBytes) {
        return ResourceExhausted("catalogue files of more than " +
                                 std::to_string(kMaxCatalogueBytes) + " bytes in all");
      }
      files.push_back({file.filename().string(), std::move(text)});
    }
  }
  // Files may refer to one another: without those that are missing the others say nothing sure.
  if (!failures.empty()) return AllOf(failures);
  return Extended(std::move(files));
}

}  // namespace latticeworld
