#ifndef LATTICEWORLD_DATASET_CAPTIONS_LAYOUT_CAPTION_H_
#define LATTICEWORLD_DATASET_CAPTIONS_LAYOUT_CAPTION_H_

#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/dataset/captions/layout_facts.h"
#include "latticeworld/dataset/captions/phrase_book.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// How a caption is worded.
struct Wording {
  Voice voice = Voice::kTechnical;
  bool picture = false;   // "upper left" rather than "north-west"
  double pronouns = 0.3;  // how often a class named in the sentence before is "it"
};

// The facts in words, in their order: sentences, or notes in the terse voice. A class has one name
// from beginning to end.
std::string WordFacts(const std::vector<LayoutFact>& facts,
                      const std::vector<ClassInLayout>& classes, Vocabulary vocabulary,
                      const Wording& wording, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_LAYOUT_CAPTION_H_
