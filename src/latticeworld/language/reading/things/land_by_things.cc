#include "latticeworld/language/reading/things/land_by_things.h"

#include <map>
#include <set>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/reading/things/sentence_things.h"

namespace latticeworld {
namespace {

// The class of a phrase's noun, '\0' where the vocabulary has none.
char LetterOf(const Phrase& phrase, Vocabulary vocabulary) {
  const ClassWord* noun = NounOf(phrase).noun;
  return noun == nullptr ? '\0' : noun->LetterIn(vocabulary);
}

}  // namespace

std::vector<LandByThing> LandLeftUnsaid(const std::vector<LandByThing>& by_things,
                                        const std::vector<SaidSentence>& about_land,
                                        Vocabulary vocabulary) {
  std::set<char> named, singly;
  for (const SaidSentence& said : about_land) {
    for (const Phrase* noun : said.sentence.whole.FindAll("noun"))
      named.insert(LetterOf(*noun, vocabulary));
    for (const char* slot : {"x", "y", "z", "end"}) {
      for (const Phrase* thing : said.sentence.whole.FindAll(slot)) {
        if (thing->Has("noun") && IsSaidSingly(*thing)) singly.insert(LetterOf(*thing, vocabulary));
      }
    }
  }
  std::map<char, LandByThing> unsaid;
  for (const LandByThing& each : by_things) {
    const bool is_single = IsSaidSingly(each.land);
    const char letter = LetterOf(each.land, vocabulary);
    if (letter == '\0' || (is_single ? singly : named).count(letter) > 0) continue;
    const auto [known, is_new] = unsaid.emplace(letter, each);
    if (!is_new && is_single && !IsSaidSingly(known->second.land)) known->second = each;
  }
  std::vector<LandByThing> all;
  for (const auto& [letter, each] : unsaid) all.push_back(each);
  return all;
}

}  // namespace latticeworld
