#ifndef LATTICEWORLD_ENVIRONMENT_ATTRIBUTES_H_
#define LATTICEWORLD_ENVIRONMENT_ATTRIBUTES_H_

#include <array>
#include <cstdint>

#include "latticeworld/catalogue/season.h"
#include "latticeworld/common/enum_names.h"

namespace latticeworld {

enum class TerrainType : std::uint8_t {
  kMountain,
  kHills,
  kPlain,
  kGrassland,
  kForest,
  kDesert,
  kSuburb,
  kCoast,
  kWetland
};
enum class ArtisticStyle : std::uint8_t { kRealistic, kCartoon, kCyberpunk };
enum class Weather : std::uint8_t { kSunny, kCloudy, kRain, kSnow, kFog, kSandstorm };
enum class TimeOfDay : std::uint8_t { kDawn, kMorning, kNoon, kAfternoon, kDusk, kNight, kDay };

// The coarse attributes of y_C; they bound the fine ones.
struct CoarseAttributes {
  TerrainType terrain_type = TerrainType::kPlain;
  Season season = Season::kSummer;
  ArtisticStyle artistic_style = ArtisticStyle::kRealistic;
  Weather weather = Weather::kSunny;
  TimeOfDay time_of_day = TimeOfDay::kDay;
};

constexpr std::array<EnumName<TerrainType>, 9> EnumNames(TerrainType) {
  return {{{TerrainType::kMountain, "mountain"},
           {TerrainType::kHills, "hills"},
           {TerrainType::kPlain, "plain"},
           {TerrainType::kGrassland, "grassland"},
           {TerrainType::kForest, "forest"},
           {TerrainType::kDesert, "desert"},
           {TerrainType::kSuburb, "suburb"},
           {TerrainType::kCoast, "coast"},
           {TerrainType::kWetland, "wetland"}}};
}
constexpr std::array<EnumName<ArtisticStyle>, 3> EnumNames(ArtisticStyle) {
  return {{{ArtisticStyle::kRealistic, "realistic"},
           {ArtisticStyle::kCartoon, "cartoon"},
           {ArtisticStyle::kCyberpunk, "cyberpunk"}}};
}
constexpr std::array<EnumName<Weather>, 6> EnumNames(Weather) {
  return {{{Weather::kSunny, "sunny"},
           {Weather::kCloudy, "cloudy"},
           {Weather::kRain, "rain"},
           {Weather::kSnow, "snow"},
           {Weather::kFog, "fog"},
           {Weather::kSandstorm, "sandstorm"}}};
}
constexpr std::array<EnumName<TimeOfDay>, 7> EnumNames(TimeOfDay) {
  return {{{TimeOfDay::kDawn, "dawn"},
           {TimeOfDay::kMorning, "morning"},
           {TimeOfDay::kNoon, "noon"},
           {TimeOfDay::kAfternoon, "afternoon"},
           {TimeOfDay::kDusk, "dusk"},
           {TimeOfDay::kNight, "night"},
           {TimeOfDay::kDay, "day"}}};
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_ATTRIBUTES_H_
