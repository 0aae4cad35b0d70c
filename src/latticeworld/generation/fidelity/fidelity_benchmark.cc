#include "latticeworld/generation/fidelity/fidelity_benchmark.h"

#include <algorithm>
#include <chrono>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

using ReadTwice = std::vector<FidelityScore::TwoReadings>;

double Median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// answer(item, &read_twice) gives a Result; measure(claim, answer) what it says of one claim.
template <typename Item, typename Answer, typename MeasureClaim>
Result<FidelityScore> Score(const std::vector<Item>& items, std::string_view stage,
                            const Progress& progress, const Answer& answer,
                            const MeasureClaim& measure) {
  FidelityScore score;
  std::vector<double> seconds;
  for (const Item& item : items) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    progress.Report(stage, static_cast<double>(score.items) / static_cast<double>(items.size()));
    ++score.items;
    const auto start = std::chrono::steady_clock::now();
    const auto result = answer(item, &score.read_twice);
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    if (result.status().code() == StatusCode::kCancelled) return result.status();
    if (result.ok()) {
      ++score.answered;
      for (const std::string& warning : result->warnings) {
        score.warnings.push_back({item.id, warning});
      }
    }
    for (const auto& claim : item.claims) {
      const std::string kind(NameOf(claim.kind));
      FidelityScore::Count& count = score.by_kind[kind];
      ++count.total;
      if (!result.ok()) {
        score.misses.push_back({item.id, kind, claim.words, result.status().ToString()});
        continue;
      }
      const auto measured = measure(claim, *result);
      if (measured.holds) {
        ++count.satisfied;
      } else {
        score.misses.push_back({item.id, kind, claim.words, measured.explanation});
      }
    }
  }
  score.median_s = Median(std::move(seconds));
  return score;
}

}  // namespace

FidelityScore::Count FidelityScore::all() const {
  Count sum;
  for (const auto& [kind, count] : by_kind) {
    sum.satisfied += count.satisfied;
    sum.total += count.total;
  }
  return sum;
}

Result<FidelityScore> ScoreLayouts(const std::vector<LayoutItem>& items, std::uint64_t seed,
                                   InstructionReader* reader, LayoutGenerator* generator,
                                   const Progress& progress) {
  return Score(
      items, "layouts", progress,
      [&](const LayoutItem& item, ReadTwice* read_twice) -> Result<LayoutAnswer> {
        LayoutRequest request;
        request.instruction = item.instruction;
        request.vocabulary = item.vocabulary;
        request.seed = StreamSeed(seed, item.id);
        std::vector<ModelReply> replies;
        LW_ASSIGN_OR_RETURN(const LayoutReading reading,
                            reader->ReadLayout(request, progress, &replies));
        if (!reading.evidence.empty()) read_twice->push_back({item.id, reading.evidence});
        request.reading = &reading;
        return generator->Generate(request, progress);
      },
      [](const Claim& claim, const LayoutAnswer& answer) { return Measure(claim, answer.layout); });
}

Result<FidelityScore> ScoreEnvironments(const std::vector<EnvironmentItem>& items,
                                        std::uint64_t seed, InstructionReader* reader,
                                        EnvironmentGenerator* generator, const Progress& progress) {
  return Score(
      items, "environments", progress,
      [&](const EnvironmentItem& item, ReadTwice* read_twice) -> Result<EnvironmentAnswer> {
        EnvironmentRequest request;
        request.instruction = item.instruction;
        request.layout = &item.layout;
        request.seed = StreamSeed(seed, item.id);
        std::vector<ModelReply> replies;
        LW_ASSIGN_OR_RETURN(const EnvironmentReading reading,
                            reader->ReadEnvironment(request, progress, &replies));
        if (!reading.evidence.empty()) read_twice->push_back({item.id, reading.evidence});
        request.reading = &reading;
        return generator->Generate(request, progress);
      },
      [](const EnvironmentClaim& claim, const EnvironmentAnswer& answer) {
        return Measure(claim, answer.environment);
      });
}

}  // namespace latticeworld
