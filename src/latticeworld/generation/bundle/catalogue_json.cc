#include "latticeworld/generation/bundle/catalogue_json.h"

#include <cstddef>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/generation/json_fields.h"

namespace latticeworld {

namespace jf = json_fields;
using jf::Json;

namespace {

// A catalogue's 32 MiB of text, each byte of it escaped, and the names. Parsing takes memory of
// several times the length.
constexpr std::size_t kMaxBytes = 65 << 20;

}  // namespace

std::string EncodeCatalogue(const Catalogue& catalogue) {
  Json json = Json::array();
  for (const CatalogueFile& file : catalogue.added_files()) {
    json.push_back({{"name", file.name}, {"text", file.text}});
  }
  return jf::Dump(json);
}

Result<std::shared_ptr<const Catalogue>> DecodeCatalogue(std::string_view content) {
  if (content.size() > kMaxBytes) {
    return DataLoss("it has " + std::to_string(content.size()) + " bytes; legal are at most " +
                    std::to_string(kMaxBytes));
  }
  std::vector<CatalogueFile> files;
  try {
    const Json json = jf::Parse(content);
    if (!json.is_array()) return DataLoss("it is not an array");
    for (const Json& file : json) {
      jf::ExpectKeys(file, {"name", "text"});
      files.push_back({jf::Text(file, "name"), jf::Text(file, "text")});
    }
  } catch (const std::exception& error) {  // JSON
    return DataLoss(error.what());
  }
  auto catalogue = Catalogue::Extended(std::move(files));
  if (!catalogue.ok()) return DataLoss(catalogue.status().message());
  return catalogue;
}

}  // namespace latticeworld
