#include <memory>
#include <string>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/language/grounded/agent_fitting.h"
#include "latticeworld/language/grounded/environment_parser.h"
#include "latticeworld/language/grounded/grounded.h"
#include "latticeworld/layout/measures.h"

namespace latticeworld {
namespace {

// The kind of land that a layout shows.
TerrainType TerrainTypeOf(const SymbolicLayout& layout) {
  const auto share = [&](char letter) { return ShareIn(layout, letter, Region::kAnywhere); };
  if (layout.vocabulary == Vocabulary::kWild) {
    if (share('S') > 0.05 || share('R') > 0.4) return TerrainType::kMountain;
    if (share('R') > 0.15) return TerrainType::kHills;
  } else {
    if (share('B') > 0.01) return TerrainType::kSuburb;
    if (share('D') > 0.5) return TerrainType::kDesert;
  }
  if (share('W') > 0.35) return TerrainType::kCoast;
  if (share('F') > 0.35) return TerrainType::kForest;
  if (layout.vocabulary == Vocabulary::kSuburb && share('A') > 0.3) return TerrainType::kPlain;
  return TerrainType::kGrassland;
}

// The season that the weather asks for when nobody names one.
Season UsualSeason(std::optional<Weather> weather) {
  return weather == Weather::kSnow ? Season::kWinter : Season::kSummer;
}

class GroundedEnvironmentGenerator final : public EnvironmentGenerator {
 public:
  std::string_view name() const override { return "grounded"; }

  Result<EnvironmentAnswer> Generate(const EnvironmentRequest& request,
                                     const Progress& progress) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    EnvironmentReading reading = ParseEnvironmentInstruction(request.instruction);
    EnvironmentAnswer answer;
    answer.warnings = std::move(reading.warnings);

    CoarseAttributes& coarse = answer.environment.coarse;
    coarse.terrain_type = reading.terrain_type.value_or(TerrainTypeOf(*request.layout));
    coarse.season = reading.season.value_or(UsualSeason(reading.weather));
    coarse.artistic_style = reading.artistic_style.value_or(ArtisticStyle::kRealistic);
    coarse.weather = reading.weather.value_or(Weather::kSunny);
    coarse.time_of_day = reading.time_of_day.value_or(TimeOfDay::kDay);

    answer.environment.fine = DeriveFineAttributes(coarse);
    for (const auto& [type, density] : reading.densities) {
      answer.environment.fine_of(type).density = density;
    }
    answer.environment.agents = FitAgents(reading.agents, *request.layout, &answer.warnings);
    LW_CHECK(latticeworld::Validate(answer.environment).empty(),
             "the grounded environment must be valid");
    return answer;
  }
};

}  // namespace

std::unique_ptr<EnvironmentGenerator> MakeGroundedEnvironmentGenerator() {
  return std::make_unique<GroundedEnvironmentGenerator>();
}

}  // namespace latticeworld
