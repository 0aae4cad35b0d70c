#include "latticeworld_ros/episode/episode_recorder_options.h"

#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/episode/bag_file.h"

namespace latticeworld {
namespace {

using XmlRpc::XmlRpcValue;

constexpr int kMostBufferMb = 65536;

void Refuse(const std::string& name, const std::string& given, const std::string& legal,
            std::vector<Violation>* violations) {
  violations->push_back({"out_of_range", name, given + " is not legal; legal is " + legal, given});
}

}  // namespace

Result<EpisodeRecorderOptions> RecorderOptionsFromParameters(const XmlRpcValue& parameters) {
  EpisodeRecorderOptions options;
  std::vector<Violation> violations;
  XmlRpcValue given = parameters;  // its conversions are not const
  if (given.getType() == XmlRpcValue::TypeStruct) {
    for (auto& [name, value] : given) {
      if (name == "buffer_mb") {
        const bool is_int = value.getType() == XmlRpcValue::TypeInt;
        options.buffer_mb = is_int ? static_cast<int>(value) : 0;
        if (!is_int) Refuse(name, value.toXml(), "a whole number", &violations);
      } else if (name == "directory" || name == "compression") {
        std::string& field = name == "directory" ? options.directory : options.compression;
        if (value.getType() == XmlRpcValue::TypeString) {
          field = static_cast<std::string>(value);
        } else {
          Refuse(name, value.toXml(), "a text", &violations);
        }
      } else {
        violations.push_back({"unknown_key", name,
                              "there is no such parameter; there are buffer_mb, compression, "
                              "directory",
                              name});
      }
    }
  } else if (given.valid()) {
    violations.push_back({"wrong_type", "", "the parameters are no dictionary", given.toXml()});
  }
  if (options.directory.empty()) Refuse("directory", "\"\"", "a directory", &violations);
  if (!FromName<BagCompression>(options.compression)) {
    Refuse("compression", Quote(options.compression), "one of " + LegalNames<BagCompression>(),
           &violations);
  }
  if (options.buffer_mb < 1 || options.buffer_mb > kMostBufferMb) {
    Refuse("buffer_mb", std::to_string(options.buffer_mb), "1 .. " + std::to_string(kMostBufferMb),
           &violations);
  }
  const Status status = Status::FromViolations("parameters of episode_recorder", violations);
  if (!status.ok()) return status;
  return options;
}

}  // namespace latticeworld
