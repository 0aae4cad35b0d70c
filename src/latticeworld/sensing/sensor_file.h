#ifndef LATTICEWORLD_SENSING_SENSOR_FILE_H_
#define LATTICEWORLD_SENSING_SENSOR_FILE_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/schema_check.h"
#include "latticeworld/sensing/sensor_suite.h"

namespace latticeworld {

struct LidarEntry {
  LidarModel model;
  std::string pointer;  // "user.json#/lidars/0"
};

// A sensor whose lidar is named, not yet looked up.
struct SensorEntry {
  SensorSpec spec;
  std::string lidar;           // empty: it is none
  std::optional<int> columns;  // instead of the lidar's
  std::string pointer;
};

struct SuiteEntry {
  std::string name;
  std::string extends;  // empty: nothing
  std::vector<SensorEntry> sensors;
  std::string pointer;
};

struct SensorFile {
  std::vector<LidarEntry> lidars;
  std::vector<SuiteEntry> suites;
};

// Reads one file and adds all its violations: JSON, schema, and what a schema cannot say about one
// entry, where that entry keeps to the schema. What is wrong gives no entry. file_name: what the
// pointers begin with.
SensorFile ReadSensorFile(const std::string& file_name, const std::string& text,
                          const SchemaChecker& checker, std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SENSOR_FILE_H_
