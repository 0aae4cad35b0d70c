#ifndef LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_SENTENCE_H_
#define LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_SENTENCE_H_

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/relief_wish.h"

namespace latticeworld {

// ReliefMention is a relief noun or adjective in a sentence. Positions count tokens.
struct ReliefMention {
  ReliefKind kind = ReliefKind::kHill;
  std::size_t begin = 0;
  std::size_t end = 0;
  const ClassWord* noun = nullptr;  // the noun that the layout knows it by; nullptr: none
  bool plural = false;
  std::string label;  // "A" of "hill A"
  int wish = -1;      // index of the wish that it means; -1: not known yet
};

// OtherMention is a thing of the layout that the same sentence names.
struct OtherMention {
  const ClassWord* noun = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
};

// WaySlope is the slope that a sentence says of a way: "a path of 15 degrees".
struct WaySlope {
  double degrees = 0.0;
  std::size_t begin = 0;  // of the number and the words that lead to it
  std::size_t end = 0;
};

// ReliefSentence holds what one sentence names and which of its words were read so far.
class ReliefSentence {
 public:
  ReliefSentence(std::string_view sentence, Vocabulary vocabulary);

  // The sentence without the stop at its end.
  const std::string& words() const { return words_; }
  const std::vector<Token>& tokens() const { return tokens_; }
  std::vector<ReliefMention>& mentions() { return mentions_; }
  const std::vector<ReliefMention>& mentions() const { return mentions_; }
  const std::vector<OtherMention>& others() const { return others_; }
  // Classes by height: "snow above 80 m". The words of covers are no measures of a form.
  const std::vector<HeightCover>& covers() const { return covers_; }
  // Nor are those of the slope of a way.
  const std::optional<WaySlope>& way_slope() const { return way_slope_; }

  // Returns the word at a token; "" where there is none.
  std::string_view Word(std::size_t at) const;
  bool Is(std::size_t at, std::initializer_list<std::string_view> words) const;
  bool Has(std::size_t begin, std::size_t end, std::initializer_list<std::string_view> words) const;
  bool IsNumber(std::size_t at) const;
  bool IsOfCover(std::size_t at) const { return of_covers_.count(at) == 1; }
  bool IsOfWay(std::size_t at) const {
    return way_slope_ && at >= way_slope_->begin && at < way_slope_->end;
  }
  bool IsDegrees(std::size_t at) const { return IsNumber(at) && Is(at + 1, {"degree", "degrees"}); }
  // Whether the noun of another thing is a way's: a road, a path.
  static bool IsWay(const OtherMention& other) { return other.noun->suburb == 'R'; }
  // Returns the metres that a number at `at` and the unit behind it say; nullopt where they say
  // none.
  std::optional<double> MetresAt(std::size_t at) const;

  // Notes the words [begin, end) as read.
  void Take(std::size_t begin, std::size_t end);
  const std::set<std::string>& taken() const { return taken_; }

 private:
  std::size_t FindMention(std::size_t at, Vocabulary vocabulary);
  void FindCover(Vocabulary vocabulary, std::size_t at);
  void FindWaySlope();
  std::size_t DegreesAfter(std::size_t at, std::initializer_list<std::string_view> between) const;
  bool IsNounHere(std::string_view word, std::size_t at) const;
  bool SaysLand(std::size_t at) const;
  void AddMention(ReliefKind kind, std::size_t begin, std::size_t end, const ClassWord* noun,
                  bool plural);

  std::string words_;
  std::vector<Token> tokens_;
  std::vector<ReliefMention> mentions_;
  std::vector<OtherMention> others_;
  std::vector<HeightCover> covers_;
  std::set<std::size_t> of_covers_;
  std::optional<WaySlope> way_slope_;
  std::set<std::string> taken_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_SENTENCE_H_
