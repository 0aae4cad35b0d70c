#include <cstddef>
#include <map>
#include <set>

#include "latticeworld/common/check.h"
#include "latticeworld/common/data_files.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/schema_check.h"
#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"
#include "latticeworld/sensing/sensor_file.h"
#include "latticeworld/sensing/sensor_rules.h"
#include "latticeworld/sensing/sensor_suite.h"

namespace latticeworld {

std::string_view SensorData(std::string_view file_name);  // embedded

namespace {

namespace fs = std::filesystem;
using NamedTexts = std::vector<std::pair<std::string, std::string>>;

constexpr const char* kBuiltInFiles[] = {"lidars.json", "suites.json"};
constexpr std::size_t kMaxFileBytes = 1 << 20;
constexpr std::size_t kMaxFiles = 256;
constexpr std::size_t kMaxEntries = 1024;       // of lidars, and of suites
constexpr std::size_t kMaxSensorsOfSuite = 64;  // with those that it extends

// Safe to stand in messages.
std::string Printable(const std::string& file_name) {
  const std::string quoted = Quote(file_name, 255);
  return quoted.substr(1, quoted.size() - 2);
}

template <typename Entries>
std::string NamesOf(const Entries& entries) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries) names.push_back(name);
  return Quote(Join(names, ", "), 600);
}

}  // namespace

// Gathers the entries of files by name, and makes suites of them.
class SensorCatalogueBuilder {
 public:
  // Entries of a name that is there take its place, but two of one call must not have the same.
  void Add(const NamedTexts& files) {
    static const SchemaChecker checker(SensorCatalogue::schema());  // immutable
    std::map<std::string, std::string> lidars_at, suites_at;        // name -> pointer
    for (const auto& [file_name, text] : files) {
      SensorFile file = ReadSensorFile(Printable(file_name), text, checker, &violations_);
      for (LidarEntry& entry : file.lidars) {
        if (!IsFirst(entry.model.name, entry.pointer, "lidar", &lidars_at)) continue;
        lidars_[entry.model.name] = std::move(entry.model);
      }
      for (SuiteEntry& entry : file.suites) {
        if (!IsFirst(entry.name, entry.pointer, "suite", &suites_at)) continue;
        suites_[entry.name] = std::move(entry);
      }
    }
    DemandCount("lidars", lidars_.size());
    DemandCount("suites", suites_.size());
  }

  // OK only where nothing is wrong.
  Result<std::shared_ptr<const SensorCatalogue>> Build() {
    std::shared_ptr<SensorCatalogue> catalogue(new SensorCatalogue);
    for (const auto& [name, lidar] : lidars_) catalogue->lidars_.push_back(lidar);
    for (const auto& [name, entry] : suites_) {
      SensorSuite suite = {name, {}};
      for (auto& [sensor, spec] : SensorsOf(entry)) suite.sensors.push_back(std::move(spec));
      if (suite.sensors.size() > kMaxSensorsOfSuite) {
        violations_.push_back({"wrong_count", entry.pointer + "/sensors",
                               "a suite may have at most " + std::to_string(kMaxSensorsOfSuite) +
                                   " sensors with those of the suites that it extends",
                               std::to_string(suite.sensors.size())});
      }
      catalogue->suites_.push_back(std::move(suite));
    }
    if (!violations_.empty()) {
      LimitViolations(&violations_);
      return Status::FromViolations("illegal sensor files", std::move(violations_));
    }
    return std::shared_ptr<const SensorCatalogue>(std::move(catalogue));
  }

 private:
  bool IsFirst(const std::string& name, const std::string& pointer, const std::string& what,
               std::map<std::string, std::string>* added_at) {
    const auto [first, fresh] = added_at->emplace(name, pointer);
    if (fresh) return true;
    violations_.push_back({"duplicate_value", pointer + "/name",
                           "a " + what + " of this name stands at " + first->second, Quote(name)});
    return false;
  }

  void DemandCount(const std::string& what, std::size_t count) {
    if (count <= kMaxEntries) return;
    violations_.push_back({"wrong_count", "",
                           "at most " + std::to_string(kMaxEntries) + " " + what + " are legal",
                           std::to_string(count)});
  }

  // Returns the suite's sensors by name, with those of what it extends; what is wrong with its own
  // is added.
  std::map<std::string, SensorSpec> SensorsOf(const SuiteEntry& entry) {
    // The chain goes from the entry back to the suite that all of them extend.
    std::vector<const SuiteEntry*> chain = {&entry};
    std::set<std::string> met = {entry.name};
    while (!chain.back()->extends.empty()) {
      const SuiteEntry& extending = *chain.back();
      const auto base = suites_.find(extending.extends);
      if (base == suites_.end() || !met.insert(extending.extends).second) {
        // Told once, of the suite where it stands.
        if (chain.size() == 1) {
          violations_.push_back({"unknown_value", entry.pointer + "/extends",
                                 base == suites_.end()
                                     ? "there is no suite " + Quote(extending.extends) +
                                           "; there are " + NamesOf(suites_)
                                     : "a suite cannot extend itself",
                                 Quote(extending.extends)});
        } else if (base != suites_.end() && base->second.name == entry.name) {
          violations_.push_back({"unknown_value", entry.pointer + "/extends",
                                 "it is extended by this suite itself", Quote(entry.extends)});
        }
        break;
      }
      chain.push_back(&base->second);
    }
    std::map<std::string, SensorSpec> sensors;
    for (auto suite = chain.rbegin(); suite != chain.rend(); ++suite) {
      for (const SensorEntry& sensor : (*suite)->sensors) {
        sensors[sensor.spec.name] = Resolved(sensor, *suite == &entry);
      }
    }
    return sensors;
  }

  // Returns the sensor with its lidar looked up; tells: whether to add what is wrong.
  SensorSpec Resolved(const SensorEntry& entry, bool tells) {
    SensorSpec spec = entry.spec;
    if (entry.lidar.empty()) return spec;
    const auto found = lidars_.find(entry.lidar);
    if (found == lidars_.end()) {
      if (tells) {
        violations_.push_back(
            {"unknown_value", entry.pointer + "/lidar/model",
             "there is no lidar " + Quote(entry.lidar) + "; there are " + NamesOf(lidars_),
             Quote(entry.lidar)});
      }
      return spec;
    }
    LidarModel model = found->second;
    if (entry.columns) model.columns = *entry.columns;
    spec.model = std::move(model);
    if (tells) CheckLidarSensor(spec, entry.pointer, &violations_);
    return spec;
  }

  std::map<std::string, LidarModel> lidars_;
  std::map<std::string, SuiteEntry> suites_;
  std::vector<Violation> violations_;
};

std::shared_ptr<const SensorCatalogue> SensorCatalogue::BuiltIn() {
  static const std::shared_ptr<const SensorCatalogue> built_in =  // immutable
      Extended({}).value();
  return built_in;
}

Result<std::shared_ptr<const SensorCatalogue>> SensorCatalogue::Load(
    const std::vector<fs::path>& paths) {
  NamedTexts files;
  for (const fs::path& path : paths) {
    LW_ASSIGN_OR_RETURN(const std::vector<fs::path> found, JsonFilesAt(path, kMaxFiles));
    for (const fs::path& file : found) {
      LW_ASSIGN_OR_RETURN(std::string text, ReadFile(file, kMaxFileBytes));
      files.emplace_back(file.filename().string(), std::move(text));
    }
  }
  return Extended(files);
}

Result<std::shared_ptr<const SensorCatalogue>> SensorCatalogue::Extended(const NamedTexts& files) {
  static const SensorCatalogueBuilder built_in = [] {  // immutable
    NamedTexts texts;
    for (const char* name : kBuiltInFiles) texts.emplace_back(name, std::string(SensorData(name)));
    SensorCatalogueBuilder builder;
    builder.Add(texts);
    return builder;
  }();
  SensorCatalogueBuilder builder = built_in;
  builder.Add(files);
  return builder.Build();
}

std::string_view SensorCatalogue::schema() { return SensorData("schema.json"); }

const SensorSuite* SensorCatalogue::FindSuite(std::string_view name) const {
  const auto found = std::find_if(suites_.begin(), suites_.end(),
                                  [&](const SensorSuite& suite) { return suite.name == name; });
  return found == suites_.end() ? nullptr : &*found;
}

const LidarModel* SensorCatalogue::FindLidar(std::string_view name) const {
  const auto found = std::find_if(lidars_.begin(), lidars_.end(),
                                  [&](const LidarModel& lidar) { return lidar.name == name; });
  return found == lidars_.end() ? nullptr : &*found;
}

Eigen::Isometry3d BaseFromSensor(const SensorSpec& spec, double body_height_m) {
  Eigen::Isometry3d base_from_sensor = Eigen::Isometry3d::Identity();
  base_from_sensor.translation() = spec.base_from_sensor_m;
  if (spec.on_top) base_from_sensor.translation().z() += body_height_m;
  const Eigen::Vector3d& angles_rad = spec.roll_pitch_yaw_rad;
  base_from_sensor.linear() = (Eigen::AngleAxisd(angles_rad.z(), Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(angles_rad.y(), Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(angles_rad.x(), Eigen::Vector3d::UnitX()))
                                  .toRotationMatrix();
  return base_from_sensor;
}

}  // namespace latticeworld
