#ifndef LATTICEWORLD_LANGUAGE_READING_WORDS_TABLE_WORDS_H_
#define LATTICEWORLD_LANGUAGE_READING_WORDS_TABLE_WORDS_H_

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace latticeworld {

// Tables of words that are counted in the examples that the reader was taught
// (data/subject_words.txt, data/topic_words.txt).

// Returns the words of a text as the tables have them: runs of the letters a to z, in lower case
// and the singular.
std::set<std::string> TableWordsOf(std::string_view text);

// Returns the lines of a table that are neither blank nor a comment: what stands before the tab,
// and the words behind it.
std::vector<std::pair<std::string, std::vector<std::string>>> LinesOfTable(std::string_view table);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_WORDS_TABLE_WORDS_H_
