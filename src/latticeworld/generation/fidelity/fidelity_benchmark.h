#ifndef LATTICEWORLD_GENERATION_FIDELITY_FIDELITY_BENCHMARK_H_
#define LATTICEWORLD_GENERATION_FIDELITY_FIDELITY_BENCHMARK_H_

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {

// The development part may be tuned on, the test part and the one for first sight never.
enum class BenchmarkPart : std::uint8_t { kDevelopment, kTest, kFirstSight };

constexpr std::array<EnumName<BenchmarkPart>, 3> EnumNames(BenchmarkPart) {
  return {{{BenchmarkPart::kDevelopment, "development"},
           {BenchmarkPart::kTest, "test"},
           {BenchmarkPart::kFirstSight, "first_sight"}}};
}

// A layout instruction and what it says, written down by hand.
struct LayoutItem {
  std::string id;
  std::string instruction;
  Vocabulary vocabulary = Vocabulary::kSuburb;
  std::vector<Claim> claims;
};

// The same of an environment instruction, for a given layout.
struct EnvironmentItem {
  std::string id;
  std::string instruction;
  SymbolicLayout layout;
  std::vector<EnvironmentClaim> claims;
};

struct FidelityBenchmark {
  std::vector<LayoutItem> layouts;
  std::vector<EnvironmentItem> environments;
};

// Reads one part: layout_<part>.json, environment_<part>.json and the layouts that it names, below
// layouts/. Errors: NOT_FOUND, PERMISSION_DENIED; INVALID_ARGUMENT naming the file, the item and
// what is wrong with it.
Result<FidelityBenchmark> ReadFidelityBenchmark(const std::filesystem::path& directory,
                                                BenchmarkPart part);

// Reads examples for readers as a benchmark (training/examples, JSON Lines): the claims of a text
// are those of its sentences. most: only so many of them, from the first; agents live on land that
// is the same for all. Errors: NOT_FOUND, PERMISSION_DENIED; INVALID_ARGUMENT naming the line.
Result<FidelityBenchmark> ReadReaderExamples(const std::filesystem::path& file, std::size_t most);

struct FidelityScore {
  struct Count {
    int satisfied = 0;
    int total = 0;
  };
  struct Miss {
    std::string id;
    std::string kind;
    std::string words;        // of the claim
    std::string explanation;  // of its measure, or why there was no answer
  };
  struct Warning {
    std::string id;
    std::string text;  // of the answer, or of what was read
  };
  struct TwoReadings {
    std::string id;
    std::vector<ReadingEvidence> evidence;  // which of them is right, in each part
  };
  std::map<std::string, Count> by_kind;
  int items = 0;
  int answered = 0;  // with a legal layout or a valid environment
  std::vector<Miss> misses;
  std::vector<Warning> warnings;
  std::vector<TwoReadings> read_twice;
  double median_s = 0.0;  // of one answer

  Count all() const;
};

// Lets every item be read and answered and measures the answers by the items' own claims. What has
// no answer satisfies nothing. seed: each item draws its own from it. Errors: CANCELLED.
Result<FidelityScore> ScoreLayouts(const std::vector<LayoutItem>& items, std::uint64_t seed,
                                   InstructionReader* reader, LayoutGenerator* generator,
                                   const Progress& progress);
Result<FidelityScore> ScoreEnvironments(const std::vector<EnvironmentItem>& items,
                                        std::uint64_t seed, InstructionReader* reader,
                                        EnvironmentGenerator* generator, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_FIDELITY_FIDELITY_BENCHMARK_H_
