#include <exception>
#include <set>
#include <utility>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_claims_json.h"
#include "latticeworld/generation/fidelity/fidelity_benchmark.h"
#include "latticeworld/generation/json_fields.h"
#include "latticeworld/layout/claims/claims_json.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;
namespace jf = json_fields;
using jf::Json;

constexpr std::size_t kMaxFileBytes = 16u << 20;

// A Status as it leaves a reader of JSON by way of its exceptions.
template <typename T>
T ValueOrThrow(Result<T> result, const std::string& context) {
  if (!result.ok()) throw jf::FieldError(context + ": " + result.status().message());
  return *std::move(result);
}

LayoutItem DecodeLayoutItem(const Json& json) {
  jf::ExpectKeys(json, {"id", "vocabulary", "voice", "instruction", "claims"});
  LayoutItem item;
  item.id = jf::Text(json, "id");
  item.vocabulary = jf::Named<Vocabulary>(json, "vocabulary");
  item.instruction = jf::Text(json, "instruction");
  item.claims =
      ValueOrThrow(DecodeClaims(jf::Array(json, "claims").dump(), item.vocabulary), item.id);
  return item;
}

// Reads each layout that items name once.
class LayoutFiles {
 public:
  explicit LayoutFiles(fs::path directory) : directory_(std::move(directory)) {}

  const SymbolicLayout& Read(const std::string& name, Vocabulary vocabulary) {
    const auto known = layouts_.find(name);
    if (known != layouts_.end()) return known->second;
    if (name.empty() || name.find('/') != std::string::npos) {
      throw jf::FieldError("the layout " + Quote(name) + " is no name of a file below layouts");
    }
    const std::string text =
        ValueOrThrow(ReadFile(directory_ / (name + ".txt"), kMaxFileBytes), name);
    return layouts_.emplace(name, ValueOrThrow(ParseLayout(text, vocabulary), name)).first->second;
  }

 private:
  const fs::path directory_;
  std::map<std::string, SymbolicLayout> layouts_;
};

EnvironmentItem DecodeEnvironmentItem(const Json& json, LayoutFiles* layouts) {
  jf::ExpectKeys(json, {"id", "layout", "vocabulary", "voice", "instruction", "claims"});
  EnvironmentItem item;
  item.id = jf::Text(json, "id");
  item.instruction = jf::Text(json, "instruction");
  item.layout = layouts->Read(jf::Text(json, "layout"), jf::Named<Vocabulary>(json, "vocabulary"));
  item.claims = ValueOrThrow(ParseEnvironmentClaims(jf::Array(json, "claims").dump()), item.id);
  return item;
}

template <typename Item, typename Decode>
Result<std::vector<Item>> ReadItems(const fs::path& file, const Decode& decode) {
  LW_ASSIGN_OR_RETURN(const std::string content, ReadFile(file, kMaxFileBytes));
  try {
    const Json json = jf::Parse(content);
    if (!json.is_array()) throw jf::FieldError("it is not an array");
    std::vector<Item> items;
    std::set<std::string> ids;
    for (const Json& entry : json) {
      items.push_back(decode(entry));
      if (!ids.insert(items.back().id).second) {
        throw jf::FieldError("the id " + Quote(items.back().id) + " is there twice");
      }
    }
    return items;
  } catch (const std::exception& error) {  // JSON
    return InvalidArgument(file.string() + ": " + error.what());
  }
}

}  // namespace

Result<FidelityBenchmark> ReadFidelityBenchmark(const fs::path& directory, BenchmarkPart part) {
  const std::string ending = "_" + std::string(NameOf(part)) + ".json";
  FidelityBenchmark benchmark;
  LW_ASSIGN_OR_RETURN(benchmark.layouts,
                      ReadItems<LayoutItem>(directory / ("layout" + ending), DecodeLayoutItem));
  LayoutFiles layouts(directory / "layouts");
  LW_ASSIGN_OR_RETURN(benchmark.environments,
                      ReadItems<EnvironmentItem>(directory / ("environment" + ending),
                                                 [&layouts](const Json& json) {
                                                   return DecodeEnvironmentItem(json, &layouts);
                                                 }));
  return benchmark;
}

}  // namespace latticeworld
