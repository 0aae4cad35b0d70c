#include "latticeworld/generation/fidelity/fidelity_json.h"

#include <exception>
#include <utility>

#include "latticeworld/generation/json_fields.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;
using jf::Json;

constexpr std::int64_t kMostWords = 1 << 16;

ClaimOutcome DecodeClaim(const Json& json) {
  jf::ExpectKeys(json, {"part", "kind", "words", "satisfied", "distance", "explanation"});
  ClaimOutcome claim;
  claim.part = jf::Named<InstructionPart>(json, "part");
  claim.kind = jf::Text(json, "kind");
  claim.words = jf::Text(json, "words");
  claim.satisfied = jf::Boolean(json, "satisfied");
  claim.distance = jf::Number(json, "distance", 0.0, 1.0);
  claim.explanation = jf::Text(json, "explanation");
  return claim;
}

std::vector<std::string> DecodeTexts(const Json& json, const char* key) {
  std::vector<std::string> texts;
  for (const Json& text : jf::Array(json, key)) {
    if (!text.is_string()) jf::Fail(key, text, "a list of texts");
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

Json Encode(const std::vector<ClaimOutcome>& claims) {
  Json json = Json::array();
  for (const ClaimOutcome& claim : claims) {
    json.push_back({{"part", std::string(NameOf(claim.part))},
                    {"kind", claim.kind},
                    {"words", claim.words},
                    {"satisfied", claim.satisfied},
                    {"distance", claim.distance},
                    {"explanation", claim.explanation}});
  }
  return json;
}

// Bundles of format 5 have claims and what was not understood alone.
void AddWhatFormat5Lacks(Json* json) {
  if (!json->is_object() || json->contains("words")) return;
  for (const char* key : {"layout_sentences", "environment_sentences", "second"}) {
    (*json)[key] = Json::array();
  }
  for (const char* key : {"words", "words_read"}) (*json)[key] = 0;
}

FidelityReport Decode(std::string_view content) {
  Json json = jf::Parse(content);
  AddWhatFormat5Lacks(&json);
  jf::ExpectKeys(json, {"satisfied", "claims", "not_understood", "layout_sentences",
                        "environment_sentences", "words", "words_read", "second"});
  FidelityReport report;
  for (const Json& claim : jf::Array(json, "claims")) report.claims.push_back(DecodeClaim(claim));
  for (const Json& claim : jf::Array(json, "second")) report.second.push_back(DecodeClaim(claim));
  report.not_understood = DecodeTexts(json, "not_understood");
  report.layout_sentences = DecodeTexts(json, "layout_sentences");
  report.environment_sentences = DecodeTexts(json, "environment_sentences");
  report.words = static_cast<int>(jf::Integer(json, "words", 0, kMostWords));
  report.words_read = static_cast<int>(jf::Integer(json, "words_read", 0, report.words));
  if (jf::Integer(json, "satisfied", 0, static_cast<std::int64_t>(report.claims.size())) !=
      report.satisfied()) {
    jf::Fail("satisfied", json.at("satisfied"), "the number of claims that are satisfied");
  }
  return report;
}

}  // namespace

std::string EncodeFidelity(const FidelityReport& report) {
  const Json json = {{"satisfied", report.satisfied()},
                     {"claims", Encode(report.claims)},
                     {"not_understood", report.not_understood},
                     {"layout_sentences", report.layout_sentences},
                     {"environment_sentences", report.environment_sentences},
                     {"words", report.words},
                     {"words_read", report.words_read},
                     {"second", Encode(report.second)}};
  return jf::Dump(json);
}

Result<FidelityReport> DecodeFidelity(std::string_view content) {
  try {
    return Decode(content);
  } catch (const std::exception& error) {  // JSON
    return DataLoss(error.what());
  }
}

}  // namespace latticeworld
