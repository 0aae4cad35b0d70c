#include "latticeworld/dataset/captions/written_annotator.h"

#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/random.h"
#include "latticeworld/dataset/captions/environment_words.h"
#include "latticeworld/dataset/captions/layout_caption.h"
#include "latticeworld/dataset/captions/layout_facts.h"
#include "latticeworld/dataset/captions/phrase_book.h"
#include "latticeworld/dataset/captions/relief_words.h"
#include "latticeworld/dataset/sources/environment_sample.h"

namespace latticeworld {
namespace {

constexpr int kMostFacts = 12;
constexpr double kMostMistyped = 0.2;

Voice DrawVoice(RandomStream* random) {
  return static_cast<Voice>(random->UniformInt(0, static_cast<int>(EnumNames(Voice{}).size()) - 1));
}

class WrittenAnnotator final : public Annotator {
 public:
  explicit WrittenAnnotator(const WrittenOptions& options) : options_(options), name_("written") {
    const WrittenOptions usual;
    if (options.least_facts == usual.least_facts && options.most_facts == usual.most_facts) return;
    name_ += " (" + std::to_string(options.least_facts) + " to " +
             std::to_string(options.most_facts) + " facts)";
  }

  std::string_view name() const override { return name_; }

  Result<LayoutCaption> DescribeLayout(const Instance& instance, std::uint64_t seed,
                                       const Progress& progress) override {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    RandomStream random(StreamSeed(seed, instance.id), "layout caption");
    const LayoutMasks masks(instance.layout);
    const std::vector<ClassInLayout> classes = ClassesIn(masks);
    Wording wording;
    wording.voice = DrawVoice(&random);
    wording.picture = random.Chance(0.4);
    const int wanted = random.UniformInt(options_.least_facts, options_.most_facts);
    const std::vector<LayoutFact> facts = ChooseFacts(masks, classes, wanted, &random);
    LayoutCaption caption;
    caption.text = WordFacts(facts, classes, instance.layout.vocabulary, wording, &random);
    if (caption.text.empty()) {
      return DataLoss("nothing can be said of the layout of " + instance.id);
    }
    for (const LayoutFact& fact : facts) {
      caption.claims.insert(caption.claims.end(), fact.claims.begin(), fact.claims.end());
    }
    if (options_.mistyped > 0.0) {
      caption.text = Mistyped(std::move(caption.text), options_.mistyped, &random);
    }
    if (instance.relief != nullptr) {
      RandomStream words(StreamSeed(seed, instance.id), "relief caption");
      caption.relief_text =
          WordRelief(FactsOf(*instance.relief), wording.voice, wording.picture, &words);
    }
    return caption;
  }

  Result<EnvironmentCaption> DescribeEnvironment(const Instance& instance, const LayoutCaption&,
                                                 std::uint64_t seed,
                                                 const Progress& progress) override {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    RandomStream random(StreamSeed(seed, instance.id), "environment");
    const SampledEnvironment sample = SampleEnvironment(instance.layout, options_.size_m, &random);
    RandomStream words(StreamSeed(seed, instance.id), "environment caption");
    EnvironmentCaption caption;
    caption.environment = sample.environment;
    const Voice voice = DrawVoice(&words);
    const bool picture = words.Chance(0.4);
    caption.text = WordEnvironment(sample, voice, picture, &words);
    if (options_.mistyped > 0.0) {
      caption.text = Mistyped(std::move(caption.text), options_.mistyped, &words);
    }
    return caption;
  }

 private:
  const WrittenOptions options_;
  std::string name_;  // a continuation has to have the same
};

}  // namespace

std::vector<Violation> Validate(const WrittenOptions& options) {
  std::vector<Violation> violations;
  const auto demand = [&](bool holds, const char* name, double given, const char* legal) {
    if (holds) return;
    violations.push_back(
        {"out_of_range", name,
         std::string(name) + " must be " + legal + "; given " + std::to_string(given),
         std::to_string(given)});
  };
  demand(options.least_facts >= 1 && options.least_facts <= kMostFacts, "least_facts",
         options.least_facts, "from 1 to 12");
  demand(options.most_facts >= options.least_facts && options.most_facts <= kMostFacts,
         "most_facts", options.most_facts, "from least_facts to 12");
  demand(options.mistyped >= 0.0 && options.mistyped <= kMostMistyped, "mistyped", options.mistyped,
         "from 0 to 0.2");
  demand(options.size_m > 0.0 && options.size_m < 1e6, "size_m", options.size_m, "above 0");
  return violations;
}

std::unique_ptr<Annotator> MakeWrittenAnnotator(const WrittenOptions& options) {
  LW_CHECK(Validate(options).empty(), "options are validated where they come in");
  return std::make_unique<WrittenAnnotator>(options);
}

}  // namespace latticeworld
