#ifndef LATTICEWORLD_DATASET_WRITING_DATASET_PART_H_
#define LATTICEWORLD_DATASET_WRITING_DATASET_PART_H_

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/dataset/writing/dataset_options.h"

namespace latticeworld {

// What could not be made into records.
struct FailedInstance {
  std::string group;
  std::string instance;  // "": the whole group could not be read
  std::string reason;
};

// Numbers for manifest and card, which add up over parts. The keys:
//   groups/<split>, instances/<split>, records/<task>/<split>
//   vocabulary/<name>, relief (instances that have one), images (files)
//   cells/<vocabulary>/<letter>, claims/<kind>
//   bytes/<task> (of all instructions), length/<task>/<0000, 0100, ...> (how many so long [bytes])
//   season/<name>, weather/<name>, time_of_day/<name>, style/<name>, species/<name> (agents)
using DatasetTallies = std::map<std::string, std::uint64_t>;
// Those that stand in a JSON object; throws nlohmann::json::exception where it is none of whole
// numbers.
DatasetTallies ReadTallies(const nlohmann::json& json);

// The records of some groups that follow each other, with what is to be counted of them.
struct DatasetPart {
  std::array<std::array<std::string, kDatasetSplits>, kDatasetTasks> lines;  // JSON Lines
  std::string image_sums;  // "<SHA-256>  <path>" a line, as sha256sum writes and checks them
  DatasetTallies tallies;
  std::vector<FailedInstance> failed;
};

// One file a part: a line of JSON that tells sizes, SHA-256, tallies and failures, then the rest.
std::string EncodePart(const DatasetPart& part);
// Errors: DATA_LOSS naming `what` (truncated, damaged, or nothing of the kind).
Result<DatasetPart> DecodePart(std::string_view bytes, std::string_view what);
// The same of a file. Errors: those of ReadFile, and DATA_LOSS.
Result<DatasetPart> ReadPart(const std::filesystem::path& path);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_WRITING_DATASET_PART_H_
