#include "latticeworld/language/grounded/environment/attributes/fine_reader.h"

#include <algorithm>
#include <optional>

#include "latticeworld/language/grounded/environment/attributes/fine_measures.h"
#include "latticeworld/language/grounded/environment/attributes/fine_wishes.h"
#include "latticeworld/language/grounded/environment/loose_phrase.h"
#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace {

constexpr std::size_t kReach = 5;  // tokens from an adjective to its noun

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
  FineReader(const EnvironmentWords& words, NotedTokens* noted, HeardEnvironment* heard)
      : words_(words), noted_(*noted), tokens_(noted->tokens), wishes_(noted, heard) {}

  void Run() {
    for (std::size_t at = 0; at < tokens_.size();) {
      if (tokens_[at].kind == TokenKind::kStop) {
        waiting_.clear();
        ForgetList();
        noun_.reset();
        ++at;
      } else if (tokens_[at].kind == TokenKind::kComma || noted_.notes[at].ignored ||
                 noted_.notes[at].measure) {
        ++at;
      } else if (noted_.IsAnyWord(at,
                                  {"bushes", "shrubs", "hedges", "bush", "puddles", "puddle"})) {
        // Nothing is set for them: what is said of them is said of nothing else.
        waiting_.clear();
        noun_.reset();
        while (!noted_.IsPause(at) && !noted_.IsWord(at, "and")) ++at;
      } else if (IsAgentNoun(at)) {
        // "many sheep" is no density.
        waiting_.clear();
        ++at;
      } else {
        at += Step(at);
      }
    }
  }

 private:
  bool IsAgentNoun(std::size_t at) const {
    return noted_.notes[at].agent && words_.species.LengthAt(tokens_, at) > 0;
  }

  std::size_t Step(std::size_t at) {
    if (const std::size_t cover = ReadCover(at); cover > 0) return cover;
    const auto variant = VariantAt(at);
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
               inner.has_value() &&
               !noted_.IsAnyWord(at, {"of", "from", "made", "built", "out", "in", "covered",
                                      "buried", "white", "dusted", "under"})) {
      nouns.push_back(*inner);
    }
    bool said = false;
    if (variant.tokens == longest) {
      const bool of_noun = IsOfNoun(variant.rows, at) || IsOfNextNoun(variant.rows, end);
      for (const VariantWord* word : variant.rows) {
        if (!word->alone) {
          quality.variants.push_back(word);
        } else if (!quality.negated && !of_noun) {
          wishes_.AddVariant(*word, at, end);
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
          wishes_.AddParameter(*word, at, end);
          said = true;
        } else if (word->key == ParameterKey::kWind) {
          wishes_.AddNumber(EnvironmentClaimKind::kParameter, word->asset, word->key, 0.0, 2.0,
                            std::max(2.0, word->least), at, end);
          said = true;
        }
      }
    }
    // "it is not snowing any more", "no more than 30 degrees" speak of no density.
    const bool more =
        noted_.IsWord(at, "more") && ((at > 0 && (noted_.IsAnyWord(at - 1, {"any", "no", "not"}) ||
                                                  MatchNumber(tokens_, at - 1).tokens > 0)) ||
                                      noted_.IsAnyWord(at + 1, {"than", "or"}));
    if (density.tokens == longest && !noted_.notes[at].agent && !noted_.notes[at].place && !more) {
      quality.densities = density.rows;
    }
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

  // "the dead branches should be pine": whatever else the word says by itself.
  bool IsOfNoun(const std::vector<const VariantWord*>& rows, std::size_t at) const {
    constexpr std::size_t kLink = 4;
    if (!noun_.has_value() || at <= noun_end_ || at > noun_end_ + kLink) return false;
    bool linked = false;
    for (std::size_t i = noun_end_; i < at; ++i) {
      if (noted_.IsAnyWord(i, {"is", "are", "be", "of", "from"})) linked = true;
      if (noted_.IsPause(i) && tokens_[i].text != ":") return false;
      linked = linked || tokens_[i].text == ":";
    }
    return linked && std::any_of(rows.begin(), rows.end(), [&](const VariantWord* word) {
             return !word->alone &&
                    std::find(noun_->begin(), noun_->end(), word->asset) != noun_->end();
           });
  }

  // "birch branches": no birches stand there.
  bool IsOfNextNoun(const std::vector<const VariantWord*>& rows, std::size_t end) const {
    const auto noun = words_.assets.At(tokens_, end);
    return noun.tokens > 0 && std::any_of(rows.begin(), rows.end(), [&](const VariantWord* word) {
             return !word->alone && word->asset == noun.rows.front()->asset;
           });
  }

  // "moss growing on the bark" is "moss on the bark".
  WordTable<VariantWord>::Match VariantAt(std::size_t at) const {
    return LoosePhraseAt(words_.variants, noted_, at,
                         [this](std::size_t i) { return IsFiller(i); });
  }

  bool IsFiller(std::size_t at) const {
    return noted_.IsAnyWord(
        at,
        {"growing", "lying",      "standing", "only",   "just",    "now",    "still",  "already",
         "all",     "completely", "entirely", "fully",  "totally", "mostly", "very",   "quite",
         "really",  "rather",     "been",     "almost", "nearly",  "deeply", "freshly"});
  }

  // "snow still lies on the road", "moss covers the rocks": the road is "snow covered".
  std::size_t ReadCover(std::size_t at) {
    constexpr std::size_t kReach_tokens = 4;  // from what covers to the word that says so
    if (noted_.notes[at].negated || !noted_.IsAnyWord(at, {"snow", "moss", "ice", "frost", "leaves",
                                                           "mud", "sand", "dust", "lichen"})) {
      return 0;
    }
    std::size_t next = at + 1;
    while (next < at + 1 + kReach_tokens &&
           (IsFiller(next) || noted_.IsAnyWord(next, {"lies", "is", "has", "left", "there", "grows",
                                                      "deep", "thick", "thickly", "everywhere"}))) {
      ++next;
    }
    if (!noted_.IsAnyWord(next, {"on", "upon", "over", "covers", "covering", "coats", "coating",
                                 "blankets", "blanketing", "carpets", "hides", "buries"})) {
      return 0;
    }
    ++next;
    while (noted_.IsAnyWord(next, {"the", "all", "its", "their", "every", "each", "of", "both"})) {
      ++next;
    }
    const auto asset = words_.assets.At(tokens_, next);
    if (asset.tokens == 0) return 0;
    Token covered = tokens_[at];
    covered.text = "covered";
    const std::vector<Token> phrase = {tokens_[at], covered};
    const auto match = words_.variants.At(phrase, 0);
    if (match.tokens < 2) return 0;
    const std::size_t end = next + asset.tokens;
    for (const VariantWord* word : match.rows) {
      if (word->alone || word->asset != asset.rows.front()->asset) continue;
      wishes_.AddVariant(*word, at, end);
      Known(at, end);
      noun_ = {word->asset};
      noun_end_ = end;
      return end - at;
    }
    return 0;
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
        if (word->alone && !wishes_.HasVariant(*word)) wishes_.AddVariant(*word, i, stop);
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
    const bool joined = IsJoined(at);
    if (!joined || told_) listed_.clear();
    if (joined && !told_ && opens_) listed_.push_back(*noun_);
    if (!joined) shared_.reset();
    opens_ = joined ? opens_ || told_ : OpensClause(at);
    std::optional<Quality> own;  // that is said of the noun
    const bool negated =
        noted_.notes[end - 1].negated ||
        (noted_.IsAnyWord(end, {"none", "zero", "nil"}) && noted_.IsPause(end + 1)) ||
        (noted_.IsAnyWord(end, {":", "-"}) &&
         noted_.IsAnyWord(end + 1, {"none", "zero", "nil", "no"}) && noted_.IsPause(end + 2));
    bool qualified = false;
    for (const Quality& quality : waiting_) {
      if (at > quality.last + kReach && !IsForList(quality)) continue;
      // "thick, no flowers" is not said of the flowers, nor "the sheep are scattered all over the
      // fields" of the fields.
      if (negated && !quality.negated) continue;
      if (IsOfAgents(at) && at > quality.last + 1) continue;
      for (const AssetType asset : nouns) {
        if (Apply(quality, asset, quality.first, end)) {
          used = qualified = true;
          own = quality;
          break;
        }
      }
    }
    waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(),
                                  [&](const Quality& quality) { return !IsForList(quality); }),
                   waiting_.end());
    // "weather: not snow", "instead of snow let it rain" speak of the weather alone.
    const bool weather =
        tokens_[at].text == "snow" && at > 0 &&
        ((at > 1 && (noted_.IsAnyWord(at - 2, {"instead", "weather"}))) ||
         (at > 2 && (noted_.IsWord(at - 3, "instead") || noted_.IsWord(at - 3, "weather"))));
    if (negated && !said && !qualified && !weather && !IsOfAgents(at)) {
      // "no flowers"
      wishes_.AddNumber(EnvironmentClaimKind::kDensity, nouns.front(), {}, 0.0, 0.0, 0.05, at, end);
      used = true;
    }
    if (used) Known(at, end);
    if (own.has_value()) {
      shared_ = own->last == at && IsSharable(*own) ? own : std::nullopt;
    } else if (shared_.has_value() && (said || negated || !IsShared(at, end) ||
                                       !Apply(*shared_, nouns.front(), shared_->first, end))) {
      shared_.reset();
    }
    Known(at, end);
    told_ = qualified || negated || said || IsOfAgents(at);
    noun_ = nouns;
    noun_end_ = end;
  }

  void ForgetList() {
    listed_.clear();
    shared_.reset();
    told_ = false;
  }

  // "(both) the grass and the flowers are", but "there is grass and the flowers are".
  bool OpensClause(std::size_t at) const {
    while (at > 0 && noted_.IsAnyWord(at - 1, {"the", "both", "all", "its", "our"})) --at;
    return at == 0 || noted_.IsPause(at - 1) ||
           noted_.IsAnyWord(at - 1, {"and", "but", "let", "make", "want", "that", "where"});
  }

  // "grass and (flowers)", "the grass, the (flowers)": whether only that is between the nouns.
  bool IsJoined(std::size_t at) const {
    if (!noun_.has_value() || noun_end_ >= at) return false;
    bool joint = false;
    for (std::size_t i = noun_end_; i < at; ++i) {
      const bool comma = tokens_[i].text == ",";
      joint = joint || comma || noted_.IsWord(i, "and");
      if (!comma && !noted_.IsAnyWord(i, {"and", "the", "also", "as", "well", "all", "its"})) {
        return false;
      }
    }
    return joint;
  }

  // An adjective of density that may be said of all nouns of a list: "dense grass and flowers".
  bool IsSharable(const Quality& quality) const {
    return !quality.densities.empty() && !quality.negated && quality.variants.empty() &&
           quality.parameters.empty() &&
           noted_.IsAnyWord(quality.last - 1, {"dense", "sparse", "thick", "thin", "scattered",
                                               "patchy", "abundant", "plentiful", "moderate",
                                               "luxuriant", "few", "many", "numerous", "of"});
  }

  // Whether the noun of tokens [at, end) is one that grows or lies about, at the end of a list or
  // on the way there, with nothing else said of it: "dense (trees), grass and flowers".
  bool IsShared(std::size_t at, std::size_t end) const {
    if (!noted_.IsAnyWord(at - 1, {"and", ","}) ||
        words_.assets.LengthAt(tokens_, at) != end - at) {
      return false;
    }
    if (!noted_.IsAnyWord(at, {"grass", "grasses", "flower", "flowers", "wildflowers", "tree",
                               "trees", "stone", "stones", "rock", "rocks", "boulders", "branches",
                               "twigs", "logs", "forest", "woodland", "undergrowth"})) {
      return false;
    }
    // "few stones and grass": of grass there are not few.
    const std::string& name = tokens_[at].text;
    const bool counts = noted_.IsAnyWord(shared_->last - 1, {"few", "many", "numerous"});
    if (counts && (name == "grass" || name.back() != 's')) return false;
    std::size_t next = end;
    for (bool last = noted_.IsWord(at - 1, "and"); !last;) {
      // In a list with commas, only "and" is the end.
      if (next < tokens_.size() && tokens_[next].text == ",") ++next;
      last = noted_.IsWord(next, "and");
      const std::size_t noun_at = next + (last ? 1 : 0);
      const std::size_t noun =
          noun_at < tokens_.size() ? words_.assets.LengthAt(tokens_, noun_at) : 0;
      if (noun == 0) return false;
      next = noun_at + noun;
    }
    return noted_.IsPause(next) ||
           noted_.IsAnyWord(next, {"and", "in", "on", "everywhere", "with", "around", "across",
                                   "over", "along", "near", "by", "at", "please"});
  }

  // Whether the quality is said of all nouns of a list: "(grass and flowers) are dense".
  bool IsOfList(const Quality& quality) const {
    bool plural = false;
    for (std::size_t i = noun_end_; i < quality.first; ++i) {
      plural = plural || noted_.IsAnyWord(i, {"are", "should", "must", "be", ":", "grow", "stand"});
      if (!noted_.IsAnyWord(i, {"are", "should", "must", "be", ":", "both", "all", "grow", "stand",
                                "very", "quite", "rather", "really", "equally", "also", "to"})) {
        return false;
      }
    }
    return plural;
  }

  // "covered in snow: the fields, the road, the roofs"
  bool IsForList(const Quality& quality) const {
    return quality.last < tokens_.size() && tokens_[quality.last].text == ":";
  }

  bool IsOfAgents(std::size_t at) const { return noted_.notes[at].place; }

  void ReadQuality(Quality quality) {
    // "the grass is sparse": of the noun before, unless its own noun follows.
    if (noun_.has_value() && !NounFollows(quality)) {
      for (const AssetType asset : *noun_) {
        if (!IsSaidOf(quality)) break;
        if (!Apply(quality, asset, quality.first, quality.last)) continue;
        if (IsOfList(quality)) {
          for (const std::vector<AssetType>& others : listed_) {
            for (const AssetType other : others) {
              if (Apply(quality, other, quality.first, quality.last)) break;
            }
          }
        }
        told_ = true;
        noun_end_ = std::max(noun_end_, quality.last);  // "..., and plenty of it"
        return;
      }
    }
    waiting_.push_back(std::move(quality));
  }

  bool IsSaidOf(const Quality& quality) const {
    // "on the road although the sky is clear": of the sky.
    for (std::size_t i = noun_end_; i < quality.first; ++i) {
      if (noted_.IsAnyWord(i, {"sky", "skies", "weather", "air", "sun", "moon", "night", "day"})) {
        return false;
      }
    }
    return quality.first <= noun_end_ + 2 * kReach;
  }

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
      if (!quality.negated) wishes_.AddVariant(*word, first, last);
      applied = true;
    }
    for (const ParameterWord* word : quality.parameters) {
      if (word->asset != asset) continue;
      if (!quality.negated) wishes_.AddParameter(*word, first, last);
      applied = true;
    }
    if (!applied && !quality.densities.empty()) {
      const DensityWord& word = *quality.densities.front();
      if (!quality.negated) {
        wishes_.AddNumber(EnvironmentClaimKind::kDensity, asset, {}, word.least, word.value,
                          word.most, first, last);
      } else if (word.value > 0.5) {  // "not dense"
        wishes_.AddNumber(EnvironmentClaimKind::kDensity, asset, {}, 0.0, 0.35, 0.6, first, last);
      } else {  // "not sparse"
        wishes_.AddNumber(EnvironmentClaimKind::kDensity, asset, {}, 0.4, 0.7, 1.0, first, last);
      }
      applied = true;
    }
    if (applied) noted_.Mark(quality.first, quality.last, &TokenNote::fine);
    return applied;
  }

  const EnvironmentWords& words_;
  NotedTokens& noted_;
  const std::vector<Token>& tokens_;
  FineWishes wishes_;
  std::vector<Quality> waiting_;
  std::optional<std::vector<AssetType>> noun_;
  std::size_t noun_end_ = 0;
  bool told_ = false;                           // something is said of the noun already
  bool opens_ = false;                          // its list opens a clause
  std::vector<std::vector<AssetType>> listed_;  // the nouns that noun_ is joined to
  std::optional<Quality> shared_;               // what is said of the nouns of a list before them
};

}  // namespace

void ReadFine(const EnvironmentWords& words, std::vector<HeardMeasure>* measures,
              NotedTokens* noted, HeardEnvironment* heard) {
  FineReader(words, noted, heard).Run();
  ReadFineMeasures(words, measures, noted, heard);
}

}  // namespace latticeworld
