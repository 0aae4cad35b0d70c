#include "latticeworld/dataset/sources/given_instructions.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/captions/written_annotator.h"
#include "latticeworld/dataset/sources/source_files.h"
#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

constexpr int kMostAnswers = 1000;

// The instruction of one entry; what is wrong with it goes to `violations`.
GivenInstruction ReadEntry(const nlohmann::json& entry, std::size_t number,
                           std::vector<Violation>* violations) {
  const std::string pointer = "/" + std::to_string(number);
  const auto text = [&](const char* key) -> std::string {
    if (entry.is_object() && entry.contains(key) && entry[key].is_string()) return entry[key];
    violations->push_back({"missing", pointer, std::string("has no text \"") + key + "\"", ""});
    return "";
  };
  GivenInstruction given;
  given.id = text("id");
  given.words = text("instruction");
  const std::string vocabulary = text("vocabulary");
  if (const auto known = FromName<Vocabulary>(vocabulary)) {
    given.vocabulary = *known;
  } else if (!vocabulary.empty()) {
    violations->push_back({"unknown_name", pointer + "/vocabulary",
                           "is " + Quote(vocabulary) + "; legal are suburb, wild", vocabulary});
  }
  if (SafeName(given.id) != given.id) {
    violations->push_back({"illegal_name", pointer + "/id",
                           "is " + Quote(given.id) + "; legal are letters, digits, _ and -",
                           given.id});
  }
  if (given.words.size() > kMaxInstructionBytes) {
    violations->push_back({"too_long", pointer + "/instruction",
                           "has " + std::to_string(given.words.size()) + " bytes; at most " +
                               std::to_string(kMaxInstructionBytes) + " are read",
                           ""});
  }
  return given;
}

class GivenSource final : public InstanceSource {
 public:
  GivenSource(std::vector<GivenInstruction> instructions, const std::string& title,
              const GivenInstructionsOptions& options)
      : instructions_(std::move(instructions)),
        options_(options),
        card_{"instructions",
              title + ", " + std::to_string(options.answers) +
                  " layouts of the embedded generator for each",
              "", ""} {}

  const SourceCard& card() const override { return card_; }
  std::size_t group_count() const override { return instructions_.size(); }
  std::string GroupName(std::size_t index) const override { return instructions_[index].id; }

  Result<std::vector<Instance>> ReadGroup(std::size_t index) const override {
    const GivenInstruction& given = instructions_[index];
    LayoutRequest request;
    request.instruction = given.words;
    request.vocabulary = given.vocabulary;
    const std::vector<Claim> claims =
        ReadLayoutInstruction(given.words, given.vocabulary).plan.claims;
    std::vector<Instance> instances;
    for (int i = 0; i < options_.answers; ++i) {
      const std::string id = given.id + "-" + std::to_string(i);
      request.seed = StreamSeed(options_.seed, "dataset/instructions/" + id);
      LW_ASSIGN_OR_RETURN(LayoutAnswer answer,
                          MakeGroundedLayoutGenerator()->Generate(request, Progress()));
      const bool whole = std::all_of(claims.begin(), claims.end(), [&](const Claim& claim) {
        return Measure(claim, answer.layout).holds;
      });
      if (!whole) continue;
      instances.push_back({id, given.id, std::move(answer.layout), nullptr});
    }
    if (instances.empty() || claims.empty())
      return DataLoss("nothing is understood of " + Quote(given.words) + ", or it cannot be had");
    return instances;
  }

 private:
  const std::vector<GivenInstruction> instructions_;
  const GivenInstructionsOptions options_;
  const SourceCard card_;
};

class GivenAnnotator final : public Annotator {
 public:
  GivenAnnotator(std::vector<GivenInstruction> instructions, double size_m)
      : environments_([&] {
          WrittenOptions options;
          options.size_m = size_m;
          return MakeWrittenAnnotator(options);
        }()) {
    for (GivenInstruction& given : instructions) words_[given.id] = std::move(given.words);
  }

  std::string_view name() const override { return "given"; }

  Result<LayoutCaption> DescribeLayout(const Instance& instance, std::uint64_t,
                                       const Progress& progress) override {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    const auto given = words_.find(instance.group);
    if (given == words_.end()) return DataLoss("nobody asked for " + instance.id);
    LayoutCaption caption;
    caption.text = given->second;
    caption.claims = ReadLayoutInstruction(caption.text, instance.layout.vocabulary).plan.claims;
    return caption;
  }

  Result<EnvironmentCaption> DescribeEnvironment(const Instance& instance,
                                                 const LayoutCaption& layout, std::uint64_t seed,
                                                 const Progress& progress) override {
    return environments_->DescribeEnvironment(instance, layout, seed, progress);
  }

 private:
  std::map<std::string, std::string> words_;  // by id
  const std::unique_ptr<Annotator> environments_;
};

}  // namespace

Result<std::vector<GivenInstruction>> ReadGivenInstructions(const std::filesystem::path& file) {
  LW_ASSIGN_OR_RETURN(const std::string text, ReadSourceFile(file));
  const auto json = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_array() || json.empty()) {
    return InvalidArgument(file.string() + ": is no JSON array of instructions");
  }
  std::vector<GivenInstruction> instructions;
  std::vector<Violation> violations;
  std::set<std::string> ids;
  for (const auto& entry : json) {
    instructions.push_back(ReadEntry(entry, instructions.size(), &violations));
    if (!ids.insert(instructions.back().id).second && !instructions.back().id.empty()) {
      violations.push_back({"not_unique", "/" + std::to_string(instructions.size() - 1) + "/id",
                            "stands twice: " + Quote(instructions.back().id), ""});
    }
  }
  LW_RETURN_IF_ERROR(Status::FromViolations(file.string(), std::move(violations)));
  return instructions;
}

std::vector<Violation> Validate(const GivenInstructionsOptions& options) {
  std::vector<Violation> violations;
  CheckRange("answers", options.answers, {1.0, 1.0 * kMostAnswers}, "", &violations);
  CheckRange("leave_out", options.leave_out, {0.0, 1.0 * kMostAnswers}, "", &violations);
  return violations;
}

Result<std::vector<GivenInstruction>> UsedInstructions(std::vector<GivenInstruction> instructions,
                                                       const GivenInstructionsOptions& options) {
  LW_RETURN_IF_ERROR(Status::FromViolations("given instructions", Validate(options)));
  std::vector<GivenInstruction> used;
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    const bool left_out =
        options.leave_out > 0 && i % static_cast<std::size_t>(options.leave_out) == 0;
    if (!left_out) used.push_back(std::move(instructions[i]));
  }
  if (used.empty()) return InvalidArgument("no instruction is left of those that were given");
  return used;
}

Result<std::unique_ptr<InstanceSource>> MakeGivenSource(std::vector<GivenInstruction> instructions,
                                                        const std::string& title,
                                                        const GivenInstructionsOptions& options) {
  LW_ASSIGN_OR_RETURN(std::vector<GivenInstruction> used,
                      UsedInstructions(std::move(instructions), options));
  return std::unique_ptr<InstanceSource>(new GivenSource(std::move(used), title, options));
}

std::unique_ptr<Annotator> MakeGivenAnnotator(std::vector<GivenInstruction> instructions,
                                              double size_m) {
  return std::make_unique<GivenAnnotator>(std::move(instructions), size_m);
}

}  // namespace latticeworld
