#include "latticeworld/language/reading/relief/relief_reading.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/reading/relief/relief_attributes.h"
#include "latticeworld/language/reading/relief/relief_sentence.h"
#include "latticeworld/language/reading/relief/relief_ties.h"
#include "latticeworld/language/reading/relief/relief_words.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {
namespace {

// A sentence that says something of relief, and which of its words were read for it.
struct ReliefQuote {
  std::string words;
  std::set<std::string> taken;
};

// Gathers the wishes of a text, sentence by sentence.
class ReliefReader {
 public:
  explicit ReliefReader(LayoutReading* reading) : plan_(reading->plan) {}

  void Read(const std::string& words) {
    ReliefSentence sentence(words, plan_.vocabulary);
    bool read = ReadRise(&sentence);
    for (const HeightCover& cover : sentence.covers()) {
      AddCover(cover);
      read = true;
    }
    ResolveAll(&sentence);
    for (std::size_t i = 0; i < sentence.mentions().size(); ++i) {
      const ReliefMention& mention = sentence.mentions()[i];
      if (mention.wish < 0) continue;
      ReadReliefAttributes(i, &sentence, &WishOf(mention), &plan_.warnings);
      read = true;
    }
    ReadReliefTies(&sentence, &plan_);
    if (sentence.way_slope()) {
      way_slopes_.push_back({sentence.way_slope()->degrees, sentence.words()});
      read = true;
    }
    if (!read) return;
    TakeOffWarnings(sentence.words());
    taken_.insert(sentence.taken().begin(), sentence.taken().end());
    quotes_.push_back({sentence.words(), sentence.taken()});
  }

  void Finish() {
    AddFeatures();
    DropContradicted();
    SettleWaySlopes(way_slopes_, &plan_);
    for (ReliefWish& wish : plan_.reliefs) Settle(&wish);
    TakeOffNotUnderstood();
  }

  const std::vector<ReliefQuote>& quotes() const { return quotes_; }

 private:
  static constexpr std::size_t kMostWishes = 24;

  ReliefWish& WishOf(const ReliefMention& mention) {
    return plan_.reliefs[static_cast<std::size_t>(mention.wish)];
  }

  // A saddle comes behind the rises that it lies between.
  void ResolveAll(ReliefSentence* sentence) {
    std::vector<ReliefMention>& mentions = sentence->mentions();
    const auto is_saddle = [](const ReliefMention& m) { return m.kind == ReliefKind::kSaddle; };
    for (ReliefMention& mention : mentions) {
      if (!is_saddle(mention)) Resolve(*sentence, &mention);
    }
    for (std::size_t i = 0; i < mentions.size(); ++i) {
      if (!is_saddle(mentions[i])) continue;
      Resolve(*sentence, &mentions[i]);
      if (mentions[i].wish >= 0) ReadBetween(*sentence, i);
    }
  }

  static bool IsDefinite(const ReliefSentence& sentence, const ReliefMention& mention) {
    for (std::size_t i = mention.begin; i-- > 0;) {
      if (sentence.Is(i, {"the"})) return true;
      if (mention.begin - i > 3 || sentence.Is(i, {"a", "an", "of", "in"})) return false;
    }
    return false;
  }

  static bool IsDenied(const ReliefSentence& sentence, const ReliefMention& mention) {
    const std::size_t begin = mention.begin < 2 ? 0 : mention.begin - 2;
    return sentence.Has(begin, mention.begin, {"no", "not", "without"});
  }

  // The wish that a mention means: one that was said before, or a new one.
  void Resolve(const ReliefSentence& sentence, ReliefMention* mention) {
    if (!mention->label.empty() || IsDefinite(sentence, *mention)) {
      for (std::size_t i = plan_.reliefs.size(); i-- > 0;) {
        const ReliefWish& known = plan_.reliefs[i];
        const bool same = mention->label.empty() || known.label == mention->label;
        if (known.kind != mention->kind || !same) continue;
        mention->wish = static_cast<int>(i);
        return;
      }
    }
    if (IsDenied(sentence, *mention) || plan_.reliefs.size() >= kMostWishes) return;
    ReliefWish wish;
    wish.kind = mention->kind;
    wish.plural = mention->plural;
    wish.label = mention->label;
    wish.words = sentence.words();
    if (mention->noun != nullptr) TakeFeature(*mention->noun, &wish);
    plan_.reliefs.push_back(std::move(wish));
    mention->wish = static_cast<int>(plan_.reliefs.size()) - 1;
  }

  // The layout knows the form by its class, and where it is.
  void TakeFeature(const ClassWord& noun, ReliefWish* wish) {
    for (std::size_t i = 0; i < plan_.features.size(); ++i) {
      const PlannedFeature& feature = plan_.features[i];
      if (feature.noun != noun.phrase || !told_.insert(static_cast<int>(i)).second) continue;
      wish->zones = feature.zones;
      if (wish->kind != ReliefKind::kSaddle) wish->letter = feature.letter;
      return;
    }
  }

  // "A saddle between two peaks", "the pass between hill A and hill B".
  void ReadBetween(const ReliefSentence& sentence, std::size_t index) {
    const ReliefMention& saddle = sentence.mentions()[index];
    std::vector<int>& between = WishOf(saddle).between;
    for (std::size_t i = index + 1; i < sentence.mentions().size(); ++i) {
      const ReliefMention& rise = sentence.mentions()[i];
      const bool rises = rise.kind == ReliefKind::kMountain || rise.kind == ReliefKind::kPeak ||
                         rise.kind == ReliefKind::kHill;
      if (!rises || rise.wish < 0) continue;
      if (!sentence.Has(saddle.end, rise.begin, {"between"})) continue;
      between.push_back(rise.wish);
      WishOf(rise).letter = '\0';  // tops of their own, not an area
    }
  }

  void AddCover(const HeightCover& cover) {
    ForgetFeature(cover.words);
    const ClassWord* noun = MatchClassWord(Tokenize(cover.words), 0).word;
    if (noun != nullptr && !noun->IsExactIn(plan_.vocabulary)) {
      plan_.warnings.push_back(Quote(cover.words) + " is laid as " +
                               std::string(FindClass(plan_.vocabulary, cover.letter)->name) +
                               ", the nearest class of the " +
                               std::string(NameOf(plan_.vocabulary)) + " vocabulary");
    }
    for (HeightCover& known : plan_.covers) {
      if (known.letter != cover.letter || known.above != cover.above) continue;
      if (known.height_m != cover.height_m) {
        plan_.warnings.push_back(Quote(known.words) + " and " + Quote(cover.words) +
                                 " cannot both be: the later height counts");
      }
      known = cover;
      return;
    }
    plan_.covers.push_back(cover);
  }

  // What the words of a cover were taken for before: land somewhere on the map, north of others.
  void ForgetFeature(const std::string& words) {
    const auto is_said = [&words](const std::string& said) {
      return !said.empty() &&
             (words.find(said) != std::string::npos || said.find(words) != std::string::npos);
    };
    const auto forget = [&is_said](auto* all) {
      all->erase(std::remove_if(all->begin(), all->end(),
                                [&](const auto& one) { return is_said(one.words); }),
                 all->end());
    };
    forget(&plan_.claims);
    forget(&plan_.relations);
    forget(&plan_.orders);
    for (int i = static_cast<int>(plan_.features.size()) - 1; i >= 0; --i) {
      PlannedFeature& feature = plan_.features[static_cast<std::size_t>(i)];
      if (!is_said(feature.words)) continue;
      feature.supposed = true;  // where others need it, it stays and asks for nothing
      TakeOff(i);
    }
  }

  template <typename Visit>
  void ForEachReference(Visit visit) {
    for (PlannedRelation& relation : plan_.relations) {
      for (int* index : {&relation.subject, &relation.object, &relation.second_object}) {
        visit(index);
      }
    }
    for (PlannedOrder& order : plan_.orders) {
      for (int& index : order.features) visit(&index);
    }
    for (PlannedFeature& feature : plan_.features) {
      if (feature.from) visit(&feature.from->feature);
      if (feature.to) visit(&feature.to->feature);
      for (Waypoint& waypoint : feature.via) visit(&waypoint.feature);
    }
  }

  // Takes a feature that nothing refers to off the plan.
  void TakeOff(int index) {
    bool needed = false;
    ForEachReference([&](const int* other) { needed = needed || *other == index; });
    if (needed) return;
    plan_.features.erase(plan_.features.begin() + index);
    const auto renumber = [index](int other) { return other > index ? other - 1 : other; };
    ForEachReference([&](int* other) { *other = renumber(*other); });
    std::set<int> told;
    for (const int other : told_) {
      if (other != index) told.insert(renumber(other));
    }
    told_ = std::move(told);
  }

  // "The land rises by 30 m to north."
  bool ReadRise(ReliefSentence* sentence) {
    const std::size_t end = sentence->tokens().size();
    for (std::size_t i = 1; i < end; ++i) {
      const bool moves =
          sentence->Is(i, {"rises", "rise", "climbs", "slopes", "falls", "descends", "drops"});
      if (!moves || !IsLandWord(Singular(sentence->Word(i - 1)))) continue;
      ReliefWish wish;
      wish.kind = ReliefKind::kSlope;
      wish.words = sentence->words();
      wish.heading = RiseOf(*sentence, i, end);
      if (wish.heading.east == 0 && wish.heading.south == 0) return false;
      for (std::size_t k = i + 1; k < end; ++k) {
        const std::optional<double> metres = sentence->MetresAt(k);
        if (!metres) continue;
        wish.height_m = metres;
        wish.height_words = wish.words;
      }
      sentence->Take(0, end);
      plan_.reliefs.push_back(std::move(wish));
      return true;
    }
    return false;
  }

  // The sentence planner says of what it cannot lay that it cannot; here it was read.
  void TakeOffWarnings(const std::string& words) {
    const std::string quote = Quote(words);
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
    if (plan_.reliefs.empty() && plan_.covers.empty()) return;
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
      if (feature.noun.empty() || !kind || kind == ReliefKind::kSlope || feature.letter == 'W' ||
          feature.supposed || told_.count(static_cast<int>(i)) == 1 ||
          plan_.reliefs.size() >= kMostWishes) {
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
    const auto said = std::count_if(plan_.features.begin(), plan_.features.end(),
                                    [](const PlannedFeature& one) { return !one.supposed; });
    wish->alone = mountain && plan_.reliefs.size() == 1 && wish->zones.empty() && said <= 1 &&
                  wish->size == 1.0 && !wish->width_m;
    // Hills that roll are land as a whole.
    if (IsTexture(wish->kind)) wish->letter = '\0';
  }

  // Land as a whole is one way or the other, and rises to one side: the later words count.
  void DropContradicted() {
    std::vector<ReliefWish>& all = plan_.reliefs;
    for (std::size_t later = 1; later < all.size(); ++later) {
      for (std::size_t earlier = 0; earlier < later; ++earlier) {
        if (!Contradict(all[earlier], all[later])) continue;
        plan_.warnings.push_back(Quote(all[earlier].words) + " and " + Quote(all[later].words) +
                                 " are said of the same land: the later counts");
        Drop(static_cast<int>(earlier));
        --later;
        break;
      }
    }
  }

  static bool Contradict(const ReliefWish& a, const ReliefWish& b) {
    if (a.zones != b.zones) return false;
    if (IsTexture(a.kind) && IsTexture(b.kind)) return a.kind != b.kind;
    return a.kind == ReliefKind::kSlope && b.kind == ReliefKind::kSlope &&
           a.heading.east * b.heading.east + a.heading.south * b.heading.south < 0;
  }

  // Takes a wish off the plan; none refers to land as a whole.
  void Drop(int index) {
    plan_.reliefs.erase(plan_.reliefs.begin() + index);
    for (ReliefWish& wish : plan_.reliefs) {
      for (int& other : wish.between) other -= other > index ? 1 : 0;
      for (ReliefTie& tie : wish.ties) tie.wish -= tie.wish > index ? 1 : 0;
    }
  }

  LayoutPlan& plan_;
  std::set<int> told_;  // features that a wish has
  std::vector<ReliefQuote> quotes_;
  std::set<std::string> taken_;  // words that were read
  std::vector<SaidWaySlope> way_slopes_;
};

// Counts the words of the quotes that nothing else carries as read; of known ones those that were
// read for the relief.
void CountQuoted(std::string_view text, const std::vector<ReliefQuote>& quotes,
                 LayoutReading* reading) {
  const auto is_read = [&](const TextUnit& unit) {
    return std::any_of(quotes.begin(), quotes.end(), [&](const ReliefQuote& quote) {
      const std::size_t begin =
          quote.words.empty() ? std::string_view::npos : text.find(quote.words);
      const bool quoted = begin != std::string_view::npos && begin <= unit.begin &&
                          unit.end <= begin + quote.words.size();
      if (!quoted || !unit.known) return quoted;
      const std::vector<Token> tokens = Tokenize(text.substr(unit.begin, unit.end - unit.begin));
      return std::all_of(tokens.begin(), tokens.end(), [&quote](const Token& token) {
        return quote.taken.count(token.text) == 1;
      });
    });
  };
  TextCoverage& coverage = reading->coverage;
  std::vector<std::string>& not_understood = reading->plan.not_understood;
  for (const TextUnit& unit : UnitsOf(text, SentenceKind::kLayout, reading->plan.vocabulary)) {
    if (IsCarried(unit, coverage.keys) || !is_read(unit)) continue;
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
