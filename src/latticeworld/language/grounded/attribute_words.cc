#include "latticeworld/language/grounded/environment_words.h"

namespace latticeworld {
namespace {

AttributeHint Of(TerrainType terrain_type) { return {terrain_type, {}, {}, {}, {}, false}; }
AttributeHint Of(Season season) { return {{}, season, {}, {}, {}, false}; }
AttributeHint Of(ArtisticStyle style) { return {{}, {}, style, {}, {}, false}; }
AttributeHint Of(Weather weather) { return {{}, {}, {}, weather, {}, false}; }
AttributeHint Of(TimeOfDay time) { return {{}, {}, {}, {}, time, false}; }
AttributeHint Hint(AttributeHint hint) {
  hint.weak = true;
  return hint;
}
AttributeHint Both(Season season, Weather weather) { return {{}, season, {}, weather, {}, false}; }

}  // namespace

const PhraseTable<AttributeHint>& AttributeWords() {
  static const PhraseTable<AttributeHint> table({
      // Terrain type
      {Of(TerrainType::kMountain),
       {"mountain", "mountainous", "alpine", "peak", "alps", "mountain range", "summit",
        "highlands"}},
      {Of(TerrainType::kHills), {"hill", "hilly", "rolling hills", "foothill", "hilly terrain"}},
      {Of(TerrainType::kPlain), {"plain", "flatland", "lowland", "open plain", "farm country"}},
      {Of(TerrainType::kGrassland),
       {"grassland", "meadow", "pasture", "prairie", "steppe", "savanna", "savannah",
        "grazing land"}},
      {Hint(Of(TerrainType::kForest)),
       {"forest", "woodland", "woods", "jungle", "taiga", "rainforest", "forested"}},
      {Of(TerrainType::kDesert), {"desert", "dune", "sand dune", "arid", "wasteland", "sahara"}},
      {Hint(Of(TerrainType::kSuburb)),
       {"suburb", "suburban", "town", "village", "neighbourhood", "neighborhood", "residential",
        "city", "urban", "outskirts"}},
      {Of(TerrainType::kCoast), {"coast", "coastal", "seaside", "shoreline", "beach", "oceanside"}},
      {Of(TerrainType::kWetland),
       {"wetland", "swamp", "marsh", "bog", "fen", "marshland", "swampy", "marshy"}},
      // Season
      {Of(Season::kSpring),
       {"spring", "springtime", "march", "april", "may", "blossom", "blossoming",
        "blooming flowers", "cherry blossom", "easter", "budding trees", "vernal",
        "flowers bloom"}},
      {Of(Season::kSummer),
       {"summer", "summertime", "june", "july", "august", "midsummer", "summery", "heat wave",
        "heatwave", "harvest time"}},
      {Of(Season::kAutumn),
       {"autumn",        "autumnal",      "fall season",        "september",        "october",
        "november",      "golden leaves", "falling leaves",     "fallen leaves",    "red leaves",
        "yellow leaves", "orange leaves", "colorful leaves",    "colourful leaves", "brown leaves",
        "harvest",       "late fall",     "early fall",         "in fall",          "in the fall",
        "fall colors",   "fall colours",  "fall foliage",       "fall day",         "fall morning",
        "fall evening",  "leaves turn",   "leaves are turning", "halloween"}},
      {Of(Season::kWinter), {"winter",       "wintertime", "december",  "january",
                             "february",     "midwinter",  "wintry",    "christmas",
                             "frost",        "frosty",     "icy",       "frozen lake",
                             "bare trees",   "freezing",   "hoarfrost", "snow on the ground",
                             "snow covered", "deep snow",  "snowbound", "frozen"}},
      // Weather
      {Of(Weather::kSunny),
       {"sunny", "sunshine", "clear", "clear sky", "clear skies", "blue sky", "blue skies",
        "bright sun", "cloudless", "clear weather", "sunlit", "clear day", "fair weather",
        "sun shines", "sun is shining", "fine weather", "bright day", "sunlight", "good weather"}},
      {Of(Weather::kCloudy),
       {"cloudy", "overcast", "grey sky", "gray sky", "clouds", "cloud", "gloomy", "grey skies",
        "dull weather", "gray skies", "partly cloudy", "clouded", "leaden sky"}},
      {Of(Weather::kRain),
       {"rain",       "rainy",        "raining", "drizzle",  "drizzling", "shower",
        "storm",      "thunderstorm", "stormy",  "downpour", "pouring",   "heavy rain",
        "light rain", "thunder",      "rains",   "monsoon",  "rainfall",  "wet weather",
        "thundery",   "lightning",    "pours",   "rainstorm"}},
      {Both(Season::kWinter, Weather::kSnow),
       {"snow", "snowfall", "snowing", "snowy", "blizzard", "snowstorm", "snowflake", "snows",
        "flurry", "heavy snow", "light snow", "falling snow", "snow falls", "sleet"}},
      {Of(Weather::kFog),
       {"fog", "foggy", "mist", "misty", "haze", "hazy", "light fog", "thick fog", "dense fog",
        "light mist", "low visibility", "heavy fog", "morning mist", "shrouded in mist", "fog bank",
        "thick mist", "dense mist"}},
      {Of(Weather::kSandstorm),
       {"sandstorm", "dust storm", "sand storm", "duststorm", "blowing sand"}},
      // Time of day
      {Of(TimeOfDay::kDawn),
       {"dawn", "sunrise", "daybreak", "first light", "break of day", "sun rises",
        "crack of dawn"}},
      {Of(TimeOfDay::kMorning),
       {"morning", "forenoon", "early morning", "late morning", "breakfast time", "mid morning"}},
      {Of(TimeOfDay::kNoon),
       {"noon", "midday", "high noon", "lunchtime", "noontime", "twelve o clock"}},
      {Of(TimeOfDay::kAfternoon), {"afternoon", "late afternoon", "early afternoon", "teatime"}},
      {Of(TimeOfDay::kDusk),
       {"dusk", "sunset", "twilight", "evening", "sundown", "nightfall", "golden hour", "sun sets",
        "early evening", "setting sun", "late evening", "gloaming"}},
      {Of(TimeOfDay::kNight),
       {"night", "midnight", "moonlight", "moonlit", "starry", "nighttime", "starlit", "at night",
        "full moon", "under the stars", "dead of night", "moon", "starlight", "nocturnal",
        "night sky"}},
      {Hint(Of(TimeOfDay::kDay)), {"daytime", "day", "daylight", "broad daylight"}},
      // Style
      {Of(ArtisticStyle::kRealistic),
       {"realistic", "photorealistic", "photo realistic", "natural style", "realism", "lifelike"}},
      {Of(ArtisticStyle::kCartoon),
       {"cartoon", "cartoonish", "cartoony", "toon", "comic", "comic style", "stylized", "stylised",
        "anime", "cel shaded"}},
      {Of(ArtisticStyle::kCyberpunk),
       {"cyberpunk", "neon", "futuristic", "sci fi", "science fiction", "dystopian", "neon lit"}},
  });
  return table;
}

}  // namespace latticeworld
