#include "latticeworld/language/grounded/environment/fine_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/ranges.h"

namespace latticeworld {
namespace {

constexpr std::size_t kContext = 24;  // tokens to either side that a measure can be said of
constexpr std::size_t kReach = 5;     // tokens from an adjective to its noun
constexpr double kTolerance = 0.1;    // of a measured share, to either side
constexpr double kYawTolerance_deg = 15.0;

// An adjective that waits for its noun, or looks back to it.
struct Quality {
  std::vector<const DensityWord*> densities;
  std::vector<const VariantWord*> variants;
  std::vector<const ParameterWord*> parameters;
  std::size_t first = 0;
  std::size_t last = 0;
  bool negated = false;
};

class FineReader {
 public:
  FineReader(const EnvironmentWords& words, std::vector<HeardMeasure>* measures, NotedTokens* noted,
             HeardEnvironment* heard)
      : words_(words),
        measures_(*measures),
        noted_(*noted),
        tokens_(noted->tokens),
        heard_(*heard) {}

  void Run() {
    for (std::size_t at = 0; at < tokens_.size();) {
      if (tokens_[at].kind == TokenKind::kStop) {
        waiting_.clear();
        noun_.reset();
        ++at;
      } else if (tokens_[at].kind == TokenKind::kComma || noted_.notes[at].ignored ||
                 noted_.notes[at].measure) {
        ++at;
      } else if (IsAgentNoun(at)) {
        // "many sheep" is no density.
        waiting_.clear();
        ++at;
      } else {
        at += Step(at);
      }
    }
    ReadMeasures();
  }

 private:
  bool IsAgentNoun(std::size_t at) const {
    return noted_.notes[at].agent && words_.species.LengthAt(tokens_, at) > 0;
  }

  std::size_t Step(std::size_t at) {
    const auto variant = words_.variants.At(tokens_, at);
    const auto parameter = words_.parameters.At(tokens_, at);
    const auto density = words_.densities.At(tokens_, at);
    const auto asset = words_.assets.At(tokens_, at);
    const std::size_t longest =
        std::max({variant.tokens, parameter.tokens, density.tokens, asset.tokens});
    if (longest == 0) return 1;
    if (asset.tokens < longest || longest == 1) {
      // "last light", "high over the lake": a part of a longer phrase says nothing of its own.
      const std::size_t longer = OtherPhrase(at);
      if (longer > longest) return longer;
    }
    const std::size_t end = at + longest;

    Quality quality;
    quality.first = at;
    quality.last = end;
    quality.negated = noted_.notes[at].negated;
    std::vector<AssetType> nouns;
    if (asset.tokens == longest) {
      for (const AssetWord* word : asset.rows) nouns.push_back(word->asset);
    } else if (const auto inner = AssetAtEnd(at, end);
               inner.has_value() && !noted_.IsAnyWord(at, {"of", "from", "made", "built", "out"})) {
      nouns.push_back(*inner);
    }
    bool said = false;
    if (variant.tokens == longest) {
      for (const VariantWord* word : variant.rows) {
        if (!word->alone) {
          quality.variants.push_back(word);
        } else if (!quality.negated) {
          WishVariant(*word, at, end);
          AddNoun(word->asset, &nouns);
          said = true;
        }
      }
    }
    if (parameter.tokens == longest) {
      for (const ParameterWord* word : parameter.rows) {
        if (!word->alone) {
          quality.parameters.push_back(word);
        } else if (!quality.negated) {
          WishParameter(*word, at, end);
          said = true;
        } else if (word->key == ParameterKey::kWind) {
          WishNumber(EnvironmentClaimKind::kParameter, word->asset, word->key, 0.0, 2.0,
                     std::max(2.0, word->least), at, end);
          said = true;
        }
      }
    }
    if (density.tokens == longest && !noted_.notes[at].agent) quality.densities = density.rows;
    if (!quality.negated) WishInner(at, end);
    if (said) Known(at, end);
    const bool adjective =
        !quality.densities.empty() || !quality.variants.empty() || !quality.parameters.empty();
    if (!nouns.empty()) {
      ReadNoun(nouns, said, at, end);
      if (adjective) waiting_.push_back(quality);  // "snow covered" is both
    } else if (adjective) {
      ReadQuality(std::move(quality));
    }
    return longest;
  }

  // The length of a phrase of place, weather or time that begins here.
  std::size_t OtherPhrase(std::size_t at) const {
    const std::size_t place =
        std::max(words_.RoleAt(Role::kIn, tokens_, at), words_.RoleAt(Role::kNear, tokens_, at));
    const auto coarse = words_.coarse.At(tokens_, at);
    const bool of_sky = coarse.tokens > 0 && (coarse.rows.front()->key == CoarseKey::kWeather ||
                                              coarse.rows.front()->key == CoarseKey::kTimeOfDay);
    return std::max(place, of_sky ? coarse.tokens : 0);
  }

  // "ripe maize" says that it is ripe, and that it is maize.
  void WishInner(std::size_t at, std::size_t end) {
    for (std::size_t i = at; i < end && end - at > 1; ++i) {
      const std::size_t stop = i == at ? end - 1 : end;
      const std::vector<Token> inner(tokens_.begin() + static_cast<std::ptrdiff_t>(i),
                                     tokens_.begin() + static_cast<std::ptrdiff_t>(stop));
      for (const VariantWord* word : words_.variants.At(inner, 0).rows) {
        const bool heard =
            std::any_of(heard_.fine.begin(), heard_.fine.end(), [&](const FineWish& wish) {
              return wish.claim.kind == EnvironmentClaimKind::kVariant &&
                     wish.claim.asset == word->asset && wish.claim.variant_key == word->key;
            });
        if (word->alone && !heard) WishVariant(*word, i, stop);
      }
    }
  }

  static void AddNoun(AssetType asset, std::vector<AssetType>* nouns) {
    if (std::find(nouns->begin(), nouns->end(), asset) == nouns->end()) nouns->push_back(asset);
  }

  void Known(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last && i < noted_.size(); ++i) noted_.notes[i].known = true;
  }

  // "pine forest" is a variant, and ends with a noun.
  std::optional<AssetType> AssetAtEnd(std::size_t at, std::size_t end) const {
    for (std::size_t i = at + 1; i < end; ++i) {
      const auto asset = words_.assets.At(tokens_, i);
      if (asset.tokens == end - i) return asset.rows.front()->asset;
    }
    return std::nullopt;
  }

  // ------------------------------------------------------------------ nouns and adjectives

  void ReadNoun(const std::vector<AssetType>& nouns, bool said, std::size_t at, std::size_t end) {
    bool used = said;
    const bool negated =
        noted_.notes[end - 1].negated ||
        (noted_.IsAnyWord(end, {"none", "zero", "nil"}) && noted_.IsPause(end + 1)) ||
        (end < tokens_.size() && tokens_[end].text == ":" &&
         noted_.IsAnyWord(end + 1, {"none", "zero", "nil", "no"}) && noted_.IsPause(end + 2));
    bool qualified = false;
    for (const Quality& quality : waiting_) {
      if (at > quality.last + kReach) continue;
      for (const AssetType asset : nouns) {
        if (Apply(quality, asset, quality.first, end)) {
          used = qualified = true;
          break;
        }
      }
    }
    waiting_.clear();
    if (negated && !said && !qualified && !IsOfAgents(at)) {
      // "no flowers"
      WishNumber(EnvironmentClaimKind::kDensity, nouns.front(), {}, 0.0, 0.0, 0.05, at, end);
      used = true;
    }
    if (used) Known(at, end);
    Known(at, end);
    noun_ = nouns;
    noun_end_ = end;
  }

  bool IsOfAgents(std::size_t at) const { return noted_.notes[at].place; }

  void ReadQuality(Quality quality) {
    // "the grass is sparse": of the noun before, unless its own noun follows.
    if (noun_.has_value() && !NounFollows(quality)) {
      for (const AssetType asset : *noun_) {
        if (!IsSaidOf(quality)) break;
        if (Apply(quality, asset, quality.first, quality.last)) return;
      }
    }
    waiting_.push_back(std::move(quality));
  }

  bool IsSaidOf(const Quality& quality) const { return quality.first <= noun_end_ + 2 * kReach; }

  bool NounFollows(const Quality& quality) const {
    // These are said of a noun before them only.
    if (noted_.IsAnyWord(quality.last - 1,
                         {"everywhere", "galore", "abundance", "apart", "between", "there"})) {
      return false;
    }
    for (std::size_t i = quality.last; i < quality.last + 3 && !noted_.IsPause(i); ++i) {
      if (IsAgentNoun(i)) return true;
      if (words_.RoleAt(Role::kIn, tokens_, i) > 0 || words_.RoleAt(Role::kNear, tokens_, i) > 0) {
        return false;
      }
      if (noted_.IsAnyWord(i, {"the", "a", "an", "but", "while"})) return false;
      if (words_.assets.LengthAt(tokens_, i) > 0) return true;
      const auto variant = words_.variants.At(tokens_, i);
      if (variant.tokens > 0 && variant.rows.front()->alone) return true;
      const auto coarse = words_.coarse.At(tokens_, i);
      if (coarse.tokens > 0 && coarse.rows.front()->key == CoarseKey::kWeather) return true;
    }
    return false;
  }

  // Whether the adjective can be said of the asset type; then it is.
  bool Apply(const Quality& quality, AssetType asset, std::size_t first, std::size_t last) {
    bool applied = false;
    for (const VariantWord* word : quality.variants) {
      if (word->asset != asset) continue;
      if (!quality.negated) WishVariant(*word, first, last);
      applied = true;
    }
    for (const ParameterWord* word : quality.parameters) {
      if (word->asset != asset) continue;
      if (!quality.negated) WishParameter(*word, first, last);
      applied = true;
    }
    if (!applied && !quality.densities.empty()) {
      const DensityWord& word = *quality.densities.front();
      if (!quality.negated) {
        WishNumber(EnvironmentClaimKind::kDensity, asset, {}, word.least, word.value, word.most,
                   first, last);
      } else if (word.value > 0.5) {  // "not dense"
        WishNumber(EnvironmentClaimKind::kDensity, asset, {}, 0.0, 0.35, 0.6, first, last);
      } else {  // "not sparse"
        WishNumber(EnvironmentClaimKind::kDensity, asset, {}, 0.4, 0.7, 1.0, first, last);
      }
      applied = true;
    }
    if (applied) noted_.Mark(quality.first, quality.last, &TokenNote::fine);
    return applied;
  }

  // ------------------------------------------------------------------ wishes

  void WishVariant(const VariantWord& word, std::size_t first, std::size_t last) {
    FineWish wish;
    wish.claim.kind = EnvironmentClaimKind::kVariant;
    wish.claim.asset = word.asset;
    wish.claim.variant_key = word.key;
    wish.claim.values = word.values;
    wish.claim.words = std::string(noted_.Text(first, last));
    // "autumn" and "oak" narrow each other down; "wheat and maize" leaves both.
    for (FineWish& other : heard_.fine) {
      if (!SameProperty(other.claim, wish.claim)) continue;
      std::vector<std::string> both;
      for (const std::string& value : other.claim.values) {
        if (std::find(word.values.begin(), word.values.end(), value) != word.values.end()) {
          both.push_back(value);
        }
      }
      const bool joined = first > 0 && noted_.IsAnyWord(first - 1, {"and", "or"});
      if (!both.empty()) {
        other.claim.values = both;
      } else if (joined) {
        other.claim.values.insert(other.claim.values.end(), word.values.begin(), word.values.end());
      } else {
        heard_.warnings.push_back(Quote(other.claim.words) + " and " + Quote(wish.claim.words) +
                                  " cannot both be; the last one said counts");
        other.claim.values = word.values;
        other.claim.words = wish.claim.words;
      }
      return;
    }
    heard_.fine.push_back(std::move(wish));
  }

  void WishParameter(const ParameterWord& word, std::size_t first, std::size_t last) {
    WishNumber(EnvironmentClaimKind::kParameter, word.asset, word.key, word.least, word.value,
               word.most, first, last);
  }

  void WishNumber(EnvironmentClaimKind kind, AssetType asset, ParameterKey key, double least,
                  double value, double most, std::size_t first, std::size_t last) {
    FineWish wish;
    wish.claim.kind = kind;
    wish.claim.asset = asset;
    wish.claim.parameter_key = key;
    wish.claim.least = least;
    wish.claim.most = most;
    wish.claim.words = std::string(noted_.Text(first, last));
    wish.value = value;
    Known(first, last);
    for (FineWish& other : heard_.fine) {
      if (SameProperty(other.claim, wish.claim)) {
        other = std::move(wish);
        return;
      }
    }
    heard_.fine.push_back(std::move(wish));
  }

  static bool SameProperty(const EnvironmentClaim& a, const EnvironmentClaim& b) {
    return a.kind == b.kind && a.asset == b.asset &&
           (a.kind != EnvironmentClaimKind::kVariant || a.variant_key == b.variant_key) &&
           (a.kind != EnvironmentClaimKind::kParameter || a.parameter_key == b.parameter_key);
  }

  // ------------------------------------------------------------------ measures

  void ReadMeasures() {
    measures_.erase(std::remove_if(measures_.begin(), measures_.end(),
                                   [&](const HeardMeasure& measure) { return Use(measure); }),
                    measures_.end());
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
    FindSentence(measure, &first, &last);
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
        const double speed_mps = std::clamp(measure.value, kWindRange.low, kWindRange.high);
        WishNumber(EnvironmentClaimKind::kParameter, AssetType::kDesert, ParameterKey::kWind,
                   0.9 * speed_mps, speed_mps, std::min(kWindRange.high, 1.1 * speed_mps),
                   measure.first, measure.last);
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
        // "Dead wood: 0.2"
        const bool listed = measure.first > 1 &&
                            tokens_[measure.first - 1].kind == TokenKind::kComma &&
                            tokens_[measure.first - 1].text == ":";
        const bool density = listed || Says(measure, {"density", "densities", "cover", "coverage",
                                                      "covered", "covers", "dense", "densely"});
        const auto asset = NearestAsset(measure, any);
        if (!density || !asset.has_value() || measure.value > 1.0) return false;
        WishNumber(EnvironmentClaimKind::kDensity, *asset, {},
                   std::max(0.0, measure.value - kTolerance), measure.value,
                   std::min(1.0, measure.value + kTolerance), measure.first, measure.last);
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

  bool WishScale(const HeardMeasure& measure) {
    const auto built = [](AssetType asset) { return ValuesOf(asset).has_scale; };
    const auto asset = NearestAsset(measure, built);
    if (!asset.has_value()) return false;
    const double scale = std::clamp(measure.value, kScaleRange.low, kScaleRange.high);
    WishNumber(EnvironmentClaimKind::kParameter, *asset, ParameterKey::kScale,
               std::max(kScaleRange.low, 0.9 * scale), scale,
               std::min(kScaleRange.high, 1.1 * scale), measure.first, measure.last);
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
                               "height", "high", "flooded"})) {
      return false;
    }
    level_m = std::clamp(level_m, kHeightRange.low, kHeightRange.high);
    WishNumber(EnvironmentClaimKind::kParameter, AssetType::kLake, ParameterKey::kHeight,
               std::max(kHeightRange.low, level_m - 0.25), level_m,
               std::min(kHeightRange.high, level_m + 0.25), measure.first, measure.last);
    return true;
  }

  bool WishAngle(const HeardMeasure& measure) {
    if (Says(measure, {"slope", "slopes", "steep", "steepness", "incline", "inclined", "steeper",
                       "gradient", "inclination", "faces"}) &&
        measure.value >= kSlopeRange.low) {
      const double slope_deg = std::min(measure.value, kSlopeRange.high);
      WishNumber(EnvironmentClaimKind::kParameter, AssetType::kSnowMountain, ParameterKey::kSlope,
                 std::max(kSlopeRange.low, slope_deg - 5.0), slope_deg,
                 std::min(kSlopeRange.high, slope_deg + 5.0), measure.first, measure.last);
      return true;
    }
    if (!Says(measure, {"rotated", "rotate", "rotation", "turned", "turn", "yaw", "angle",
                        "oriented", "orientation", "heading", "facing", "aligned", "rows"})) {
      return false;
    }
    const auto turns = [](AssetType asset) { return ValuesOf(asset).has_rotation; };
    const auto asset = NearestAsset(measure, turns);
    if (!asset.has_value()) return false;
    const double yaw_deg = std::fmod(std::fmod(measure.value, 360.0) + 360.0, 360.0);
    WishNumber(EnvironmentClaimKind::kParameter, *asset, ParameterKey::kRotationYaw,
               std::fmod(yaw_deg - kYawTolerance_deg + 360.0, 360.0), yaw_deg,
               std::fmod(yaw_deg + kYawTolerance_deg, 360.0), measure.first, measure.last);
    return true;
  }

  const EnvironmentWords& words_;
  std::vector<HeardMeasure>& measures_;
  NotedTokens& noted_;
  const std::vector<Token>& tokens_;
  HeardEnvironment& heard_;
  std::vector<Quality> waiting_;
  std::optional<std::vector<AssetType>> noun_;
  std::size_t noun_end_ = 0;
};

}  // namespace

void ReadFine(const EnvironmentWords& words, std::vector<HeardMeasure>* measures,
              NotedTokens* noted, HeardEnvironment* heard) {
  FineReader(words, measures, noted, heard).Run();
}

}  // namespace latticeworld
