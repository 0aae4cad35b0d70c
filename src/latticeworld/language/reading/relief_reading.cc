#include "latticeworld/language/reading/relief_reading.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/reading/relief_words.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

using Words = std::initializer_list<std::string_view>;

bool IsIn(std::string_view word, Words words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// A relief noun or adjective in a sentence.
struct Mention {
  ReliefKind kind = ReliefKind::kHill;
  std::size_t begin = 0;  // tokens
  std::size_t end = 0;
  const ClassWord* noun = nullptr;  // that the layout knows it by, or none
  bool plural = false;
  int wish = -1;
};

// Another thing in the same sentence.
struct OtherThing {
  const ClassWord* noun = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
};

class ReliefReader {
 public:
  explicit ReliefReader(LayoutReading* reading) : plan_(reading->plan) {}

  void Read(const std::string& sentence) {
    sentence_ = sentence;
    tokens_ = Tokenize(sentence);
    mentions_.clear();
    others_.clear();
    FindMentions();
    bool read = ReadRise();
    for (std::size_t i = 0; i < mentions_.size(); ++i) {
      Resolve(&mentions_[i]);
      if (mentions_[i].wish < 0) continue;
      ReadAttributes(i);
      ReadTies(mentions_[i]);
      read = true;
    }
    if (!read) return;
    TakeOffWarnings();
    quotes_.push_back(Trimmed());
  }

  void Finish() {
    AddFeatures();
    for (ReliefWish& wish : plan_.reliefs) Settle(&wish);
    TakeOffNotUnderstood();
  }

  // The sentences that say something of relief.
  const std::vector<std::string>& quotes() const { return quotes_; }

 private:
  std::string_view Word(std::size_t at) const {
    return at < tokens_.size() && tokens_[at].kind == TokenKind::kWord
               ? std::string_view(tokens_[at].text)
               : std::string_view();
  }
  ReliefWish& WishOf(const Mention& mention) {
    return plan_.reliefs[static_cast<std::size_t>(mention.wish)];
  }

  void FindMentions() {
    for (std::size_t i = 0; i < tokens_.size();) {
      i = FindMention(i);
    }
  }

  // Looks at what begins at a token; returns where to go on.
  std::size_t FindMention(std::size_t at) {
    if (const ClassWordMatch match = MatchClassWord(tokens_, at); match.word != nullptr) {
      const std::size_t end = at + match.tokens;
      const std::optional<ReliefKind> kind = ReliefOfNoun(match.word->phrase);
      const char letter = match.word->LetterIn(plan_.vocabulary);
      if (kind && letter != 'W') {
        const bool plural = match.plural || EndsWith(match.word->phrase, "s");
        mentions_.push_back({*kind, at, end, match.word, plural, -1});
      } else {
        others_.push_back({match.word, at, end});
      }
      return end;
    }
    const std::string_view word = Word(at);
    const std::string singular = Singular(word);
    std::optional<ReliefKind> kind = ReliefOfWord(word);
    const bool plural = !kind && singular != word;
    if (!kind) kind = ReliefOfWord(singular);
    if (!kind) return at + 1;
    if (IsTexture(*kind)) {
      if (SaysLand(at)) mentions_.push_back({*kind, at, at + 1, nullptr, false, -1});
    } else if (IsNounHere(word, at)) {
      mentions_.push_back({*kind, at, at + 1, nullptr, plural, -1});
    }
    return at + 1;
  }

  // "a level" is no land, and neither is who passes.
  bool IsNounHere(std::string_view word, std::size_t at) const {
    const std::string_view before = at > 0 ? Word(at - 1) : std::string_view();
    if (word == "slope" || word == "slopes") {
      if (Word(at + 1) == "of") return false;  // "a slope of 15 degrees", "the slope of the hill"
    }
    if (IsIn(word, {"hollow", "depression", "crest", "summit"})) {
      return IsIn(before, {"a", "the", "small", "large", "deep", "round", "high"});
    }
    return true;
  }

  // Whether an adjective is about land: "rolling country", "the land is hilly", "rolling meadows".
  bool SaysLand(std::size_t at) const {
    if (IsLandWord(Singular(Word(at + 1)))) return true;
    const ClassWordMatch next = MatchClassWord(tokens_, at + 1);
    if (next.word != nullptr && next.word->shape == WordShape::kMass) {
      const std::optional<ReliefKind> own = ReliefOfNoun(next.word->phrase);
      return !own || IsTexture(*own);
    }
    bool is = false;
    for (std::size_t i = at; i-- > 0;) {
      if (IsIn(Word(i), {"is", "are"})) is = true;
      if (is && IsLandWord(Singular(Word(i)))) return true;
    }
    return false;
  }

  bool IsDefinite(const Mention& mention) const {
    for (std::size_t i = mention.begin; i-- > 0;) {
      if (Word(i) == "the") return true;
      if (mention.begin - i > 3 || IsIn(Word(i), {"a", "an", "of", "in"})) return false;
    }
    return false;
  }

  // The wish that a mention means: one that was said before, or a new one.
  void Resolve(Mention* mention) {
    if (IsDefinite(*mention)) {
      for (std::size_t i = plan_.reliefs.size(); i-- > 0;) {
        if (plan_.reliefs[i].kind != mention->kind) continue;
        mention->wish = static_cast<int>(i);
        return;
      }
    }
    if (IsDenied(*mention) || plan_.reliefs.size() >= kMostWishes) return;
    ReliefWish wish;
    wish.kind = mention->kind;
    wish.plural = mention->plural;
    wish.words = Trimmed();
    if (mention->noun != nullptr) {
      if (const int feature = FeatureOf(*mention); feature >= 0) {
        const PlannedFeature& said = plan_.features[static_cast<std::size_t>(feature)];
        wish.letter = said.letter;
        wish.zones = said.zones;
        told_.insert(feature);
      }
    }
    plan_.reliefs.push_back(std::move(wish));
    mention->wish = static_cast<int>(plan_.reliefs.size()) - 1;
  }

  bool IsDenied(const Mention& mention) const {
    for (std::size_t i = mention.begin; i-- > 0 && mention.begin - i <= 2;) {
      if (IsIn(Word(i), {"no", "not", "without"})) return true;
    }
    return false;
  }

  int FeatureOf(const Mention& mention) const {
    for (std::size_t i = 0; i < plan_.features.size(); ++i) {
      const PlannedFeature& feature = plan_.features[i];
      if (feature.noun == mention.noun->phrase && told_.count(static_cast<int>(i)) == 0) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  std::string Trimmed() const {
    std::string words = sentence_;
    while (!words.empty() && (words.back() == '.' || words.back() == ' ')) words.pop_back();
    return words;
  }

  // What stands between the things around a mention is said of it.
  void ReadAttributes(std::size_t index) {
    const Mention& mention = mentions_[index];
    const std::size_t begin = index == 0 ? 0 : mentions_[index - 1].end;
    const std::size_t end =
        index + 1 < mentions_.size() ? mentions_[index + 1].begin : tokens_.size();
    ReadNumber(mention);
    for (std::size_t i = begin; i < end; ++i) {
      const bool before = i < mention.begin;
      // Adjectives stand close before their noun, or come after "is".
      if (before && !Leads(i, mention.begin) && !IsNumber(i)) continue;
      ReadSize(mention, i);
      ReadMeasure(mention, i, begin);
    }
    if (WishOf(mention).zones.empty()) ReadZones(mention, begin, end);
    if (IsCourse(mention.kind)) ReadCourse(mention, end);
  }

  bool IsNumber(std::size_t at) const {
    return at < tokens_.size() && tokens_[at].kind == TokenKind::kNumber;
  }

  bool Leads(std::size_t at, std::size_t noun) const {
    for (std::size_t i = at; i < noun; ++i) {
      if (IsIn(Word(i), {"of", "in", "with", "to", "and", "is", "are"})) return false;
      if (tokens_[i].kind == TokenKind::kStop) return false;
    }
    return noun - at <= 5;
  }

  void ReadNumber(const Mention& mention) {
    for (std::size_t i = mention.begin; i-- > 0 && mention.begin - i <= 4;) {
      const CountMatch count = MatchCount(tokens_, i);
      if (count.tokens == 0 && IsIn(Word(i), {"a", "an", "and", "in", "to", "than"})) return;
      if (count.tokens == 0 || IsIn(Word(i + count.tokens), {"m", "metre", "meter", "degree"})) {
        continue;
      }
      const int most = count.most == CountMatch::kUnbounded ? count.least : count.most;
      WishOf(mention).count = std::max(count.least, (count.least + most + 1) / 2);
      Take(i, i + count.tokens);
      return;
    }
  }

  void ReadSize(const Mention& mention, std::size_t at) {
    ReliefWish& wish = WishOf(mention);
    const std::string_view word = Word(at);
    if (at >= mention.begin && at < mention.end) return;
    if (word == "steep" || word == "sheer") {
      wish.steepness = 1.5;
    } else if (word == "gentle" || word == "low" || word == "shallow") {
      wish.steepness = 0.5;
    } else if (IsIn(word, {"high", "tall", "deep", "towering"}) &&
               !IsIn(at > 0 ? Word(at - 1) : "", {"m", "metres", "meters", "metre", "meter"})) {
      wish.steepness = std::max(wish.steepness, 1.25);
    } else if (const SizeMatch size = MatchSize(tokens_, at);
               size.tokens > 0 && at < mention.begin) {
      wish.size = size.factor * size.width;
    } else {
      return;
    }
    Take(at, at + 1);
  }

  // "120 m high", "rises 40 m", "15 degrees".
  void ReadMeasure(const Mention& mention, std::size_t at, std::size_t clause) {
    if (!IsNumber(at)) return;
    ReliefWish& wish = WishOf(mention);
    const double value = std::strtod(tokens_[at].text.c_str(), nullptr);
    std::size_t next = at + 1;
    const bool metres = IsIn(Word(next), {"m", "metre", "metres", "meter", "meters"});
    if (IsIn(Word(next), {"degree", "degrees"})) {
      Keep("slope", value, &wish.slope_deg, &wish.slope_words);
      Take(at, next + 1);
      return;
    }
    if (!metres) return;
    const std::string_view how = Word(next + 1);
    const bool rises = HasWord(clause, at, {"rises", "rise", "rising", "towers", "height"});
    if (IsIn(how, {"high", "tall", "in"}) || rises) {
      Keep("height", value, &wish.height_m, &wish.height_words);
    } else if (how == "deep" || HasWord(clause, at, {"depth"})) {
      Keep("depth", value, &wish.depth_m, &wish.depth_words);
    } else if (IsIn(how, {"wide", "across", "broad"})) {
      Keep("width", value, &wish.width_m, &wish.width_words);
    } else if (how == "long") {
      Keep("length", value, &wish.length_m, &wish.length_words);
    } else {
      return;
    }
    Take(at, next + 2);
  }

  bool HasWord(std::size_t begin, std::size_t end, Words words) const {
    for (std::size_t i = begin; i < end; ++i) {
      if (IsIn(Word(i), words)) return true;
    }
    return false;
  }

  // The last word counts where two say different things, and it is told.
  void Keep(const char* what, double value, std::optional<double>* kept, std::string* words) {
    if (kept->has_value() && **kept != value) {
      plan_.warnings.push_back(Quote(*words) + " and " + Quote(Trimmed()) +
                               " cannot both be: the later " + what + " counts");
    }
    *kept = value;
    *words = Trimmed();
  }

  void ReadZones(const Mention& mention, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!IsIn(Word(i), {"in", "at", "on", "across", "along", "over", "to"})) continue;
      const PlaceMatch match = MatchPlaceAfter(Word(i), tokens_, i + 1);
      if (match.tokens == 0 || match.of_other) continue;
      for (const Place& place : match.places) WishOf(mention).zones.push_back(place.zone);
      Take(i, i + 1 + match.tokens);
      i += match.tokens;
    }
  }

  void ReadCourse(const Mention& mention, std::size_t end) {
    for (std::size_t i = mention.end; i + 1 < end; ++i) {
      if (Word(i) != "from") continue;
      const PlaceMatch from = MatchPlace(tokens_, i + 1);
      std::size_t to_at = i + 1 + from.tokens;
      if (from.tokens == 0 || Word(to_at) != "to") continue;
      const PlaceMatch to = MatchPlace(tokens_, to_at + 1);
      if (to.tokens == 0) continue;
      ReliefWish& wish = WishOf(mention);
      wish.from = {RimOf(from.places.front())};
      wish.to = {RimOf(to.places.front())};
      wish.zones.clear();
      Take(i, to_at + 1 + to.tokens);
      return;
    }
  }

  // "From the north" begins at the edge.
  static Zone RimOf(const Place& place) {
    return place.main == Region::kAnywhere ? place.zone : RimZoneOf(HeadingOf(place.main));
  }

  void ReadTies(const Mention& mention) {
    // Where the layout has the relief itself, it has its relations too.
    const bool laid = WishOf(mention).letter != '\0';
    for (const OtherThing& other : others_) {
      const char letter = other.noun->LetterIn(plan_.vocabulary);
      if (letter == '\0') continue;
      ReliefTie tie;
      tie.letter = letter;
      for (const PlannedFeature& feature : plan_.features) {
        if (feature.noun == other.noun->phrase) tie.zones = feature.zones;
      }
      if (other.end <= mention.begin ? TieOfOther(other, mention, laid, &tie)
                                     : TieToOther(mention, other, laid, &tie)) {
        WishOf(mention).ties.push_back(std::move(tie));
      }
    }
  }

  // "The village is inside the valley", "the road climbs the hill", "the lake is north of the
  // hill".
  bool TieOfOther(const OtherThing& other, const Mention& mention, bool laid,
                  ReliefTie* tie) const {
    const bool road = tie->letter == 'R' && plan_.vocabulary == Vocabulary::kSuburb;
    const bool up = HasWord(other.end, mention.begin, {"climbs", "climb", "up", "ascends", "top"});
    if (road && up) {
      tie->kind = ReliefTie::Kind::kClimbed;
      return true;
    }
    if (laid) return false;
    for (std::size_t i = mention.begin; i-- > other.end;) {
      if (IsIn(Word(i), {"inside", "in", "within", "on", "through", "atop", "into"})) {
        tie->kind = ReliefTie::Kind::kUnder;
        return true;
      }
      if (IsIn(Word(i), {"near", "beside", "by", "below", "under", "touches"})) {
        tie->kind = ReliefTie::Kind::kBeside;
        return true;
      }
      const HeadingMatch heading = MatchHeading(tokens_, i);
      if (heading.tokens > 0 && Word(i + heading.tokens) == "of") {
        tie->kind = ReliefTie::Kind::kToward;
        tie->heading = {-heading.heading.east, -heading.heading.south};
        return true;
      }
    }
    return false;
  }

  // "A hill north of the lake", "a gorge with a river", "a hill near the village".
  bool TieToOther(const Mention& mention, const OtherThing& other, bool laid,
                  ReliefTie* tie) const {
    if (laid) return false;
    for (std::size_t i = mention.end; i < other.begin; ++i) {
      const HeadingMatch heading = MatchHeading(tokens_, i);
      if (heading.tokens > 0 && Word(i + heading.tokens) == "of") {
        tie->kind = ReliefTie::Kind::kToward;
        tie->heading = {heading.heading.east, heading.heading.south};
        return true;
      }
      if (IsIn(Word(i), {"near", "beside", "by", "behind", "above", "touches"})) {
        tie->kind = ReliefTie::Kind::kBeside;
        return true;
      }
      if (Word(i) == "with") {
        tie->kind = tie->letter == 'R' ? ReliefTie::Kind::kClimbed : ReliefTie::Kind::kUnder;
        return true;
      }
    }
    return false;
  }

  // "The land rises by 30 m to north."
  bool ReadRise() {
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      if (!IsIn(Word(i), {"rises", "rise", "climbs", "slopes"})) continue;
      if (!IsLandWord(Singular(Word(i - 1)))) continue;
      ReliefWish wish;
      wish.kind = ReliefKind::kSlope;
      wish.words = Trimmed();
      for (std::size_t k = i + 1; k < tokens_.size(); ++k) {
        if (IsNumber(k) && IsIn(Word(k + 1), {"m", "metres", "meters"})) {
          wish.height_m = std::strtod(tokens_[k].text.c_str(), nullptr);
          wish.height_words = wish.words;
        }
        if (IsIn(Word(k), {"to", "toward", "towards"})) {
          const std::size_t at = Word(k + 1) == "the" ? k + 2 : k + 1;
          const HeadingMatch heading = MatchHeading(tokens_, at);
          if (heading.tokens > 0) wish.heading = {heading.heading.east, heading.heading.south};
        }
      }
      if (wish.heading.east == 0 && wish.heading.south == 0) return false;
      Take(0, tokens_.size());
      plan_.reliefs.push_back(std::move(wish));
      return true;
    }
    return false;
  }

  void Take(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < std::min(end, tokens_.size()); ++i) {
      taken_.insert(tokens_[i].text);
    }
  }

  // The sentence planner says of what it cannot lay that it cannot; here it was read.
  void TakeOffWarnings() {
    for (const Mention& mention : mentions_) Take(mention.begin, mention.end);
    const std::string quote = Quote(Trimmed());
    const std::string not_laid = "read, but land cannot be laid by it yet: " + quote;
    const std::string not_climbed = "heard in part: " + quote + ": it is laid near, not up";
    auto& warnings = plan_.warnings;
    warnings.erase(std::remove_if(warnings.begin(), warnings.end(),
                                  [&](const std::string& warning) {
                                    return warning == not_laid || StartsWith(warning, not_climbed);
                                  }),
                   warnings.end());
  }

  void TakeOffNotUnderstood() {
    if (plan_.reliefs.empty()) return;
    auto& rest = plan_.not_understood;
    const auto is_read = [this](const std::string& words) {
      const std::vector<Token> tokens = Tokenize(words);
      return std::all_of(tokens.begin(), tokens.end(), [this](const Token& token) {
        return token.kind == TokenKind::kComma || token.kind == TokenKind::kStop ||
               taken_.count(token.text) == 1;
      });
    };
    rest.erase(std::remove_if(rest.begin(), rest.end(), is_read), rest.end());
  }

  // Features that a relief noun names, and that no mention was found to mean.
  void AddFeatures() {
    for (std::size_t i = 0; i < plan_.features.size(); ++i) {
      const PlannedFeature& feature = plan_.features[i];
      const std::optional<ReliefKind> kind = ReliefOfNoun(feature.noun);
      if (feature.noun.empty() || !kind || feature.letter == 'W' || feature.supposed ||
          told_.count(static_cast<int>(i)) == 1 || plan_.reliefs.size() >= kMostWishes) {
        continue;
      }
      const bool known =
          std::any_of(plan_.reliefs.begin(), plan_.reliefs.end(), [&](const ReliefWish& wish) {
            return wish.kind == *kind && wish.letter == feature.letter &&
                   wish.zones == feature.zones;
          });
      if (known) continue;
      ReliefWish wish;
      wish.kind = *kind;
      wish.letter = feature.letter;
      wish.zones = feature.zones;
      wish.plural = feature.plural;
      wish.words = feature.words;
      plan_.reliefs.push_back(std::move(wish));
    }
  }

  void Settle(ReliefWish* wish) {
    const bool mountain = wish->kind == ReliefKind::kMountain || wish->kind == ReliefKind::kPeak;
    wish->alone = mountain && plan_.reliefs.size() == 1 && wish->zones.empty() &&
                  plan_.features.size() <= 1 && wish->size == 1.0 && !wish->width_m;
    // Hills that roll are land as a whole.
    if (IsTexture(wish->kind)) wish->letter = '\0';
  }

  static constexpr std::size_t kMostWishes = 24;

  LayoutPlan& plan_;
  std::string sentence_;
  std::vector<Token> tokens_;
  std::vector<Mention> mentions_;
  std::vector<OtherThing> others_;
  std::set<int> told_;  // features that a wish has
  std::vector<std::string> quotes_;
  std::set<std::string> taken_;  // words that were read
};

// Counts the words of the quotes that no sentence carries as read.
void CountQuoted(std::string_view text, const std::vector<std::string>& quotes,
                 LayoutReading* reading) {
  const std::set<std::string> keys =
      KeysOf(reading->sentences, SentenceKind::kLayout, reading->plan.vocabulary);
  const auto is_quoted = [&](const TextUnit& unit) {
    return std::any_of(quotes.begin(), quotes.end(), [&](const std::string& quote) {
      const std::size_t begin = quote.empty() ? std::string_view::npos : text.find(quote);
      return begin != std::string_view::npos && begin <= unit.begin &&
             unit.end <= begin + quote.size();
    });
  };
  TextCoverage& coverage = reading->coverage;
  std::vector<std::string>& not_understood = reading->plan.not_understood;
  for (const TextUnit& unit : UnitsOf(text, SentenceKind::kLayout, reading->plan.vocabulary)) {
    if (IsCarried(unit, keys) || !is_quoted(unit)) continue;
    coverage.carried = std::min(coverage.words, coverage.carried + 1);
    const std::string words(text.substr(unit.begin, unit.end - unit.begin));
    not_understood.erase(std::remove(not_understood.begin(), not_understood.end(), words),
                         not_understood.end());
  }
}

}  // namespace

void ReadRelief(std::string_view text, LayoutReading* reading) {
  ReliefReader reader(reading);
  const std::vector<std::string> sentences =
      reading->of_sentences ? reading->sentences : SplitSentences(text);
  for (const std::string& sentence : sentences) reader.Read(sentence);
  reader.Finish();
  if (!reading->of_sentences) CountQuoted(text, reader.quotes(), reading);
}

void LeaveToTheirClass(LayoutPlan* plan) {
  const auto rises_anyway = [](const ReliefWish& wish) {
    const bool mountain = wish.kind == ReliefKind::kMountain || wish.kind == ReliefKind::kPeak;
    return mountain && wish.letter != '\0' && !wish.alone && !wish.height_m && !wish.slope_deg &&
           !wish.width_m && wish.ties.empty();
  };
  plan->reliefs.erase(std::remove_if(plan->reliefs.begin(), plan->reliefs.end(), rises_anyway),
                      plan->reliefs.end());
}

void AddTerrainType(const EnvironmentReading& environment, LayoutReading* layout) {
  const HeardCoarse& heard = environment.heard.coarse_of(CoarseKey::kTerrainType);
  if (!layout->plan.reliefs.empty() || heard.hint) return;
  constexpr std::pair<std::string_view, ReliefKind> kKinds[] = {
      {"mountain", ReliefKind::kMountainous},
      {"hills", ReliefKind::kHilly},
      {"plain", ReliefKind::kFlat},
  };
  for (const auto& [value, kind] : kKinds) {
    if (heard.value != value) continue;
    ReliefWish wish;
    wish.kind = kind;
    wish.words = heard.words;
    layout->plan.reliefs.push_back(std::move(wish));
  }
}

}  // namespace latticeworld
