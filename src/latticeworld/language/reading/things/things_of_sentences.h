#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_THINGS_OF_SENTENCES_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_THINGS_OF_SENTENCES_H_

#include <string>
#include <vector>

#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// SentenceThings gathers what sentences of the small language say of single things: objects with an
// article or a number ("a well", "3 trees", "the church"), and what is no land in the plural
// ("lamps"). Other bare plurals ("trees are on both sides of the river") are land, and this class
// leaves bridges and fords to other readers.
class SentenceThings {
 public:
  explicit SentenceThings(Vocabulary vocabulary) : vocabulary_(vocabulary) {}

  // Reads one sentence. Returns false where the sentence is about land.
  bool Say(const Sentence& sentence, const std::string& words);

  // In an order in which each stands behind what it is to stand by; what faces something and has no
  // other place stands near it.
  std::vector<ThingWish> wishes() const;
  const std::vector<std::string>& warnings() const { return warnings_; }
  // The land by which things stand, as it was said, in that order.
  const std::vector<Phrase>& land() const { return land_; }

 private:
  // Returns the index of the wish that a phrase of slot {thing} is about, a new one where none is
  // known; -1 where the phrase is about land.
  int WishOf(const Phrase& thing, const std::string& words);
  int Known(const std::string& kind) const;
  ThingTarget TargetOf(const Phrase& thing, const std::string& words);
  // Notes how a thing stands to others. `beside` is the index of the wish that it is to stand by,
  // where the wish was made for that; -1 means that the words say where.
  bool Relate(const Sentence& sentence, ThingWish wish, int index, int beside,
              const std::string& words);

  const Vocabulary vocabulary_;
  std::vector<ThingWish> wishes_;
  std::vector<Phrase> land_;
  std::vector<std::string> warnings_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_THINGS_OF_SENTENCES_H_
