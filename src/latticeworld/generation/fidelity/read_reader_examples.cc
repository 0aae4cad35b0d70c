#include <exception>
#include <utility>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/generation/fidelity/fidelity_benchmark.h"
#include "latticeworld/generation/json_fields.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/grounded/synthesis/layout_synthesis.h"
#include "latticeworld/language/reading/environment_of_sentences.h"
#include "latticeworld/language/reading/layout_of_sentences.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;
using jf::Json;

constexpr std::size_t kMaxFileBytes = 64u << 20;

// Returns the land on which the agents of environments live: it has all that texts name often.
SymbolicLayout LayoutOfEnvironments() {
  const LayoutPlan plan =
      LayoutOfSentences({"A lake in the west", "A village in the east", "Forest in the north",
                         "Farmland in the south", "A river from the northern edge to the lake",
                         "A road from the village to the southern edge", "The rest is grassland"},
                        Vocabulary::kSuburb);
  return SynthesizeLayout(plan, nullptr, 1);
}

std::vector<std::string> SentencesOf(const Json& json) {
  std::vector<std::string> sentences;
  for (const Json& sentence : jf::Array(json, "sentences")) {
    if (!sentence.is_string()) jf::Fail("sentences", sentence, "a list of texts");
    sentences.push_back(sentence.get<std::string>());
  }
  return sentences;
}

void Decode(std::string_view line, const std::string& id, const SymbolicLayout& layout,
            FidelityBenchmark* benchmark) {
  const Json json = jf::Parse(line);
  const std::string kind = json.is_object() ? jf::Text(json, "kind") : "";
  if (kind == "layout") {
    jf::ExpectKeys(json, {"kind", "author", "voice", "vocabulary", "text", "sentences"});
    LayoutItem item;
    item.id = id;
    item.vocabulary = jf::Named<Vocabulary>(json, "vocabulary");
    item.instruction = jf::Text(json, "text");
    item.claims = LayoutOfSentences(SentencesOf(json), item.vocabulary).claims;
    benchmark->layouts.push_back(std::move(item));
  } else if (kind == "environment") {
    jf::ExpectKeys(json, {"kind", "author", "voice", "text", "sentences"});
    EnvironmentItem item;
    item.id = id;
    item.instruction = jf::Text(json, "text");
    item.layout = layout;
    item.claims = ClaimsOf(EnvironmentOfSentences(SentencesOf(json)), &layout);
    benchmark->environments.push_back(std::move(item));
  } else {
    jf::Fail("kind", json, "layout or environment");
  }
}

}  // namespace

Result<FidelityBenchmark> ReadReaderExamples(const std::filesystem::path& file, std::size_t most) {
  LW_ASSIGN_OR_RETURN(const std::string content, ReadFile(file, kMaxFileBytes));
  const SymbolicLayout layout = LayoutOfEnvironments();
  FidelityBenchmark benchmark;
  std::size_t number = 0;
  for (const std::string& line : Split(content, '\n')) {
    ++number;
    if (line.empty()) continue;
    if (benchmark.layouts.size() + benchmark.environments.size() == most) break;
    const std::string id = file.stem().string() + " " + std::to_string(number);
    try {
      Decode(line, id, layout, &benchmark);
    } catch (const std::exception& error) {  // JSON
      return InvalidArgument(id + ": " + error.what()).WithContext(file.string());
    }
  }
  return benchmark;
}

}  // namespace latticeworld
