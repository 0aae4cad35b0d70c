#include "latticeworld/language/grounded/reading/chunk.h"

#include <algorithm>
#include <utility>

#include "latticeworld/language/grounded/reading/chunk_qualities.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxPhraseLexemes = 14;  // before the head of a noun phrase
constexpr int kMaxUnknown = 4;                 // of them that no list knows

std::optional<Head> PronounOf(Sense sense) {
  switch (sense) {
    case Sense::kIt:
      return Head::kIt;
    case Sense::kThey:
      return Head::kThey;
    case Sense::kBoth:
      return Head::kBoth;
    case Sense::kFormer:
      return Head::kFormer;
    case Sense::kLatter:
      return Head::kLatter;
    case Sense::kOne:
      return Head::kOne;
    case Sense::kOther:
      return Head::kOther;
    case Sense::kFirst:
      return Head::kFirst;
    case Sense::kMap:
      return Head::kMap;
    case Sense::kRest:
      return Head::kRest;
    default:
      return std::nullopt;
  }
}

class Chunker {
 public:
  explicit Chunker(const std::vector<Token>& tokens)
      : tokens_(tokens), lexemes_(LexLayout(tokens)) {}

  Chunks Read() {
    for (std::size_t i = 0; i + 1 < lexemes_.size(); ++i) {
      // "round the lake": around it.
      const bool around = lexemes_[i].Is(Sense::kRound) &&
                          tokens_[lexemes_[i].first].text == "round" &&
                          (SenseAt(i + 1, Sense::kDefinite) || SenseAt(i + 1, Sense::kIt) ||
                           SenseAt(i + 1, Sense::kBoth) || SenseAt(i + 1, Sense::kThey));
      if (around) lexemes_[i].sense = Sense::kSurrounds;
    }
    ReadThat();
    while (at_ < lexemes_.size()) {
      if (!ReadNounPhrase() && !ReadQualities()) ReadOther();
    }
    return std::move(chunks_);
  }

 private:
  // "that" is an article as a rule.
  void ReadThat() {
    for (std::size_t i = 1; i < lexemes_.size(); ++i) {
      // "a river that flows from the north"
      const std::string_view word = tokens_[lexemes_[i].first].text;
      if (lexemes_[i].Is(Sense::kDefinite) && word == "that" && IsNounAt(i - 1) &&
          i + 1 < lexemes_.size() && (IsVerb(lexemes_[i + 1]) || IsPlainVerb(lexemes_[i + 1]))) {
        lexemes_[i].sense = Sense::kWhich;
      }
      // "trees around that, ...": what was spoken of.
      const bool alone = lexemes_[i].Is(Sense::kDefinite) &&
                         lexemes_[i - 1].Is(Sense::kSurrounds) &&
                         (tokens_[lexemes_[i].first].text == "that" ||
                          tokens_[lexemes_[i].first].text == "this") &&
                         (i + 1 == lexemes_.size() || lexemes_[i + 1].kind == LexemeKind::kComma ||
                          lexemes_[i + 1].kind == LexemeKind::kStop);
      if (alone) lexemes_[i].sense = Sense::kIt;
    }
  }
  // Verbs that mean nothing by themselves.
  bool IsPlainVerb(const Lexeme& lexeme) const {
    const std::string_view word = tokens_[lexeme.first].text;
    for (const std::string_view verb :
         {"goes", "comes", "grows", "starts", "begins", "ends", "stays", "remains", "reaches"}) {
      if (word == verb) return true;
    }
    return false;
  }
  static bool IsVerb(const Lexeme& lexeme) {
    if (lexeme.kind != LexemeKind::kSense) return false;
    switch (lexeme.sense) {
      case Sense::kBe:
      case Sense::kStands:
      case Sense::kHas:
      case Sense::kRuns:
      case Sense::kWinds:
      case Sense::kFrom:
      case Sense::kTo:
      case Sense::kThrough:
      case Sense::kCrosses:
      case Sense::kAlong:
      case Sense::kConnects:
      case Sense::kSurrounds:
      case Sense::kNextTo:
      case Sense::kBetween:
      case Sense::kCovers:
        return true;
      default:
        return false;
    }
  }
  const Lexeme* LexemeAt(std::size_t at) const {
    return at < lexemes_.size() ? &lexemes_[at] : nullptr;
  }
  bool IsNounAt(std::size_t at) const {
    return at < lexemes_.size() && lexemes_[at].kind == LexemeKind::kNoun;
  }
  bool SenseAt(std::size_t at, Sense sense) const {
    return at < lexemes_.size() && lexemes_[at].Is(sense);
  }

  void Emit(Chunk chunk, std::size_t first, std::size_t last) {
    chunk.first_token = lexemes_[first].first;
    chunk.begin = tokens_[lexemes_[first].first].begin;
    chunk.end = tokens_[lexemes_[last - 1].last - 1].end;
    chunks_.chunks.push_back(std::move(chunk));
    at_ = last;
  }
  void AddUnread(std::size_t at) {
    chunks_.unread.emplace_back(tokens_[lexemes_[at].first].begin,
                                tokens_[lexemes_[at].last - 1].end);
  }

  // A place right before a noun tells which: "the northern lake". Not after a preposition, where it
  // stands for itself: "in the north forest, in the south fields".
  bool IsAdjectivePlace(std::size_t at) const {
    if (at > 0) {
      const Lexeme& before = lexemes_[at - 1];
      if (before.Is(Sense::kTravel) && !IsAttributive(lexemes_[at])) return false;  // "going east"
      if (before.kind == LexemeKind::kSense &&
          (before.sense == Sense::kIn || before.sense == Sense::kFrom ||
           before.sense == Sense::kTo || before.sense == Sense::kThrough ||
           before.sense == Sense::kAlong || before.sense == Sense::kCrosses)) {
        const bool course = before.sense != Sense::kIn;
        if (!course || !IsAttributive(lexemes_[at])) return false;
      }
      // "forest left lake right": the place is that of the noun before it.
      if (before.kind == LexemeKind::kNoun && !FollowsPlace(at - 1)) return false;
    }
    std::size_t next = at + 1;
    if (IsLastOne(next)) return lexemes_[at].places.size() == 1 && !IsExtent(lexemes_[at]);
    while (next < lexemes_.size() && (lexemes_[next].kind == LexemeKind::kSize ||
                                      lexemes_[next].kind == LexemeKind::kCount)) {
      ++next;
    }
    // "the northern lake", "the southern one"
    const bool one = (SenseAt(next, Sense::kOne) && tokens_[lexemes_[next].first].text == "one") ||
                     SenseAt(next, Sense::kOther);
    return (IsNounAt(next) || one) && lexemes_[at].places.size() == 1 && !IsExtent(lexemes_[at]);
  }
  // "one" with no noun after it.
  bool IsLastOne(std::size_t at) const {
    return at < lexemes_.size() && lexemes_[at].kind == LexemeKind::kCount &&
           lexemes_[at].last == lexemes_[at].first + 1 &&
           tokens_[lexemes_[at].first].text == "one" && !NounSoon(at + 1);
  }
  // "to the upper lake": the last word of the place can stand before nouns only.
  bool IsAttributive(const Lexeme& place) const {
    const std::string_view word = tokens_[place.last - 1].text;
    return word.size() <= 2 || word == "upper" || word == "lower" || word == "top" ||
           word == "bottom" || word == "central" ||
           (word.size() > 6 && word.substr(word.size() - 3) == "ern");
  }
  // "upper left lake upper right village": a row that begins with a place has them before nouns.
  bool FollowsPlace(std::size_t noun) const {
    const auto in_row = [&](LexemeKind kind) {
      return kind == LexemeKind::kSize || kind == LexemeKind::kCount || kind == LexemeKind::kNoun ||
             kind == LexemeKind::kPlace;
    };
    std::size_t at = noun;
    while (at > 0 && in_row(lexemes_[at - 1].kind)) --at;
    return lexemes_[at].kind == LexemeKind::kPlace;
  }
  // "the northern half", "top third", "NW corner": these stand for themselves.
  bool IsExtent(const Lexeme& place) const {
    for (std::size_t i = place.first; i < place.last; ++i) {
      for (const std::string_view word : {"half", "third", "quarter", "corner", "edge", "side",
                                          "part", "halves", "thirds", "border", "margin", "of"}) {
        if (tokens_[i].text == word) return true;
      }
    }
    return false;
  }

  // What a word of a noun phrase does to it.
  enum class Step {
    kNext,  // the phrase goes on
    kRead,  // it ends here
    kNone   // this is no noun phrase
  };
  // Reads a word of a sense in a noun phrase: a pronoun, which may be its head, or a modifier.
  Step ReadSenseOfPhrase(std::size_t at, bool any_unknown, NounPhrase* phrase,
                         bool* said_something) {
    const Lexeme& lexeme = lexemes_[at];
    if (const auto pronoun = PronounOf(lexeme.sense); pronoun.has_value()) {
      // "one of the lakes", "the other lake", "both lakes": the noun is the head.
      const bool before_noun = lexeme.sense != Sense::kIt && lexeme.sense != Sense::kThey &&
                               lexeme.sense != Sense::kMap && lexeme.sense != Sense::kRest &&
                               NounSoon(at + 1);
      // "country lane"
      if (lexeme.sense == Sense::kMap && IsNounAt(at + 1) &&
          tokens_[lexeme.first].text == "country") {
        return Step::kNext;
      }
      if (any_unknown || phrase->qualities.axis.has_value()) return Step::kNone;
      if (before_noun) {
        phrase->head = *pronoun;
        if (lexeme.sense == Sense::kOne) phrase->qualities.count = CountMatch{1, 1, 1};
        return Step::kNext;
      }
      EmitPronoun(*pronoun, at, std::move(*phrase));
      return Step::kRead;
    }
    // "nothing rocky", but not "nothing because ..."
    if (tokens_[lexeme.first].text == "nothing" && lexeme.Is(Sense::kNo) && !IsNounAt(at + 1)) {
      return Step::kNone;
    }
    if (AddModifier(lexeme, phrase)) {
      *said_something = true;
      return Step::kNext;
    }
    if (lexeme.sense == Sense::kFunction) return Step::kNext;
    if (lexeme.sense == Sense::kOfPlace && (*said_something || AfterShore(at))) return Step::kNext;
    // "six separate trees", "the shore of the lake"
    if (lexeme.sense == Sense::kBetween && tokens_[lexeme.first].text == "separate" &&
        *said_something) {
      phrase->qualities.texture = Texture::kScattered;
      return Step::kNext;
    }
    if (lexeme.sense == Sense::kShore) {
      if (SenseAt(at + 1, Sense::kOfPlace) && NounSoon(at + 2)) {
        phrase->shore = true;
        return Step::kNext;
      }
      if (any_unknown) return Step::kNone;
      EmitPronoun(Head::kShore, at, std::move(*phrase));
      return Step::kRead;
    }
    // "a long, narrow lake": no further than one comma between qualities.
    return Step::kNone;
  }

  // Reads modifiers up to a head; false, and nothing read, where none follows.
  bool ReadNounPhrase() {
    NounPhrase phrase;
    std::vector<std::size_t> unknown;
    std::size_t at = at_;
    bool said_something = false;
    for (; at < lexemes_.size() && at < at_ + kMaxPhraseLexemes; ++at) {
      const Lexeme& lexeme = lexemes_[at];
      if (lexeme.kind == LexemeKind::kNoun) {
        TakeHead(at, &phrase, unknown);
        return true;
      }
      if ((IsOneAlone(at) || (!phrase.places.empty() && IsLastOne(at))) && unknown.empty()) {
        EmitPronoun(Head::kOne, at, std::move(phrase));
        return true;
      }
      if (IsAnotherAlone(at) && unknown.empty()) {
        EmitPronoun(Head::kAnother, at, std::move(phrase));
        return true;
      }
      if (lexeme.kind == LexemeKind::kUnknown) {
        if (static_cast<int>(unknown.size()) >= kMaxUnknown) return false;
        unknown.push_back(at);
        continue;
      }
      if (lexeme.kind == LexemeKind::kPlace) {
        if (!IsAdjectivePlace(at)) return false;
        phrase.places = lexeme.places;
        continue;
      }
      if (lexeme.kind == LexemeKind::kSense) {
        const Step step = ReadSenseOfPhrase(at, !unknown.empty(), &phrase, &said_something);
        if (step == Step::kNext) continue;
        return step == Step::kRead;
      }
      if (lexeme.kind == LexemeKind::kComma && said_something && at > at_ && IsComma(at) &&
          !lexemes_[at - 1].Is(Sense::kMostly) && QualityAt(at - 1) && QualityAt(at + 1) &&
          NounSoon(at + 1)) {
        continue;
      }
      // "starts at the first, passes the second and ends at the third"
      if (lexeme.kind == LexemeKind::kShare && lexeme.share.ordinal && IsThirdOfThese(at)) {
        EmitPronoun(Head::kThird, at, std::move(phrase));
        return true;
      }
      if (!AddQuality(lexeme, &phrase.qualities)) return false;
      said_something = true;
    }
    return false;
  }
  bool IsThirdOfThese(std::size_t at) const {
    if (tokens_[lexemes_[at].last - 1].text != "third" || IsNounAt(at + 1)) return false;
    for (std::size_t i = at; i > 0 && lexemes_[i - 1].kind != LexemeKind::kStop; --i) {
      if (lexemes_[i - 1].Is(Sense::kFirst)) return true;
    }
    return false;
  }

  // "one in the north", "one by the lake": one of what was named.
  bool IsOneAlone(std::size_t at) const {
    const Lexeme& lexeme = lexemes_[at];
    return lexeme.kind == LexemeKind::kCount && lexeme.last == lexeme.first + 1 &&
           tokens_[lexeme.first].text == "one" && StandsAlone(at);
  }
  // "another in the south", "a second one along the edge": one more of what was named.
  bool IsAnotherAlone(std::size_t at) const {
    return SenseAt(at, Sense::kAnother) && StandsAlone(at);
  }
  // Words that a thing is placed with follow, and no noun.
  bool StandsAlone(std::size_t at) const {
    const bool another = SenseAt(at, Sense::kAnother);
    while (at + 1 < lexemes_.size() && lexemes_[at + 1].Is(Sense::kFunction)) ++at;
    if (at + 1 >= lexemes_.size()) return another;
    const Lexeme& next = lexemes_[at + 1];
    if (next.kind == LexemeKind::kAxis) return true;
    // "from the south another comes up and ends at it"
    if (another && (next.kind == LexemeKind::kComma || next.kind == LexemeKind::kStop ||
                    next.Is(Sense::kAnd))) {
      return true;
    }
    if (next.kind == LexemeKind::kPlace) return !IsAdjectivePlace(at + 1);
    if (next.kind == LexemeKind::kDirection) return true;
    if (next.kind != LexemeKind::kSense) return false;
    switch (next.sense) {
      case Sense::kIn:
      case Sense::kTo:
      case Sense::kFrom:
      case Sense::kBe:
      case Sense::kStands:
      case Sense::kRuns:
      case Sense::kNear:
      case Sense::kNextTo:
      case Sense::kWith:
      case Sense::kWithin:
      case Sense::kAlong:
      case Sense::kBothSides:
        return true;
      default:
        return false;
    }
  }

  void EmitPronoun(Head head, std::size_t at, NounPhrase phrase) {
    phrase.head = head;
    phrase.noun = nullptr;
    Chunk chunk;
    chunk.kind = ChunkKind::kNounPhrase;
    chunk.phrase = std::move(phrase);
    Emit(std::move(chunk), at_, at + 1);
  }
  bool AfterShore(std::size_t at) const { return at > 0 && SenseAt(at - 1, Sense::kShore); }

  bool IsComma(std::size_t at) const { return tokens_[lexemes_[at].first].text == ","; }
  bool QualityAt(std::size_t at) const {
    Qualities scratch;
    return at < lexemes_.size() && lexemes_[at].kind != LexemeKind::kCount &&
           lexemes_[at].kind != LexemeKind::kShare && lexemes_[at].kind != LexemeKind::kAxis &&
           AddQuality(lexemes_[at], &scratch);
  }
  // A noun with nothing but qualities before it.
  bool NounSoon(std::size_t at) const {
    for (std::size_t i = at; i < std::min(lexemes_.size(), at + 4); ++i) {
      if (IsNounAt(i)) return true;
      Qualities scratch;
      const bool skip = lexemes_[i].Is(Sense::kOfPlace) || lexemes_[i].Is(Sense::kDefinite) ||
                        AddQuality(lexemes_[i], &scratch);
      if (!skip) return false;
    }
    return false;
  }

  bool AddModifier(const Lexeme& lexeme, NounPhrase* phrase) const {
    switch (lexeme.sense) {
      case Sense::kDefinite:
      case Sense::kIts:
        phrase->definite = phrase->definite || lexeme.sense == Sense::kDefinite;
        return true;
      case Sense::kIndefinite:
        phrase->indefinite = true;
        return true;
      case Sense::kAnother:
        phrase->another = true;
        return true;
      case Sense::kAll:
        phrase->each = true;
        return true;
      case Sense::kNo:
        phrase->negated = true;
        return true;
      case Sense::kMoreThan:
        phrase->qualities.more = true;
        return true;
      case Sense::kLessThan:
        phrase->qualities.less = true;
        return true;
      case Sense::kRiverside:
      case Sense::kLakeside:
      case Sense::kRoadside:
        phrase->qualities.beside = lexeme.sense;
        return true;
      default:
        return AddQuality(lexeme, &phrase->qualities);
    }
  }

  // "keep rivers out", "leave the houses away"
  bool IsKeptOut(std::size_t last) const {
    const std::string_view first = tokens_[lexemes_[at_].first].text;
    if (first != "keep" && first != "leave" && first != "keeping" && first != "leaving") {
      return false;
    }
    if (last >= lexemes_.size() || lexemes_[last].kind != LexemeKind::kSense) return false;
    const std::string_view after = tokens_[lexemes_[last].first].text;
    const bool alone = last + 1 >= lexemes_.size() || lexemes_[last + 1].kind != LexemeKind::kSense;
    return (after == "out" || after == "off" || after == "away") &&
           (alone || SenseAt(last + 1, Sense::kOfPlace) || SenseAt(last + 1, Sense::kFunction));
  }

  // "West of the river bushes, east of it rocks": the bushes are what is there.
  bool IsPlacedByDirection(std::size_t at, std::size_t next) const {
    const bool after_direction =
        at_ > 0 && lexemes_[at_ - 1].kind == LexemeKind::kDirection &&
        (at_ == 1 || lexemes_[at_ - 2].kind == LexemeKind::kStop ||
         lexemes_[at_ - 2].kind == LexemeKind::kComma || lexemes_[at_ - 2].Is(Sense::kAnd));
    const bool ends = next + 1 >= lexemes_.size() || lexemes_[next + 1].kind == LexemeKind::kStop ||
                      lexemes_[next + 1].kind == LexemeKind::kComma ||
                      SenseAt(next + 1, Sense::kAnd);
    return after_direction && ends && lexemes_[at].noun->shape != WordShape::kMass &&
           lexemes_[at].noun->suburb != lexemes_[next].noun->suburb &&
           (lexemes_[next].plural || lexemes_[next].noun->shape == WordShape::kMass);
  }

  // The last of several nouns in a row is the thing, those before it its kind: "mountain lake".
  void TakeHead(std::size_t at, NounPhrase* phrase, const std::vector<std::size_t>& unknown) {
    std::size_t last = at + 1;
    while (IsNounAt(last) && !lexemes_[last - 1].plural && !IsPlacedByDirection(at, last)) ++last;
    // "a field of wheat": what it is made of.
    if (SenseAt(last, Sense::kOfPlace) && IsNounAt(last + 1) &&
        (lexemes_[last - 1].noun->suburb == lexemes_[last + 1].noun->suburb ||
         lexemes_[last - 1].noun->shape == WordShape::kMass)) {
      phrase->plural = lexemes_[last - 1].plural;
      // "a ditch of water", "ribbons of road": the line tells more.
      const bool line = lexemes_[last - 1].noun->shape == WordShape::kLine &&
                        lexemes_[last - 1].noun->suburb == lexemes_[last + 1].noun->suburb;
      if (line) phrase->noun = lexemes_[last - 1].noun;
      last += 2;
    }
    const Lexeme& head = lexemes_[last - 1];
    if (phrase->noun == nullptr) phrase->noun = head.noun;
    phrase->plural = phrase->plural || head.plural;
    for (const std::size_t i : unknown) AddUnread(i);
    phrase->negated = phrase->negated || IsKeptOut(last);
    Chunk chunk;
    chunk.kind = ChunkKind::kNounPhrase;
    chunk.phrase = std::move(*phrase);
    Emit(std::move(chunk), at_, last);
  }

  bool ReadQualities() {
    Chunk chunk;
    chunk.kind = ChunkKind::kQualities;
    std::size_t last = at_;
    for (std::size_t at = at_; at < lexemes_.size(); ++at) {
      if (lexemes_[at].kind == LexemeKind::kAxis) break;
      if (AddQuality(lexemes_[at], &chunk.qualities)) {
        last = at + 1;
      } else if (!lexemes_[at].Is(Sense::kFunction) && !lexemes_[at].Is(Sense::kIndefinite) &&
                 !lexemes_[at].Is(Sense::kDefinite)) {
        break;
      }
    }
    if (last == at_) return false;
    Emit(std::move(chunk), at_, last);
    return true;
  }

  // "Each lies in the north."
  bool IsEachOfThem() const {
    const Lexeme& lexeme = lexemes_[at_];
    const bool starts = at_ == 0 || lexemes_[at_ - 1].kind == LexemeKind::kStop;
    const std::string_view last = tokens_[lexeme.last - 1].text;
    return lexeme.Is(Sense::kAll) && starts && (last == "each" || last == "all") &&
           (SenseAt(at_ + 1, Sense::kBe) || SenseAt(at_ + 1, Sense::kStands) ||
            SenseAt(at_ + 1, Sense::kHas) || SenseAt(at_ + 1, Sense::kIn));
  }

  void ReadOther() {
    const Lexeme& lexeme = lexemes_[at_];
    if (IsEachOfThem()) {
      EmitPronoun(Head::kThey, at_, NounPhrase());
      return;
    }
    Chunk chunk;
    // A lexeme that is no noun is a chunk by itself ...
    switch (lexeme.kind) {
      case LexemeKind::kPlace:
        chunk.kind = ChunkKind::kPlace;
        break;
      case LexemeKind::kDirection:
        chunk.kind = ChunkKind::kDirection;
        break;
      case LexemeKind::kAxis:
        chunk.kind = ChunkKind::kAxis;
        break;
      case LexemeKind::kComma:
        chunk.kind = ChunkKind::kComma;
        break;
      case LexemeKind::kStop:
        chunk.kind = ChunkKind::kStop;
        break;
      case LexemeKind::kUnknown:
        chunk.kind = ChunkKind::kUnknown;
        AddUnread(at_);
        break;
      default:
        chunk.kind = ChunkKind::kSense;
        break;
    }
    // ... but for unknown words and those that only lead nouns.
    const bool skipped = chunk.kind == ChunkKind::kUnknown ||
                         (chunk.kind == ChunkKind::kSense &&
                          (lexeme.sense == Sense::kFunction || lexeme.sense == Sense::kDefinite ||
                           lexeme.sense == Sense::kIndefinite || lexeme.sense == Sense::kIts ||
                           lexeme.sense == Sense::kOfPlace || lexeme.sense == Sense::kAll));
    if (skipped) {
      ++at_;
      return;
    }
    chunk.lexeme = lexeme;
    Emit(std::move(chunk), at_, at_ + 1);
  }

  const std::vector<Token>& tokens_;
  std::vector<Lexeme> lexemes_;
  std::size_t at_ = 0;
  Chunks chunks_;
};

}  // namespace

Chunks ChunkLayout(const std::vector<Token>& tokens) { return Chunker(tokens).Read(); }

}  // namespace latticeworld
