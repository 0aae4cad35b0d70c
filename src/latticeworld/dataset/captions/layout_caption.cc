#include "latticeworld/dataset/captions/layout_caption.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/places.h"
#include "latticeworld/layout/class_letters.h"

namespace latticeworld {
namespace {

constexpr double kJoined = 0.3;  // how often two facts that can go into one sentence do
constexpr int kPicks = 16;       // of a phrase that can be joined; every key has such ones

// Whether it is "put it there" or "it there, please", which no statement can be joined with.
bool Asks(std::string_view phrase) {
  return StartsWith(phrase, "put ") || EndsWith(phrase, "please");
}

struct Noun {
  std::string article;  // where it is first named; "": none
  std::string noun;
  bool plural = false;
};

// "-;fields;p" of data/layout_nouns.txt.
Noun NounOf(const std::string& text) {
  const std::vector<std::string> fields = Split(text, ';');
  if (fields.size() != 3) return {"", text, false};
  return {fields[0] == "-" ? "" : fields[0], fields[1], fields[2] == "p"};
}

std::string_view HeadingWord(Claim::Heading heading) {
  static constexpr std::array<std::array<std::string_view, 3>, 3> kWords = {
      {{"north-west", "north", "north-east"},
       {"west", "here", "east"},
       {"south-west", "south", "south-east"}}};
  return kWords[static_cast<std::size_t>(heading.south + 1)]
               [static_cast<std::size_t>(heading.east + 1)];
}

// "the north" of "in the north".
std::string WithoutPreposition(const std::string& place) {
  const std::size_t at = place.find("the ");
  return at == std::string::npos ? place : place.substr(at);
}

class Writer {
 public:
  Writer(const std::vector<ClassInLayout>& classes, Vocabulary vocabulary, const Wording& wording,
         RandomStream* random)
      : book_(PhraseBook::BuiltIn()),
        classes_(classes),
        vocabulary_(vocabulary),
        wording_(wording),
        random_(random) {}

  std::string Write(const std::vector<LayoutFact>& facts) {
    std::string text;
    const std::string opening = "opening." + std::string(NameOf(vocabulary_));
    if (random_->Chance(0.3)) text = Capitalised(book_.Pick(opening, wording_.voice, random_));
    bool joined = false;
    for (std::size_t i = 0; i < facts.size(); ++i) {
      const bool after_colon = !text.empty() && text.back() == ':';
      joined = i > 0 && !joined && !after_colon && !fronted_ && !asked_ &&
               Joins(facts[i - 1], facts[i]) && random_->Chance(kJoined);
      std::string sentence = Sentence(facts[i], joined);
      if (joined) {
        text += book_.Pick("join", wording_.voice, random_);
      } else if (!text.empty() && !after_colon && text.back() != '.') {
        text += '.';
      }
      if (!text.empty()) text += ' ';
      text += joined ? sentence : Capitalised(std::move(sentence));
    }
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
  }

 private:
  // Whether two facts go into one sentence: what follows the list of an order would belong to it,
  // and so would what follows a part that is full of something. Nobody names a subject twice in
  // one.
  static bool Joins(const LayoutFact& before, const LayoutFact& fact) {
    const auto plain = [](const LayoutFact& one) {
      return one.topic == FactTopic::kLine || one.topic == FactTopic::kPlace ||
             one.topic == FactTopic::kRelation;
    };
    const bool whole = before.phrase == "place.only" || before.phrase == "place.fills" ||
                       before.phrase == "place.mostly";
    return plain(before) && plain(fact) && !whole && before.subject != fact.subject;
  }

  const Noun& NounFor(char letter) {
    const auto known = nouns_.find(letter);
    if (known != nouns_.end()) return known->second;
    const auto entry = std::find_if(classes_.begin(), classes_.end(),
                                    [&](const ClassInLayout& one) { return one.letter == letter; });
    // What is not there is spoken of as land, or as what runs.
    const bool road = IsRoad(vocabulary_, letter);
    const bool houses = IsBuilding(vocabulary_, letter);
    const ClassForm form = entry != classes_.end() ? entry->form
                           : road                  ? ClassForm::kLines
                           : houses                ? ClassForm::kMany
                                                   : ClassForm::kSpread;
    const std::string key =
        "noun." + std::string(NameOf(vocabulary_)) + "." + letter + "." + std::string(NameOf(form));
    return nouns_[letter] = NounOf(book_.Pick(key, wording_.voice, random_));
  }

  bool IsNamed(char letter) const { return named_.find(letter) != std::string::npos; }

  // "a lake" where it is first named, "the lake" later, "forest" or "the forest" at will.
  std::string Named(char letter) {
    const Noun& noun = NounFor(letter);
    const bool first = !IsNamed(letter);
    if (first) named_ += letter;
    if (first) return noun.article.empty() ? noun.noun : noun.article + " " + noun.noun;
    return "the " + noun.noun;
  }

  std::string Place(const Zone& zone) {
    const std::string key = "zone." + zone.name + (wording_.picture ? ".picture" : ".compass");
    return book_.Pick(key, wording_.voice, random_);
  }

  // joined: it goes on within a sentence, where "it" is less clear.
  std::string Sentence(const LayoutFact& fact, bool joined) {
    // "There is" is not for the one thing that was named.
    const bool known = fact.phrase == "place.there" && IsNamed(fact.subject) &&
                       !NounFor(fact.subject).article.empty();
    const std::string key = known ? "place.lies" : fact.phrase;
    // A phrase that asks is drawn again within a sentence.
    const std::string* picked = &book_.Pick(key, wording_.voice, random_);
    for (int i = 0; joined && Asks(*picked) && i < kPicks; ++i)
      picked = &book_.Pick(key, wording_.voice, random_);
    const std::string& phrase = *picked;
    fronted_ = StartsWith(phrase, "{at}");
    asked_ = Asks(phrase);
    std::vector<Slot> slots;
    const bool plural = fact.subject != '?' && NounFor(fact.subject).plural;
    const auto uses = [&](std::string_view slot) { return phrase.find(slot) != std::string::npos; };
    const bool verb = uses("[");  // nobody says "it in the north"
    // Slots in the order of the words, so that what comes first is what is named first.
    std::vector<std::pair<std::size_t, char>> order;
    for (const auto& [slot, name] :
         {std::pair<std::string_view, char>{"{s}", 's'}, {"{o}", 'o'}, {"{p}", 'p'}}) {
      if (uses(slot)) order.push_back({phrase.find(slot), name});
    }
    std::sort(order.begin(), order.end());
    for (const auto& [at, name] : order) {
      const char letter = name == 's' ? fact.subject : name == 'o' ? fact.object : fact.second;
      slots.push_back({name == 's'   ? std::string_view("s")
                       : name == 'o' ? std::string_view("o")
                                     : std::string_view("p"),
                       Bare(fact, name, letter)                     ? NounFor(letter).noun
                       : !joined && verb && Pronoun(fact, name, at) ? Pronoun(letter)
                                                                    : Named(letter)});
    }
    // Numbers, headings and places fill the other slots.
    slots.push_back({"n", NumberWord(fact.count)});
    slots.push_back({"amount", fact.amount});
    slots.push_back({"h", std::string(HeadingWord(fact.heading))});
    if (uses("{at}")) slots.push_back({"at", Place(fact.zone)});
    if (fact.topic == FactTopic::kOrder) {
      AddOrder(fact, &slots);
    } else {
      if (uses("{zone}")) slots.push_back({"zone", WithoutPreposition(Place(fact.zone))});
      if (uses("{to}")) slots.push_back({"to", WithoutPreposition(Place(fact.to))});
      if (uses("{side}")) slots.push_back({"side", SideWord(HeadingOf(RegionOf(fact.zone)))});
      if (uses("{end}")) slots.push_back({"end", SideWord(HeadingOf(RegionOf(fact.to)))});
    }
    // "Fields cover half of the land" names them all; "there are fields in the north" does not.
    const bool all = fact.topic == FactTopic::kExtent || fact.topic == FactTopic::kNumber ||
                     fact.phrase == "place.only" || fact.count > 0;
    if (all) named_ += fact.subject;
    last_ =
        fact.topic == FactTopic::kAbsence || fact.topic == FactTopic::kOrder ? '\0' : fact.subject;
    return FillPhrase(phrase, slots, plural);
  }

  // Whether the noun stands without an article: "no lakes", "three lakes", "mostly forest".
  bool Bare(const LayoutFact& fact, char slot, char letter) {
    switch (fact.topic) {
      case FactTopic::kAbsence:
        return true;
      case FactTopic::kExtent:
      case FactTopic::kRest:
      case FactTopic::kNumber:
        return NounFor(letter).article.empty();
      case FactTopic::kPlace:
        return slot == 's' && NounFor(letter).article.empty() &&
               (fact.count > 0 || fact.phrase == "place.fills" || fact.phrase == "place.mostly" ||
                fact.phrase == "place.there" || fact.phrase == "place.only");
      default:
        return false;
    }
  }
  // "It" for what the last sentence was about, at the beginning of this one.
  bool Pronoun(const LayoutFact& fact, char slot, std::size_t at) const {
    return slot == 's' && at == 0 && fact.subject == last_ && wording_.voice != Voice::kTerse &&
           random_->Chance(wording_.pronouns);
  }
  std::string Pronoun(char letter) { return NounFor(letter).plural ? "they" : "it"; }

  // "north" or "top".
  std::string SideWord(Heading heading) const {
    if (!wording_.picture) return std::string(HeadingWord({heading.east, heading.south}));
    if (heading.south != 0) return heading.south < 0 ? "top" : "bottom";
    return heading.east < 0 ? "left" : "right";
  }

  void AddOrder(const LayoutFact& fact, std::vector<Slot>* slots) {
    slots->push_back({"zone", SideWord({-fact.heading.east, -fact.heading.south})});
    slots->push_back({"to", SideWord({fact.heading.east, fact.heading.south})});
    static constexpr std::string_view kNames[] = {"a", "b", "c"};
    for (std::size_t i = 0; i < fact.sequence.size() && i < 3; ++i) {
      named_ += fact.sequence[i];
      const Noun& noun = NounFor(fact.sequence[i]);
      slots->push_back(
          {kNames[i], noun.article.empty() ? noun.noun : noun.article + " " + noun.noun});
    }
  }

  const PhraseBook& book_;
  const std::vector<ClassInLayout>& classes_;
  const Vocabulary vocabulary_;
  const Wording wording_;
  RandomStream* random_;
  std::map<char, Noun> nouns_;
  std::string named_;     // letters that were named
  bool fronted_ = false;  // the last sentence began with its place, to which more would belong
  bool asked_ = false;    // the last sentence was no statement
  char last_ = '\0';      // what the last sentence was about
};

}  // namespace

std::string WordFacts(const std::vector<LayoutFact>& facts,
                      const std::vector<ClassInLayout>& classes, Vocabulary vocabulary,
                      const Wording& wording, RandomStream* random) {
  return Writer(classes, vocabulary, wording, random).Write(facts);
}

}  // namespace latticeworld
