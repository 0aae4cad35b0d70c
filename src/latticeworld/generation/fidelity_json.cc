#include "latticeworld/generation/fidelity_json.h"

#include <exception>
#include <utility>

#include "latticeworld/generation/json_fields.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;
using jf::Json;

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

FidelityReport Decode(std::string_view content) {
  const Json json = jf::Parse(content);
  jf::ExpectKeys(json, {"satisfied", "claims", "not_understood"});
  FidelityReport report;
  for (const Json& claim : jf::Array(json, "claims")) report.claims.push_back(DecodeClaim(claim));
  for (const Json& words : jf::Array(json, "not_understood")) {
    if (!words.is_string()) jf::Fail("not_understood", words, "a list of texts");
    report.not_understood.push_back(words.get<std::string>());
  }
  if (jf::Integer(json, "satisfied", 0, static_cast<std::int64_t>(report.claims.size())) !=
      report.satisfied()) {
    jf::Fail("satisfied", json.at("satisfied"), "the number of claims that are satisfied");
  }
  return report;
}

}  // namespace

std::string EncodeFidelity(const FidelityReport& report) {
  Json json = {{"satisfied", report.satisfied()},
               {"claims", Json::array()},
               {"not_understood", report.not_understood}};
  for (const ClaimOutcome& claim : report.claims) {
    json["claims"].push_back({{"part", std::string(NameOf(claim.part))},
                              {"kind", claim.kind},
                              {"words", claim.words},
                              {"satisfied", claim.satisfied},
                              {"distance", claim.distance},
                              {"explanation", claim.explanation}});
  }
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
