#ifndef LATTICEWORLD_VIEWER_SERVER_PAGE_FILES_H_
#define LATTICEWORLD_VIEWER_SERVER_PAGE_FILES_H_

#include <filesystem>

#include "latticeworld/common/result.h"
#include "latticeworld/viewer/payloads/payload.h"

namespace latticeworld {

// The page in memory: every regular file of the directory and its subdirectories, by path
// ("/index.html", which is also "/"). As nothing else is ever served, no path that a client sends
// reaches the disk. Links and hidden files are left out. Errors: NOT_FOUND (no such directory, no
// index.html in it), RESOURCE_EXHAUSTED (more than 2000 files or 64 MiB).
Result<PayloadMap> ReadPage(const std::filesystem::path& directory);

// Finds the page of this program: share/latticeworld/web beside the program's own place, as builds
// and installations have it. Errors: NOT_FOUND naming where it was looked for, and how the page is
// built.
Result<std::filesystem::path> FindPage();

// What is served at "/" where there is no page: says how to get one. reason: plain text.
PayloadMap PageMissing(const std::string& reason);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_PAGE_FILES_H_
