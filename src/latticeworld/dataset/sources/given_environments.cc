#include "latticeworld/dataset/sources/given_environments.h"

#include <algorithm>
#include <map>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/sources/generated_source.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/remote/answer_in_form.h"

namespace latticeworld {
namespace {

class GivenEnvironmentSource final : public InstanceSource {
 public:
  GivenEnvironmentSource(std::vector<GivenInstruction> instructions, const std::string& title,
                         const GivenInstructionsOptions& options)
      : instructions_(std::move(instructions)),
        options_(options),
        card_{"environment instructions",
              title + ", of " + std::to_string(options.answers) +
                  " places of LatticeWorld's own generator each",
              "", ""} {}

  const SourceCard& card() const override { return card_; }
  std::size_t group_count() const override { return instructions_.size(); }
  std::string GroupName(std::size_t index) const override { return instructions_[index].id; }

  Result<std::vector<Instance>> ReadGroup(std::size_t index) const override {
    const GivenInstruction& given = instructions_[index];
    GeneratedSourceOptions places;
    places.seed = StreamSeed(options_.seed, "dataset/environment instructions/" + given.id);
    places.relief_share = 0.0;
    std::vector<Instance> instances;
    for (std::size_t i = 0; instances.size() < static_cast<std::size_t>(options_.answers); ++i) {
      Instance place = GeneratePlace(places, i).instance;
      if (place.layout.vocabulary != given.vocabulary) continue;  // every second one is
      place.id = given.id + "-" + std::to_string(instances.size());
      place.group = given.id;
      instances.push_back(std::move(place));
    }
    return instances;
  }

 private:
  const std::vector<GivenInstruction> instructions_;
  const GivenInstructionsOptions options_;
  const SourceCard card_;
};

class GivenEnvironmentAnnotator final : public Annotator {
 public:
  GivenEnvironmentAnnotator(std::vector<GivenInstruction> instructions,
                            const WrittenOptions& written)
      : size_m_(written.size_m), layouts_(MakeWrittenAnnotator(written)) {
    for (GivenInstruction& given : instructions) words_[given.id] = std::move(given.words);
  }

  std::string_view name() const override { return "given environments"; }

  Result<LayoutCaption> DescribeLayout(const Instance& instance, std::uint64_t seed,
                                       const Progress& progress) override {
    return layouts_->DescribeLayout(instance, seed, progress);
  }

  Result<EnvironmentCaption> DescribeEnvironment(const Instance& instance, const LayoutCaption&,
                                                 std::uint64_t seed,
                                                 const Progress& progress) override {
    const auto given = words_.find(instance.group);
    if (given == words_.end()) return DataLoss("nobody asked for " + instance.id);
    EnvironmentRequest request;
    request.instruction = given->second;
    request.layout = &instance.layout;
    request.size_m = size_m_;
    request.seed = seed;
    LW_ASSIGN_OR_RETURN(EnvironmentAnswer answer,
                        MakeGroundedEnvironmentGenerator()->Generate(request, progress));
    RoundToForm(&answer.environment);
    const std::vector<EnvironmentClaim> claims =
        ReadEnvironmentInstruction(request.instruction, &instance.layout).claims;
    const bool whole = std::all_of(claims.begin(), claims.end(), [&](const EnvironmentClaim& c) {
      return Measure(c, answer.environment).holds;
    });
    if (!whole || claims.empty())
      return DataLoss("nothing is understood of " + Quote(given->second) +
                      ", or it cannot be had in " + instance.id);
    EnvironmentCaption caption;
    caption.text = given->second;
    caption.environment = std::move(answer.environment);
    return caption;
  }

 private:
  const double size_m_;
  const std::unique_ptr<Annotator> layouts_;
  std::map<std::string, std::string> words_;  // by id
};

}  // namespace

Result<std::unique_ptr<InstanceSource>> MakeGivenEnvironmentSource(
    std::vector<GivenInstruction> instructions, const std::string& title,
    const GivenInstructionsOptions& options) {
  LW_ASSIGN_OR_RETURN(std::vector<GivenInstruction> used,
                      UsedInstructions(std::move(instructions), options));
  return std::unique_ptr<InstanceSource>(
      new GivenEnvironmentSource(std::move(used), title, options));
}

std::unique_ptr<Annotator> MakeGivenEnvironmentAnnotator(std::vector<GivenInstruction> instructions,
                                                         const WrittenOptions& written) {
  return std::make_unique<GivenEnvironmentAnnotator>(std::move(instructions), written);
}

}  // namespace latticeworld
