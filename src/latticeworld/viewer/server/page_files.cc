#include "latticeworld/viewer/server/page_files.h"

#include <cstddef>
#include <string>
#include <system_error>
#include <utility>

#include "latticeworld/common/files.h"
#include "latticeworld/common/markup.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 2000;
constexpr std::size_t kMostBytes = 64u << 20;
constexpr char kIndex[] = "/index.html";

}  // namespace

Result<PayloadMap> ReadPage(const fs::path& directory) {
  std::error_code error;
  if (!fs::is_directory(directory, error)) {
    return NotFound("there is no directory " + directory.string());
  }
  PayloadMap page;
  std::size_t bytes = 0;
  fs::recursive_directory_iterator files(directory, error);
  for (; !error && files != fs::recursive_directory_iterator(); files.increment(error)) {
    const fs::path& path = files->path();
    if (path.filename().string().front() == '.') {
      files.disable_recursion_pending();
      continue;
    }
    if (!fs::is_regular_file(files->symlink_status(error))) continue;
    if (page.size() >= kMostFiles) {
      return ResourceExhausted(directory.string() + " has more than " + std::to_string(kMostFiles) +
                               " files");
    }
    LW_ASSIGN_OR_RETURN(std::string content, ReadFile(path, kMostBytes - bytes));
    bytes += content.size();
    const std::string name = "/" + path.lexically_relative(directory).generic_string();
    const std::string type(ContentTypeOf(name));
    page.emplace(name, MakePayload(type, std::move(content), IsCompressible(type)));
  }
  if (error) return Internal("cannot read " + directory.string() + ": " + error.message());
  const auto index = page.find(kIndex);
  if (index == page.end()) return NotFound("there is no index.html in " + directory.string());
  page.emplace("/", Payload(index->second));
  return page;
}

Result<fs::path> FindPage() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  std::string looked_for;
  fs::path place = program.parent_path();
  // bin/ and lib/<package>/ stand one and two below the prefix.
  for (int up = 0; up < 2 && place.has_parent_path(); ++up) {
    place = place.parent_path();
    const fs::path page = place / "share" / "latticeworld" / "web";
    if (fs::is_regular_file(page / "index.html", error)) return page;
    looked_for += (looked_for.empty() ? "" : ", ") + page.string();
  }
  return NotFound("the page is in none of " + looked_for +
                  "; it is built where Node.js and npm are: install them "
                  "(scripts/install_dependencies.sh), configure and build again");
}

PayloadMap PageMissing(const std::string& reason) {
  const std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<title>LatticeWorld</title></head>\n<body><h1>The page is not here</h1>\n<p>" +
      EscapeMarkup(reason) +
      "</p>\n<p>The data are served all the same: docs/viewer.md.</p>"
      "</body></html>\n";
  PayloadMap page;
  page.emplace(kIndex, MakePayload(std::string(ContentTypeOf(kIndex)), html, false));
  page.emplace("/", Payload(page.begin()->second));
  return page;
}

}  // namespace latticeworld
