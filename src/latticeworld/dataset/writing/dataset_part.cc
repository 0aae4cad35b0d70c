#include "latticeworld/dataset/writing/dataset_part.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/files.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostPartBytes = std::size_t{4} << 30;

Status Damaged(std::string_view what) {
  return DataLoss(std::string(what) + " is damaged or no part of a data set");
}

// The parts of the body in the order in which they are written.
template <typename Part, typename Visit>
void ForEachSection(Part* part, const Visit& visit) {
  for (auto& task : part->lines) {
    for (auto& lines : task) visit(&lines);
  }
  visit(&part->image_sums);
}

}  // namespace

DatasetTallies ReadTallies(const Json& json) {
  DatasetTallies tallies;
  // Not converted as a whole: that casts numbers with a point too, however large they are.
  for (const auto& [key, count] : json.get_ref<const Json::object_t&>()) {
    tallies[key] = count.get_ref<const Json::number_unsigned_t&>();
  }
  return tallies;
}

std::string EncodePart(const DatasetPart& part) {
  std::string body;
  Json sizes = Json::array();
  ForEachSection(&part, [&](const std::string* section) {
    sizes.push_back(section->size());
    body += *section;
  });
  Json failed = Json::array();
  for (const FailedInstance& instance : part.failed)
    failed.push_back({instance.group, instance.instance, instance.reason});
  const Json header = {
      {"sizes", sizes}, {"sha256", Sha256Hex(body)}, {"tallies", part.tallies}, {"failed", failed}};
  return header.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" + body;
}

Result<DatasetPart> DecodePart(std::string_view bytes, std::string_view what) {
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) return Damaged(what);
  std::string_view body = bytes.substr(end + 1);
  DatasetPart part;
  try {
    const Json header = Json::parse(bytes.substr(0, end));
    const Json& sizes = header.at("sizes");
    if (sizes.size() != kDatasetTasks * kDatasetSplits + 1) return Damaged(what);
    for (const Json& size : sizes) {
      if (!size.is_number_unsigned()) return Damaged(what);
    }
    if (header.at("sha256").get<std::string>() != Sha256Hex(body)) return Damaged(what);
    std::size_t next = 0;
    ForEachSection(&part, [&](std::string* section) {
      *section = std::string(body.substr(0, sizes[next++].get<std::size_t>()));
      body.remove_prefix(section->size());
    });
    if (!body.empty()) return Damaged(what);
    part.tallies = ReadTallies(header.at("tallies"));
    for (const Json& failed : header.at("failed"))
      part.failed.push_back({failed.at(0), failed.at(1), failed.at(2)});
  } catch (const Json::exception&) {
    return Damaged(what);
  }
  return part;
}

Result<DatasetPart> ReadPart(const std::filesystem::path& path) {
  LW_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path, kMostPartBytes));
  return DecodePart(bytes, path.string());
}

}  // namespace latticeworld
