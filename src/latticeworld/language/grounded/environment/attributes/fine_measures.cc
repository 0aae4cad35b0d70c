#include "latticeworld/language/grounded/environment/attributes/fine_measures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/environment/ranges.h"
#include "latticeworld/language/grounded/environment/attributes/fine_bounds.h"
#include "latticeworld/language/grounded/environment/attributes/fine_wishes.h"
#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::size_t kContext = 24;  // tokens to either side that a measure can be said of
constexpr double kTolerance = 0.1;    // of a measured share, to either side
constexpr double kYawTolerance_deg = 15.0;

class FineMeasureReader {
 public:
  FineMeasureReader(const EnvironmentWords& words, std::vector<HeardMeasure>* measures,
                    NotedTokens* noted, HeardEnvironment* heard)
      : words_(words),
        measures_(*measures),
        noted_(*noted),
        tokens_(noted->tokens),
        wishes_(noted, heard) {}

  void Run() {
    for (const HeardMeasure& measure : measures_) {
      if (measure.kind == MeasureKind::kShare && Says(measure, {"density", "densities"})) {
        ReadListedShares(measure);
      }
    }
    // The low end of a range ("20 % to 30 %") is used with the other.
    std::vector<HeardMeasure> others;
    std::size_t low_ends = 0;
    for (std::size_t i = 0; i < measures_.size(); ++i) {
      const HeardMeasure& measure = measures_[i];
      if (i + 1 < measures_.size() && IsLowEnd(measure, measures_[i + 1])) {
        others.push_back(measure);
        ++low_ends;
        continue;
      }
      if (Use(measure)) {
        others.resize(others.size() - low_ends);
      } else {
        others.push_back(measure);
      }
      low_ends = 0;
    }
    measures_ = std::move(others);
  }

 private:
  bool IsLowEnd(const HeardMeasure& low, const HeardMeasure& high) const {
    const bool kind = low.kind == high.kind || low.kind == MeasureKind::kDecimal;
    return kind && HasBounds(high.kind) && BoundsOf(words_, noted_, high).first == low.first;
  }

  static bool HasBounds(MeasureKind kind) {
    return kind == MeasureKind::kSpeed || kind == MeasureKind::kShare ||
           kind == MeasureKind::kDecimal || kind == MeasureKind::kDegrees;
  }

  // A number that is said of an asset type: within the bounds that are said with it, or else within
  // some tolerance.
  void AddMeasured(EnvironmentClaimKind kind, AssetType asset, ParameterKey key, const Range& range,
                   double low_tolerance, double high_tolerance, const HeardMeasure& measure) {
    const auto clamped = [&](double value) { return std::clamp(value, range.low, range.high); };
    double value = clamped(measure.value);
    double least = clamped(value - low_tolerance), most = clamped(value + high_tolerance);
    const MeasureBounds bounds = BoundsOf(words_, noted_, measure);
    if (bounds.IsSet()) {
      least = clamped(bounds.least.value_or(range.low));
      most = clamped(bounds.most.value_or(range.high));
      // Near the bound that is said: "up to 35 degrees" speaks of 35, too.
      value = 0.5 * (least + most);
      if (!bounds.most.has_value()) value = std::min(value, least + 0.25 * high_tolerance);
      if (!bounds.least.has_value()) value = std::max(value, most - 0.25 * low_tolerance);
    }
    wishes_.AddNumber(kind, asset, key, least, value, most, bounds.first, measure.last);
    for (std::size_t i = bounds.said; i < measure.first; ++i) noted_.notes[i].known = true;
  }

  // "4 m/s with gusts of 9 m/s": the wind is told by another measure.
  bool IsGust(const HeardMeasure& measure) const {
    constexpr std::size_t kReach = 5;
    bool gust = false;
    for (std::size_t i = measure.first; i > 0 && i + kReach > measure.first; --i) {
      if (noted_.IsPause(i - 1) || noted_.notes[i - 1].measure) break;
      gust = gust || noted_.IsAnyWord(i - 1, {"gust", "gusts", "gusting", "squalls"});
    }
    std::size_t first = 0, last = 0;
    FindSentence(measure, &first, &last);
    return gust && std::any_of(measures_.begin(), measures_.end(), [&](const HeardMeasure& other) {
             return other.kind == MeasureKind::kSpeed && other.first != measure.first &&
                    other.first >= first && other.first < last;
           });
  }

  // "Stone density at 10 percent, grass at 90, flowers 50": the unit is said once.
  void ReadListedShares(const HeardMeasure& measure) {
    for (std::size_t at = measure.last; !noted_.IsEnd(at); ++at) {
      const auto asset = words_.assets.At(tokens_, at);
      if (asset.tokens == 0) continue;
      std::size_t number_at = at + asset.tokens;
      while (noted_.IsAnyWord(number_at, {"at", "to", "is", "of", "density", ":", "="}))
        ++number_at;
      if (noted_.IsEnd(number_at) || noted_.notes[number_at].measure) continue;
      const NumberMatch number = MatchNumber(tokens_, number_at);
      const std::size_t end = number_at + number.tokens;
      if (number.tokens == 0 || number.value > 100 ||
          !(noted_.IsPause(end) || noted_.IsWord(end, "and"))) {
        continue;
      }
      const double share = number.value / 100.0;
      wishes_.AddNumber(EnvironmentClaimKind::kDensity, asset.rows.front()->asset, {},
                        std::max(0.0, share - kTolerance), share, std::min(1.0, share + kTolerance),
                        at, end);
    }
  }

  // [first, last) of the tokens of the sentence that the measure stands in.
  void FindSentence(const HeardMeasure& measure, std::size_t* first, std::size_t* last) const {
    *first = measure.first;
    while (*first > 0 && *first + kContext > measure.first &&
           tokens_[*first - 1].kind != TokenKind::kStop) {
      --*first;
    }
    *last = measure.last;
    while (*last < measure.last + kContext && !noted_.IsEnd(*last)) ++*last;
  }

  bool Says(const HeardMeasure& measure, std::initializer_list<std::string_view> any) const {
    std::size_t first = 0, last = 0;
    FindSentence(measure, &first, &last);
    for (std::size_t i = first; i < last; ++i) {
      if (noted_.IsAnyWord(i, any)) return true;
    }
    return false;
  }

  // The asset type that a measure is said of: the nearest noun of its sentence.
  std::optional<AssetType> NearestAsset(const HeardMeasure& measure,
                                        bool (*suits)(AssetType)) const {
    std::size_t first = 0, last = 0;
    // "stone at 10 %, grass at 90": the noun between the same commas before all others.
    std::size_t comma = measure.first;
    while (comma > 0 && !noted_.IsPause(comma - 1)) --comma;
    std::size_t pause = measure.last;
    while (!noted_.IsPause(pause)) ++pause;
    if (const auto own = NearestAssetIn(comma, pause, measure, suits); own.has_value()) return own;
    // "bushes about 40 percent": nothing is set for them.
    if (SaysHere(measure, {"bushes", "shrubs", "hedges", "bush"})) return std::nullopt;
    FindSentence(measure, &first, &last);
    return NearestAssetIn(first, last, measure, suits);
  }

  std::optional<AssetType> NearestAssetIn(std::size_t first, std::size_t last,
                                          const HeardMeasure& measure,
                                          bool (*suits)(AssetType)) const {
    std::optional<AssetType> nearest;
    std::size_t least = tokens_.size() + 1;
    std::size_t next = first;
    for (std::size_t i = first; i < last; i = next) {
      next = i + 1;
      std::vector<AssetType> assets;
      const auto named = words_.assets.At(tokens_, i);
      for (const AssetWord* word : named.rows) assets.push_back(word->asset);
      next = std::max(next, i + named.tokens);
      for (const VariantWord* word : words_.variants.At(tokens_, i).rows) {
        if (word->alone) assets.push_back(word->asset);
      }
      for (const AssetType asset : assets) {
        const std::size_t apart = i < measure.first ? measure.first - i : i - measure.last + 1;
        if (!suits(asset) || apart >= least) continue;
        least = apart;
        nearest = asset;
      }
    }
    return nearest;
  }

  bool Use(const HeardMeasure& measure) {
    const auto any = [](AssetType) { return true; };
    switch (measure.kind) {
      case MeasureKind::kSpeed: {
        if (!Says(measure, {"wind", "winds", "breeze", "gale", "storm", "sandstorm", "blows",
                            "blowing", "gusts", "force", "beaufort", "bft", "air", "windy"})) {
          return false;
        }
        if (IsGust(measure)) return true;
        const double tolerance_mps = 0.1 * std::min(measure.value, kWindRange.high);
        AddMeasured(EnvironmentClaimKind::kParameter, AssetType::kDesert, ParameterKey::kWind,
                    kWindRange, tolerance_mps, tolerance_mps, measure);
        return true;
      }
      case MeasureKind::kShare:
      case MeasureKind::kDecimal: {
        const bool scale =
            measure.kind == MeasureKind::kDecimal && Says(measure, {"scale", "scaled", "size"});
        if (scale || (measure.kind == MeasureKind::kShare &&
                      Says(measure, {"scale", "scaled", "size", "sized", "shrink", "shrunk",
                                     "enlarge", "enlarged"}))) {
          return WishScale(measure);
        }
        // "houses 50 % bigger"
        const bool bigger = noted_.IsAnyWord(Behind(measure), {"bigger", "larger", "taller"});
        const bool smaller = noted_.IsAnyWord(Behind(measure), {"smaller", "shorter"});
        if (measure.kind == MeasureKind::kShare && (bigger || smaller)) {
          HeardMeasure factor = measure;
          factor.value = bigger ? 1.0 + measure.value : std::max(0.0, 1.0 - measure.value);
          return WishScale(factor);
        }
        // "Dead wood: 0.2"
        const bool listed = measure.first > 1 &&
                            tokens_[measure.first - 1].kind == TokenKind::kComma &&
                            tokens_[measure.first - 1].text == ":";
        const bool density = listed ||
                             Says(measure, {"density", "densities", "cover", "coverage", "covered",
                                            "covers", "dense", "densely"}) ||
                             IsShareOfPlants(measure);
        const auto asset = NearestAsset(measure, any);
        if (!density || !asset.has_value() || measure.value > 1.0) return false;
        AddMeasured(EnvironmentClaimKind::kDensity, *asset, {}, {0.0, 1.0}, kTolerance, kTolerance,
                    measure);
        return true;
      }
      case MeasureKind::kFactor:
        return WishScale(measure);
      case MeasureKind::kLength:
        return WishLevel(measure);
      case MeasureKind::kDegrees:
        return WishAngle(measure);
      default:
        return false;
    }
  }

  // The token behind the measure and its "%", which is a word of its own.
  std::size_t Behind(const HeardMeasure& measure) const {
    return measure.last + (noted_.IsWord(measure.last, "percent") ? 1 : 0);
  }

  // "60 % flowers", "flowers 60 %": a share right beside what grows; "40 % forest" is a share of
  // the land, which the layout has.
  bool IsShareOfPlants(const HeardMeasure& measure) const {
    if (measure.kind != MeasureKind::kShare) return false;
    const std::size_t behind = Behind(measure);
    const auto after = words_.assets.At(tokens_, behind);
    const std::size_t end = behind + after.tokens;
    const auto grows = [](const auto& match) {
      return match.tokens > 0 && (match.rows.front()->asset == AssetType::kFlower ||
                                  match.rows.front()->asset == AssetType::kDeadBranch);
    };
    if (grows(after) && (noted_.IsPause(end) || noted_.IsWord(end, "and"))) return true;
    std::size_t before = measure.first;
    while (before > 0 && noted_.IsAnyWord(before - 1, {"about", "around", "at", "least", "most",
                                                       "roughly", "than", "more", "less", "over",
                                                       "under", "approximately", "to", "up"})) {
      --before;
    }
    const bool ends = noted_.IsPause(behind) || noted_.IsWord(behind, "and");
    return ends && before > 0 && grows(words_.assets.At(tokens_, before - 1));
  }

  bool WishScale(const HeardMeasure& measure) {
    const auto built = [](AssetType asset) { return ValuesOf(asset).has_scale; };
    const auto asset = NearestAsset(measure, built);
    if (!asset.has_value()) return false;
    const double tolerance = 0.1 * std::clamp(measure.value, kScaleRange.low, kScaleRange.high);
    AddMeasured(EnvironmentClaimKind::kParameter, *asset, ParameterKey::kScale, kScaleRange,
                tolerance, tolerance, measure);
    return true;
  }

  // "the lake lies two metres lower"
  bool WishLevel(const HeardMeasure& measure) {
    const auto watery = [](AssetType asset) { return ValuesOf(asset).has_height; };
    if (!NearestAsset(measure, watery).has_value()) return false;
    double level_m = measure.value;
    if (level_m < 0.0) {
      // "lake -1.5 m"
    } else if (Says(measure, {"below", "lower", "lowered", "under", "beneath", "down", "fallen",
                              "dropped", "sunk", "sunken", "less", "receded", "drop", "drops",
                              "fall", "falls", "shrunk", "minus"})) {
      level_m = -std::abs(level_m);
    } else if (!Says(measure, {"above", "higher", "raised", "over", "up", "level", "risen",
                               "height", "high", "flooded", "plus", "raise"})) {
      return false;
    }
    level_m = std::clamp(level_m, kHeightRange.low, kHeightRange.high);
    wishes_.AddNumber(EnvironmentClaimKind::kParameter, AssetType::kLake, ParameterKey::kHeight,
                      std::max(kHeightRange.low, level_m - 0.25), level_m,
                      std::min(kHeightRange.high, level_m + 0.25), measure.first, measure.last);
    return true;
  }

  // Whether the words between the same commas as the measure are among `any`.
  bool SaysHere(const HeardMeasure& measure, std::initializer_list<std::string_view> any) const {
    std::size_t first = measure.first;
    while (first > 0 && !noted_.IsPause(first - 1)) --first;
    for (; first < measure.last || !noted_.IsPause(first); ++first) {
      if (noted_.IsAnyWord(first, any)) return true;
    }
    return false;
  }

  bool WishAngle(const HeardMeasure& measure) {
    const auto slopes = {"slope"sv,    "slopes"sv,  "steep"sv,    "steepness"sv,   "incline"sv,
                         "inclined"sv, "steeper"sv, "gradient"sv, "inclination"sv, "faces"sv};
    const auto turns_said = {"rotated"sv, "rotate"sv,  "rotation"sv, "turned"sv,      "turn"sv,
                             "yaw"sv,     "angle"sv,   "oriented"sv, "orientation"sv, "heading"sv,
                             "facing"sv,  "aligned"sv, "rows"sv};
    // "slope 30 degrees, houses turned by 20 degrees": each angle is that of its own clause.
    const bool turned = SaysHere(measure, turns_said) && !SaysHere(measure, slopes);
    if (!turned && Says(measure, slopes) && measure.value >= kSlopeRange.low) {
      AddMeasured(EnvironmentClaimKind::kParameter, AssetType::kSnowMountain, ParameterKey::kSlope,
                  kSlopeRange, 5.0, 5.0, measure);
      return true;
    }
    if (!Says(measure, turns_said)) return false;
    const auto turns = [](AssetType asset) { return ValuesOf(asset).has_rotation; };
    const auto asset = NearestAsset(measure, turns);
    if (!asset.has_value()) return false;
    const double yaw_deg = std::fmod(std::fmod(measure.value, 360.0) + 360.0, 360.0);
    wishes_.AddNumber(EnvironmentClaimKind::kParameter, *asset, ParameterKey::kRotationYaw,
                      std::fmod(yaw_deg - kYawTolerance_deg + 360.0, 360.0), yaw_deg,
                      std::fmod(yaw_deg + kYawTolerance_deg, 360.0), measure.first, measure.last);
    return true;
  }

  const EnvironmentWords& words_;
  std::vector<HeardMeasure>& measures_;
  NotedTokens& noted_;
  const std::vector<Token>& tokens_;
  FineWishes wishes_;
};

}  // namespace

void ReadFineMeasures(const EnvironmentWords& words, std::vector<HeardMeasure>* measures,
                      NotedTokens* noted, HeardEnvironment* heard) {
  FineMeasureReader(words, measures, noted, heard).Run();
}

}  // namespace latticeworld
