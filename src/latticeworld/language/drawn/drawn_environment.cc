#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"
#include "latticeworld/language/drawn/drawn.h"
#include "latticeworld/language/grounded/environment/agents/agent_fitting.h"
#include "latticeworld/language/grounded/environment/attributes/attribute_fitting.h"
#include "latticeworld/language/grounded/environment/claims_of_heard.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxNotUnderstood = 20;  // warnings; the others are only counted

// A warning begins with the words that it is about, in quotation marks.
bool IsAbout(const std::string& warning, const std::string& words) {
  const std::size_t end = warning.empty() || warning.front() != '"' ? 0 : warning.find("\": ");
  return warning.find(words) < end;
}

// What a warning is about already is not told again.
void WarnOfUnknown(const std::vector<std::string>& not_understood,
                   std::vector<std::string>* warnings) {
  std::vector<std::string> untold;
  for (const std::string& words : not_understood) {
    const bool told =
        std::any_of(warnings->begin(), warnings->end(),
                    [&](const std::string& warning) { return IsAbout(warning, words); });
    if (!told) untold.push_back(words);
  }
  for (std::size_t i = 0; i < std::min(kMaxNotUnderstood, untold.size()); ++i) {
    warnings->push_back("not understood: " + Quote(untold[i]));
  }
  if (untold.size() > kMaxNotUnderstood) {
    warnings->push_back("not understood: " + std::to_string(untold.size() - kMaxNotUnderstood) +
                        " more phrases");
  }
}

// Self-check: a claim that does not hold is told, unless a warning quotes its words already.
void WarnOfUnmet(const std::vector<EnvironmentClaim>& claims, const EnvironmentConfig& environment,
                 std::vector<std::string>* warnings) {
  for (const EnvironmentClaim& claim : claims) {
    const EnvironmentClaimMeasure measure = Measure(claim, environment);
    if (measure.holds) continue;
    const std::string words = Quote(claim.words);
    const bool told = std::any_of(
        warnings->begin(), warnings->end(),
        [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
    if (!told) warnings->push_back(words + ": not met: " + measure.explanation);
  }
}

class DrawnEnvironmentGenerator final : public EnvironmentGenerator {
 public:
  DrawnEnvironmentGenerator(std::string name, std::shared_ptr<InstructionReader> reader)
      : name_(std::move(name)), reader_(std::move(reader)) {}

  std::string_view name() const override { return name_; }

  Result<EnvironmentAnswer> Generate(const EnvironmentRequest& request, const Progress& progress,
                                     std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    HeardEnvironment heard;
    if (request.reading != nullptr) {
      heard = request.reading->heard;
    } else {
      LW_ASSIGN_OR_RETURN(EnvironmentReading reading,
                          reader_->ReadEnvironment(request, progress, replies));
      heard = std::move(reading.heard);
    }
    const Catalogue& catalogue = *request.catalogue;
    EnvironmentAnswer answer;
    answer.warnings = heard.warnings;
    EnvironmentConfig& environment = answer.environment;
    environment.coarse = FitCoarse(heard, *request.layout, catalogue);
    environment.fine = FitFine(heard.fine, environment.coarse, catalogue, &answer.warnings);
    environment.agents = FitAgents(heard.agents, *request.layout, request.size_m, &answer.warnings);
    WarnOfUnmet(ClaimsOf(heard, request.layout), environment, &answer.warnings);
    WarnOfUnknown(heard.not_understood, &answer.warnings);
    LW_CHECK(latticeworld::Validate(environment, catalogue).empty(),
             "the drawn environment must be valid");
    return answer;
  }

 private:
  const std::string name_;
  const std::shared_ptr<InstructionReader> reader_;
};

}  // namespace

std::unique_ptr<EnvironmentGenerator> MakeDrawnEnvironmentGenerator(
    std::string name, std::shared_ptr<InstructionReader> reader) {
  return std::make_unique<DrawnEnvironmentGenerator>(std::move(name), std::move(reader));
}

}  // namespace latticeworld
