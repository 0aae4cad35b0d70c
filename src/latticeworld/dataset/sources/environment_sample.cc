#include "latticeworld/dataset/sources/environment_sample.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/dataset/captions/phrase_book.h"
#include "latticeworld/environment/rules.h"
#include "latticeworld/language/grounded/environment/agents/agent_fitting.h"
#include "latticeworld/language/grounded/environment/attributes/attribute_fitting.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/remote/answer_in_form.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/layout/measures.h"

namespace latticeworld {
namespace {

constexpr int kMostGroups = 3;
constexpr int kTriesPerGroup = 24;
constexpr int kMostTold = 2;

template <typename Enum>
Enum DrawAny(RandomStream* random) {
  const auto& entries = EnumNames(Enum{});
  const auto at =
      static_cast<std::size_t>(random->UniformInt(0, static_cast<int>(std::size(entries)) - 1));
  return entries[at].value;
}

double ShareOf(const SymbolicLayout& layout, char letter) {
  return ShareIn(layout, letter, Region::kAnywhere);
}

int DrawQuantity(RandomStream* random) {
  if (random->Chance(0.25)) return 1;
  return random->Chance(0.75) ? random->UniformInt(2, 12) : random->UniformInt(13, 40);
}

// A group that can live on the layout as it is, or nothing after some tries.
std::optional<AgentGroup> DrawGroup(const SymbolicLayout& layout, double size_m,
                                    const std::vector<AgentGroup>& others, RandomStream* random) {
  for (int i = 0; i < kTriesPerGroup; ++i) {
    AgentWish wish;
    const auto category = DrawAny<AgentCategory>(random);
    const bool known = std::any_of(others.begin(), others.end(), [&](const AgentGroup& other) {
      return other.category == category;
    });
    if (known) continue;
    std::vector<AgentState> states;
    for (const auto& entry : EnumNames(AgentState{})) {
      if (CanBe(category, entry.value)) states.push_back(entry.value);
    }
    wish.categories = {category};
    wish.state = states[static_cast<std::size_t>(
        random->UniformInt(0, static_cast<int>(states.size()) - 1))];
    wish.least = wish.quantity = wish.most = DrawQuantity(random);
    wish.counted = true;
    // Some places and states do not suit a category that suits the land: they are drawn anew.
    for (int k = 0; k < 6; ++k) {
      const auto region = DrawAny<Region>(random);
      wish.places.clear();
      if (region != Region::kAnywhere) wish.places = {PlaceOf(region)};
      std::vector<std::string> warnings;
      std::vector<AgentGroup> groups = FitAgents({wish}, layout, size_m, &warnings);
      if (!warnings.empty() || groups.size() != 1) continue;
      const AgentGroup& group = groups.front();
      if (group.position == region && group.state == *wish.state) return group;
    }
  }
  return std::nullopt;
}

// Whether an asset type shows on the layout.
bool Shows(const SymbolicLayout& layout, AssetType type) {
  const bool suburb = layout.vocabulary == Vocabulary::kSuburb;
  const auto has = [&](char letter) { return ShareOf(layout, letter) >= 0.02; };
  switch (type) {
    case AssetType::kArchitecture:
      return suburb && has(suburb_letter::kBuilding);
    case AssetType::kRoad:
      return suburb && ShareOf(layout, suburb_letter::kRoad) >= 0.01;
    case AssetType::kCrops:
      return suburb && has(suburb_letter::kFarmland);
    case AssetType::kDesert:
      return suburb && has(suburb_letter::kBarren);
    case AssetType::kGrass:
    case AssetType::kFlower:
      return has(suburb ? suburb_letter::kGrassland : wild_letter::kGrassland);
    case AssetType::kForest:
    case AssetType::kDeadBranch:
      return has(class_letter::kForest);
    case AssetType::kLake:
      return has(class_letter::kWater);
    case AssetType::kSnowMountain:
      return !suburb && ShareOf(layout, wild_letter::kSnow) >= 0.06;  // TerrainType::kMountain
    case AssetType::kStone:
      return true;
    default:
      return false;
  }
}

// Unusual values that are legal under the coarse ones and that there are words for.
struct Choice {
  AssetType type;
  bool material;
  std::string value;
  std::string key;
};

std::vector<Choice> Choices(const SymbolicLayout& layout, const EnvironmentConfig& environment) {
  const PhraseBook& book = PhraseBook::BuiltIn();
  std::vector<Choice> choices;
  for (const auto& entry : EnumNames(AssetType{})) {
    if (!Shows(layout, entry.value)) continue;
    const FineBounds bounds = BoundsOf(environment.coarse, entry.value);
    const FineAttribute& fine = environment.fine_of(entry.value);
    const auto add = [&](const std::vector<ValueBound>& values, const std::string& usual,
                         bool material) {
      for (const ValueBound& value : values) {
        if (!value.legal() || value.name == usual) continue;
        std::string key = "fine." + std::string(entry.name) +
                          (material ? ".material." : ".season.") + std::string(value.name);
        if (!book.Has(key)) continue;
        choices.push_back({entry.value, material, std::string(value.name), std::move(key)});
      }
    };
    add(bounds.season_variants, fine.season_variant, false);
    add(bounds.materials, fine.material, true);
  }
  return choices;
}

}  // namespace

std::vector<Weather> LikelyWeathers(const SymbolicLayout& layout, TerrainType terrain,
                                    Season season) {
  std::vector<Weather> weathers = {Weather::kSunny, Weather::kCloudy, Weather::kRain,
                                   Weather::kFog};
  const bool high = terrain == TerrainType::kMountain;
  if (season == Season::kWinter || (high && season != Season::kSummer)) {
    weathers.push_back(Weather::kSnow);
  }
  const bool suburb = layout.vocabulary == Vocabulary::kSuburb;
  const double dry = suburb ? ShareOf(layout, suburb_letter::kBarren) +
                                  0.5 * ShareOf(layout, suburb_letter::kFarmland)
                            : ShareOf(layout, wild_letter::kRock);
  if (season != Season::kWinter && (dry >= 0.1 || terrain == TerrainType::kDesert)) {
    weathers.push_back(Weather::kSandstorm);
  }
  return weathers;
}

SampledEnvironment SampleEnvironment(const SymbolicLayout& layout, double size_m,
                                     RandomStream* random) {
  SampledEnvironment sample;
  EnvironmentConfig& environment = sample.environment;
  CoarseAttributes& coarse = environment.coarse;
  coarse = FitCoarse(HeardEnvironment(), layout, *Catalogue::BuiltIn());
  coarse.season = DrawAny<Season>(random);
  coarse.time_of_day = DrawAny<TimeOfDay>(random);
  coarse.artistic_style = DrawAny<ArtisticStyle>(random);
  const std::vector<Weather> weathers = LikelyWeathers(layout, coarse.terrain_type, coarse.season);
  // Snow and sandstorms, which few places allow, come up more often where they may.
  std::vector<double> weights;
  for (const Weather weather : weathers) {
    weights.push_back(weather == Weather::kSnow || weather == Weather::kSandstorm ? 2.0 : 1.0);
  }
  coarse.weather = weathers[random->Weighted(weights)];
  environment.fine = DeriveFineAttributes(coarse);
  RoundToForm(&environment);

  const int told = random->UniformInt(0, kMostTold);
  for (int i = 0; i < told; ++i) {
    std::vector<Choice> choices = Choices(layout, environment);
    choices.erase(std::remove_if(choices.begin(), choices.end(),
                                 [&](const Choice& choice) {
                                   const std::string type(NameOf(choice.type));
                                   return std::any_of(sample.told.begin(), sample.told.end(),
                                                      [&](const std::string& key) {
                                                        return StartsWith(key,
                                                                          "fine." + type + ".");
                                                      });
                                 }),
                  choices.end());
    if (choices.empty()) break;
    const Choice& choice = choices[static_cast<std::size_t>(
        random->UniformInt(0, static_cast<int>(choices.size()) - 1))];
    FineAttribute& fine = environment.fine_of(choice.type);
    (choice.material ? fine.material : fine.season_variant) = choice.value;
    sample.told.push_back(choice.key);
  }

  const int groups = random->Chance(0.15) ? 0 : random->UniformInt(1, kMostGroups);
  for (int i = 0; i < groups; ++i) {
    const auto group = DrawGroup(layout, size_m, environment.agents, random);
    if (group.has_value()) environment.agents.push_back(*group);
  }
  return sample;
}

}  // namespace latticeworld
