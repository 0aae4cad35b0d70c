#include "latticeworld/language/reading/reading_evidence.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"
#include "latticeworld/language/reading/sentences_of_claims.h"

namespace latticeworld {
namespace {

// Weights of a constant and of what is below it in Signs().
using Numbers = std::array<double, 7>;

// Fitted by logistic regression over the texts of author k02, on whom nobody was trained, where the
// readers have unlike numbers of the part's claims right:
// training/latticeworld_training/fit_choice.py.
constexpr std::array<Numbers, EnumNames(ReadingPart{}).size()> kWeights = {{
    {4.928, 14.919, -0.221, 0.876, -0.162, -4.266, 1.350},   // land
    {3.755, 12.334, 0.123, -5.334, -0.903, -5.099, -0.171},  // coarse
    {4.253, 56.664, 0.327, 2.261, -2.520, -3.446, 1.430},    // fine
    {2.913, 0.000, -0.210, -2.601, -0.555, -0.606, -0.571},  // agents
}};

double Share(int part, int whole) { return static_cast<double>(part) / std::max(1, whole); }

// Bounded, so that no text is told by how far it is from those that the weights were fitted to.
Numbers Signs(const ReadingEvidence& e) {
  return {1.0,
          std::max(e.log_probability, -1.0),
          std::clamp(static_cast<double>(e.lost - e.second_lost), -4.0, 4.0),
          Share(e.second_carried - e.carried, e.words),
          std::min(Share(e.second_claims - e.claims, e.claims), 2.0),
          Share(e.agreed, e.claims),
          Share(e.agreed, e.second_claims)};
}

ReadingPart PartOf(EnvironmentClaimKind kind) {
  switch (kind) {
    case EnvironmentClaimKind::kCoarse:
      return ReadingPart::kCoarse;
    case EnvironmentClaimKind::kDensity:
    case EnvironmentClaimKind::kVariant:
    case EnvironmentClaimKind::kParameter:
      return ReadingPart::kFine;
    case EnvironmentClaimKind::kAgents:
    case EnvironmentClaimKind::kNoAgents:
    case EnvironmentClaimKind::kTotalAgents:
      break;
  }
  return ReadingPart::kAgents;
}

// The claims of a part, said.
std::set<std::string> SaidOf(const std::vector<EnvironmentClaim>& claims, ReadingPart part) {
  std::set<std::string> said;
  for (const EnvironmentClaim& claim : claims) {
    if (PartOf(claim.kind) != part) continue;
    for (std::string& sentence : SentencesOf(claim)) said.insert(std::move(sentence));
  }
  return said;
}

template <typename Reading>
ReadingEvidence Compare(ReadingPart part, const Reading& model, const Reading& second,
                        const std::set<std::string>& claims,
                        const std::set<std::string>& second_claims) {
  ReadingEvidence evidence;
  evidence.part = part;
  evidence.log_probability = model.log_probability;
  evidence.words = model.coverage.words;
  evidence.carried = model.coverage.carried;
  evidence.second_carried = second.coverage.carried;
  evidence.lost = static_cast<int>(model.coverage.lost.size());
  evidence.second_lost = static_cast<int>(second.coverage.lost.size());
  evidence.claims = static_cast<int>(claims.size());
  evidence.second_claims = static_cast<int>(second_claims.size());
  for (const std::string& claim : claims) {
    evidence.agreed += static_cast<int>(second_claims.count(claim));
  }
  return evidence;
}

}  // namespace

std::vector<ReadingEvidence> EvidenceOf(const LayoutReading& model, const LayoutReading& second,
                                        Vocabulary vocabulary) {
  const auto said = [&](const LayoutReading& reading) {
    const std::vector<std::string> sentences = SentencesOf(reading.plan.claims, vocabulary);
    return std::set<std::string>(sentences.begin(), sentences.end());
  };
  return {Compare(ReadingPart::kLand, model, second, said(model), said(second))};
}

std::vector<ReadingEvidence> EvidenceOf(const EnvironmentReading& model,
                                        const EnvironmentReading& second,
                                        const SymbolicLayout* layout) {
  const std::vector<EnvironmentClaim> claims = ClaimsOf(model.heard, layout);
  const std::vector<EnvironmentClaim> second_claims = ClaimsOf(second.heard, layout);
  std::vector<ReadingEvidence> evidence;
  for (const ReadingPart part : {ReadingPart::kCoarse, ReadingPart::kFine, ReadingPart::kAgents}) {
    evidence.push_back(
        Compare(part, model, second, SaidOf(claims, part), SaidOf(second_claims, part)));
  }
  return evidence;
}

double LogOddsOfModel(const ReadingEvidence& evidence) {
  if (evidence.claims == 0 && evidence.second_claims == 0) {
    return -std::numeric_limits<double>::infinity();
  }
  const bool same = evidence.agreed == evidence.claims && evidence.agreed == evidence.second_claims;
  if (same) return 0.0;
  const Numbers& weights = kWeights.at(static_cast<std::size_t>(evidence.part));
  const Numbers signs = Signs(evidence);
  return std::inner_product(weights.begin(), weights.end(), signs.begin(), 0.0);
}

}  // namespace latticeworld
