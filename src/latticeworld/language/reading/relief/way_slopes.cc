#include "latticeworld/language/reading/relief/way_slopes.h"

#include <cstddef>

#include "latticeworld/common/text.h"
#include "latticeworld/language/reading/relief/relief_sentence.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {

std::string WithoutWaySlopes(std::string_view text, Vocabulary vocabulary) {
  std::string rest(text);
  std::size_t from = 0;
  for (const std::string& words : SplitSentences(text)) {
    const std::size_t begin = rest.find(words, from);
    if (begin == std::string::npos) continue;
    from = begin + words.size();
    const ReliefSentence sentence(words, vocabulary);
    const std::optional<WaySlope>& slope = sentence.way_slope();
    if (!slope) continue;
    const std::size_t first = sentence.tokens()[slope->begin].begin;
    const std::size_t last = sentence.tokens()[slope->end - 1].end;
    rest.erase(begin + first, last - first);
    from -= last - first;
  }
  return rest;
}

}  // namespace latticeworld
