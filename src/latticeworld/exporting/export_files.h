#ifndef LATTICEWORLD_EXPORTING_EXPORT_FILES_H_
#define LATTICEWORLD_EXPORTING_EXPORT_FILES_H_

#include <string>

namespace latticeworld {

// A file of an export that is a folder.
struct ExportFile {
  std::string name;  // relative, '/' between folders
  std::string content;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_EXPORT_FILES_H_
