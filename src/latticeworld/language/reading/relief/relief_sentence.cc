#include "latticeworld/language/reading/relief/relief_sentence.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/reading/relief/relief_words.h"

namespace latticeworld {

ReliefSentence::ReliefSentence(std::string_view sentence, Vocabulary vocabulary)
    : words_(sentence), tokens_(Tokenize(sentence)) {
  while (!words_.empty() && (words_.back() == '.' || words_.back() == ' ')) words_.pop_back();
  for (std::size_t i = 0; i < tokens_.size(); ++i) FindCover(vocabulary, i);
  for (std::size_t i = 0; i < tokens_.size();) i = FindMention(i, vocabulary);
  for (const ReliefMention& mention : mentions_) Take(mention.begin, mention.end);
  FindWaySlope();
}

std::string_view ReliefSentence::Word(std::size_t at) const {
  return at < tokens_.size() && tokens_[at].kind == TokenKind::kWord
             ? std::string_view(tokens_[at].text)
             : std::string_view();
}

bool ReliefSentence::Is(std::size_t at, std::initializer_list<std::string_view> words) const {
  return std::find(words.begin(), words.end(), Word(at)) != words.end();
}

bool ReliefSentence::Has(std::size_t begin, std::size_t end,
                         std::initializer_list<std::string_view> words) const {
  for (std::size_t i = begin; i < end; ++i) {
    if (Is(i, words)) return true;
  }
  return false;
}

bool ReliefSentence::IsNumber(std::size_t at) const {
  return at < tokens_.size() && tokens_[at].kind == TokenKind::kNumber;
}

std::optional<double> ReliefSentence::MetresAt(std::size_t at) const {
  if (!IsNumber(at)) return std::nullopt;
  const double value = std::strtod(tokens_[at].text.c_str(), nullptr);
  if (Is(at + 1, {"m", "metre", "metres", "meter", "meters"})) return value;
  if (Is(at + 1, {"km", "kilometre", "kilometres", "kilometer", "kilometers"})) {
    return 1000.0 * value;
  }
  return std::nullopt;
}

void ReliefSentence::Take(std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < std::min(end, tokens_.size()); ++i) {
    taken_.insert(tokens_[i].text);
  }
}

void ReliefSentence::AddMention(ReliefKind kind, std::size_t begin, std::size_t end,
                                const ClassWord* noun, bool plural) {
  ReliefMention mention;
  mention.kind = kind;
  mention.begin = begin;
  mention.end = end;
  mention.noun = noun;
  mention.plural = plural;
  // "Hill A": a label is one capital letter.
  if (Word(end).size() == 1) {
    const char letter = words_[tokens_[end].begin];
    if (std::isupper(static_cast<unsigned char>(letter)) != 0) mention.label = letter;
  }
  if (!mention.label.empty()) ++mention.end;
  mentions_.push_back(std::move(mention));
}

// Looks at what begins at a token; returns where to go on.
std::size_t ReliefSentence::FindMention(std::size_t at, Vocabulary vocabulary) {
  if (IsOfCover(at)) return at + 1;
  if (const ClassWordMatch match = MatchClassWord(tokens_, at); match.word != nullptr) {
    const std::size_t end = at + match.tokens;
    const std::optional<ReliefKind> kind = ReliefOfNoun(match.word->phrase);
    const bool is_pass = ReliefOfWord(Singular(Word(end))) == ReliefKind::kSaddle;
    if (kind && is_pass) {  // "mountain pass": no mountain
      AddMention(ReliefKind::kSaddle, at, end + 1, match.word, Singular(Word(end)) != Word(end));
      return end + 1;
    }
    if (kind == ReliefKind::kSlope) return end;  // "rocky slopes" are ground, not a form
    if (kind && match.word->LetterIn(vocabulary) != 'W') {
      const bool plural = match.plural || EndsWith(match.word->phrase, "s");
      AddMention(*kind, at, end, match.word, plural);
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
  const bool roll = Is(at, {"rolling", "undulating"}) && Is(at + 1, {"hills", "hillocks"});
  if (roll) {  // land as a whole
    AddMention(*kind, at, at + 2, nullptr, false);
    return at + 2;
  }
  if (IsTexture(*kind) ? SaysLand(at) : IsNounHere(word, at)) {
    AddMention(*kind, at, at + 1, nullptr, plural && !IsTexture(*kind));
  }
  return at + 1;
}

// "a level" is no land, and neither is who passes.
bool ReliefSentence::IsNounHere(std::string_view word, std::size_t at) const {
  if (word == "slopes") return false;
  if (word == "slope") {
    // "A road with a slope of 8 degrees": the road's.
    const bool of_way = at >= 2 && Is(at - 2, {"with"}) && !others_.empty() &&
                        others_.back().end == at - 2 && IsWay(others_.back());
    if (of_way) return false;
    // "A slope of 15 degrees" is land of its own where no form stands before it that has it.
    if (Word(at + 1) != "of") return true;
    return IsNumber(at + 2) && mentions_.empty() && at > 0 && Is(at - 1, {"a", "gentle", "steep"});
  }
  if (ReliefOfWord(Singular(word)) == ReliefKind::kSaddle ||
      Has(at, at + 1, {"hollow", "depression", "crest", "summit"})) {
    return at > 0 && (Is(at - 1, {"a", "the", "small", "large", "deep", "round", "high", "low",
                                  "narrow", "wide", "and"}) ||
                      IsNumber(at - 1) || ReliefOfNoun(Word(at - 1)).has_value());
  }
  return true;
}

// Whether an adjective is about land: "rolling country", "the land is hilly", "rolling meadows".
bool ReliefSentence::SaysLand(std::size_t at) const {
  if (IsLandWord(Singular(Word(at + 1)))) return true;
  const ClassWordMatch next = MatchClassWord(tokens_, at + 1);
  if (next.word != nullptr && next.word->shape == WordShape::kMass) {
    const std::optional<ReliefKind> own = ReliefOfNoun(next.word->phrase);
    return !own || IsTexture(*own);
  }
  bool is = false;
  for (std::size_t i = at; i-- > 0;) {
    if (Is(i, {"is", "are"})) is = true;
    if (is && IsLandWord(Singular(Word(i)))) return true;
  }
  return false;
}

// The number of degrees that comes behind a token and some of the words between; npos where none
// does, or nothing is between.
std::size_t ReliefSentence::DegreesAfter(std::size_t at,
                                         std::initializer_list<std::string_view> between) const {
  std::size_t number = at;
  while (Is(number, between)) ++number;
  return number > at && IsDegrees(number) ? number : std::string::npos;
}

// "A path of 15 degrees", "an 8 degree road", "the slope of the road is 8 degrees", "a road climbs
// the hill at 8 degrees".
void ReliefSentence::FindWaySlope() {
  const auto keep = [this](std::size_t begin, std::size_t number) {
    way_slope_ = WaySlope{std::strtod(tokens_[number].text.c_str(), nullptr), begin, number + 2};
    Take(begin, number + 2);
  };
  for (const OtherMention& way : others_) {
    if (!IsWay(way) || way_slope_) continue;
    if (way.begin >= 2 && IsDegrees(way.begin - 2)) return keep(way.begin - 2, way.begin - 2);
    std::size_t number = DegreesAfter(
        way.end, {"of",      "with",    "that",   "which",    "has",      "have",   "a",    "an",
                  "the",     "maximum", "slope",  "gradient", "grade",    "at",     "most", "about",
                  "sloping", "slopes",  "rising", "rises",    "climbing", "climbs", "by"});
    if (number != std::string::npos) return keep(way.end, number);
    const bool slope_of = way.begin >= 3 && Is(way.begin - 2, {"of"}) &&
                          Is(way.begin - 3, {"slope", "gradient", "grade"});
    number = DegreesAfter(way.end, {"is", "at", "most", "about"});
    if (slope_of && number != std::string::npos) return keep(way.end, number);
    for (const ReliefMention& mention : mentions_) {
      const bool climbs = mention.begin > way.end &&
                          Has(way.end, mention.begin, {"climbs", "climb", "ascends", "up", "to"});
      if (!climbs || !Is(mention.end, {"at"})) continue;
      number = DegreesAfter(mention.end, {"at", "a", "slope", "gradient", "of", "most", "about"});
      if (number != std::string::npos) return keep(mention.end, number);
    }
  }
}

// "Snow above 80 m", "the forest lies below a height of 40 metres".
void ReliefSentence::FindCover(Vocabulary vocabulary, std::size_t at) {
  const ClassWordMatch match = MatchClassWord(tokens_, at);
  if (match.word == nullptr || match.word->shape != WordShape::kMass) return;
  std::size_t i = at + match.tokens;
  while (Is(i, {"lies", "is", "grows", "begins", "only", "covers", "everything", "all", "land"}))
    ++i;
  const bool above = Is(i, {"above", "over"});
  if (!above && !Is(i, {"below", "under"})) return;
  ++i;
  while (Is(i, {"a", "the", "height", "heights", "of", "about"})) ++i;
  const std::optional<double> height_m = MetresAt(i);
  const char letter = match.word->LetterIn(vocabulary);
  // Water finds its own level; roads, buildings and fields are land that somebody has made.
  const bool built =
      vocabulary == Vocabulary::kSuburb && (letter == 'R' || letter == 'B' || letter == 'A');
  if (!height_m || letter == '\0' || letter == 'W' || built) return;
  HeightCover cover;
  cover.letter = letter;
  cover.height_m = *height_m;
  cover.above = above;
  cover.words = words_.substr(tokens_[at].begin, tokens_[i + 1].end - tokens_[at].begin);
  covers_.push_back(std::move(cover));
  for (std::size_t k = at; k <= i + 1; ++k) of_covers_.insert(k);
  Take(at, i + 2);
}

}  // namespace latticeworld
