#include "latticeworld/language/grounded/environment_parser.h"

#include <algorithm>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/environment_words.h"
#include "latticeworld/language/grounded/heard_attribute.h"
#include "latticeworld/language/grounded/not_understood.h"
#include "latticeworld/language/grounded/numbers.h"
#include "latticeworld/language/grounded/places.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxWords = 200;  // bytes kept of the words of one group

class EnvironmentParser {
 public:
  explicit EnvironmentParser(std::string_view instruction)
      : instruction_(instruction), tokens_(Tokenize(instruction)), unknown_(instruction) {}

  EnvironmentReading Parse() {
    while (at_ < tokens_.size()) {
      if (tokens_[at_].kind == TokenKind::kStop) {
        EndSentence();
        ++at_;
      } else if (tokens_[at_].kind == TokenKind::kComma) {
        EndPhrase();
        ++at_;
      } else {
        ReadWords();
      }
    }
    EndSentence();
    reading_.terrain_type = terrain_type_.Chosen();
    reading_.season = season_.Chosen();
    reading_.artistic_style = artistic_style_.Chosen();
    reading_.weather = weather_.Chosen();
    reading_.time_of_day = time_of_day_.Chosen();
    unknown_.AppendTo(&reading_.warnings);
    return std::move(reading_);
  }

 private:
  // Reads the longest phrase that starts here; the first of equals wins.
  void ReadWords() {
    const auto category = CategoryWords().At(tokens_, at_, true);
    const auto state = StateWords().At(tokens_, at_, false);
    const auto attribute = AttributeWords().At(tokens_, at_, true);
    const auto vague = VagueNumberWords().At(tokens_, at_, false);
    const auto density = DensityWords().At(tokens_, at_, false);
    const auto asset = AssetWords().At(tokens_, at_, true);
    const auto small = EnvironmentSmallWords().At(tokens_, at_, false);
    const NumberMatch number = MatchNumber(tokens_, at_);
    const PlaceMatch place = MatchPlace(tokens_, at_);
    const std::size_t longest =
        std::max({category.tokens, state.tokens, attribute.tokens, vague.tokens, density.tokens,
                  asset.tokens, small.tokens, number.tokens, place.tokens});
    if (longest == 0) {
      unknown_.Add(tokens_[at_].begin, tokens_[at_].end);
      ++at_;
      return;
    }
    const std::size_t end = tokens_[at_ + longest - 1].end;
    if (small.tokens < longest || *small.value != EnvironmentWord::kFunction) unknown_.Close();
    if (number.tokens == longest) {
      quantity_ = number.value;
      phrase_begin_ = std::min(phrase_begin_, tokens_[at_].begin);
    } else if (category.tokens == longest) {
      ReadCategory(*category.value, category.plural, end);
    } else if (place.tokens == longest) {
      ReadPlace(place, end);
    } else if (state.tokens == longest && SpeaksOfAgents()) {
      ReadState(*state.value, end);
    } else if (attribute.tokens == longest) {
      ReadAttribute(*attribute.value, end);
      if (asset.tokens == longest) ReadAsset(*asset.value);
    } else if (density.tokens == longest || vague.tokens == longest) {
      if (density.tokens == longest) density_ = *density.value;
      if (vague.tokens == longest) quantity_ = *vague.value;
      ReadLaterDensity();
      phrase_begin_ = std::min(phrase_begin_, tokens_[at_].begin);
    } else if (asset.tokens == longest) {
      ReadAsset(*asset.value);
    } else if (small.tokens == longest) {
      ReadSmall(*small.value);
    } else {
      ReadState(*state.value, end);
    }
    at_ += longest;
  }

  void ReadSmall(EnvironmentWord word) {
    if (word == EnvironmentWord::kNo) negated_ = true;
    if (word == EnvironmentWord::kBreak) EndPhrase();
    const std::string& text = tokens_[at_].text;
    if (text == "and" || text == "or") joined_ = true;
    if (text != "and" && text != "or" && text != "any") return;
    if (text == "and") negated_ = false;
  }

  // A state word belongs to agents named before it in this sentence or after it ("grazing sheep").
  bool SpeaksOfAgents() const {
    if (!group_.empty() || last_ >= 0) return true;
    for (std::size_t i = at_ + 1; i < std::min(tokens_.size(), at_ + 6); ++i) {
      if (tokens_[i].kind == TokenKind::kStop) return false;
      if (CategoryWords().At(tokens_, i, true).tokens > 0) return true;
    }
    return false;
  }

  void ReadCategory(const CategoryWord& word, bool plural, std::size_t end) {
    const std::string said =
        Quote(instruction_.substr(tokens_[at_].begin, end - tokens_[at_].begin));
    if (negated_) {
      quantity_ = 0;
      phrase_begin_ = std::string::npos;
      state_before_.reset();
      return;
    }
    if (!word.exact) {
      reading_.warnings.push_back("there is no " + said + "; " +
                                  std::string(NameOf(word.category)) +
                                  ", the nearest category, takes its place");
    }
    AgentWish wish;
    wish.category = word.category;
    const std::string& last_word = tokens_[at_].text;
    const bool many = plural || (last_word == "sheep" && quantity_ == 0 && !ArticleBefore()) ||
                      last_word == "people" || last_word == "wolves" || last_word == "cattle";
    wish.quantity = quantity_ > 0 ? quantity_ : many ? 3 : 1;
    wish.state = state_before_;
    wish.position = lead_;
    const std::size_t begin = std::min(phrase_begin_, tokens_[at_].begin);
    wish.words = std::string(instruction_.substr(begin, end - begin));
    if (!joined_ || GroupIsTold()) group_.clear();
    joined_ = false;
    reading_.agents.push_back(std::move(wish));
    begins_.push_back(begin);
    last_ = static_cast<int>(reading_.agents.size()) - 1;
    group_.push_back(last_);
    quantity_ = 0;
    density_ = 0.0;
    state_before_.reset();
    phrase_begin_ = std::string::npos;
  }

  bool ArticleBefore() const {
    return at_ > 0 && (tokens_[at_ - 1].text == "a" || tokens_[at_ - 1].text == "one");
  }

  // Whether the agents before have their own state or place, so that these are apart from them.
  bool GroupIsTold() const {
    return std::any_of(group_.begin(), group_.end(), [&](int index) {
      const AgentWish& wish = reading_.agents[static_cast<std::size_t>(index)];
      return wish.state.has_value() || wish.position != lead_;
    });
  }

  // The agents that a state or a place after them is said of: "sheep and horses graze".
  std::vector<int> Owners() const {
    return group_.empty() && last_ >= 0 ? std::vector<int>{last_} : group_;
  }

  AgentWish& Wish(int index) { return reading_.agents[static_cast<std::size_t>(index)]; }

  void Extend(int index, std::size_t end) {
    const std::size_t begin = begins_[static_cast<std::size_t>(index)];
    Wish(index).words = std::string(instruction_.substr(begin, std::min(end - begin, kMaxWords)));
  }

  void ReadState(AgentState state, std::size_t end) {
    if (CategoryAhead() || Owners().empty()) {
      state_before_ = state;
      phrase_begin_ = std::min(phrase_begin_, tokens_[at_].begin);
      return;
    }
    for (const int index : Owners()) {
      if (Wish(index).state.has_value() && Wish(index).state != AgentState::kIdle) continue;
      Wish(index).state = state;
      Extend(index, end);
    }
    joined_ = false;
  }

  // "five grazing sheep": the state stands right before its agents.
  bool CategoryAhead() const {
    for (std::size_t i = at_ + 1; i < std::min(tokens_.size(), at_ + 3); ++i) {
      if (CategoryWords().At(tokens_, i, true).tokens > 0) return true;
      const auto small = EnvironmentSmallWords().At(tokens_, i, false);
      if (small.tokens > 0 || MatchNumber(tokens_, i).tokens > 0 ||
          tokens_[i].kind != TokenKind::kWord) {
        return false;
      }
    }
    return false;
  }

  void ReadPlace(const PlaceMatch& place, std::size_t end) {
    const Region region = place.places.size() == 1 ? place.places.front().main : Region::kAnywhere;
    std::vector<int> owners = Owners();
    if (owners.empty()) {
      lead_ = region;
      return;
    }
    for (const int index : owners) {
      if (Wish(index).position != Region::kAnywhere && lead_ == Region::kAnywhere) continue;
      Wish(index).position = region;
      Extend(index, end);
    }
  }

  void ReadAttribute(const AttributeHint& hint, std::size_t end) {
    if (negated_) {
      negated_ = false;
      return;
    }
    const std::size_t begin = tokens_[at_].begin;
    const std::string_view words = instruction_.substr(begin, end - begin);
    // "sheep on the meadow" says where the sheep are, not what all of the land is.
    terrain_type_.Hear(hint.terrain_type, words, hint.weak || last_ >= 0, &reading_.warnings);
    season_.Hear(hint.season, words, hint.weak || hint.weather.has_value(), &reading_.warnings);
    artistic_style_.Hear(hint.artistic_style, words, hint.weak, &reading_.warnings);
    weather_.Hear(hint.weather, words, hint.weak, &reading_.warnings);
    time_of_day_.Hear(hint.time_of_day, words, hint.weak, &reading_.warnings);
  }

  void ReadAsset(AssetType type) {
    last_asset_ = type;
    if (negated_) {
      reading_.densities.emplace_back(type, 0.0);
      negated_ = false;
    } else if (density_ > 0.0) {
      reading_.densities.emplace_back(type, density_);
    }
    density_ = 0.0;
    quantity_ = 0;
  }

  // "the grass is sparse".
  void ReadLaterDensity() {
    if (!last_asset_.has_value() || density_ <= 0.0 || at_ == 0) return;
    const std::string& before = tokens_[at_ - 1].text;
    if (before != "is" && before != "are" && before != "very" && before != "grows") return;
    reading_.densities.emplace_back(*last_asset_, density_);
    density_ = 0.0;
  }

  void EndPhrase() {
    quantity_ = 0;
    density_ = 0.0;
    negated_ = false;
    joined_ = false;
    state_before_.reset();
    phrase_begin_ = std::string::npos;
    last_asset_.reset();
  }

  void EndSentence() {
    EndPhrase();
    group_.clear();
    last_ = -1;
    lead_ = Region::kAnywhere;
    unknown_.Close();
  }

  std::string_view instruction_;
  std::vector<Token> tokens_;
  NotUnderstood unknown_;
  EnvironmentReading reading_;
  std::size_t at_ = 0;
  int quantity_ = 0;
  double density_ = 0.0;
  bool negated_ = false;
  bool joined_ = false;  // "and" since the last agents
  std::optional<AgentState> state_before_;
  std::size_t phrase_begin_ = std::string::npos;
  std::vector<std::size_t> begins_;  // of each agent wish's words
  std::vector<int> group_;
  int last_ = -1;
  Region lead_ = Region::kAnywhere;
  std::optional<AssetType> last_asset_;
  HeardAttribute<TerrainType> terrain_type_;
  HeardAttribute<Season> season_;
  HeardAttribute<ArtisticStyle> artistic_style_;
  HeardAttribute<Weather> weather_;
  HeardAttribute<TimeOfDay> time_of_day_;
};

}  // namespace

EnvironmentReading ParseEnvironmentInstruction(std::string_view instruction) {
  return EnvironmentParser(instruction).Parse();
}

}  // namespace latticeworld
