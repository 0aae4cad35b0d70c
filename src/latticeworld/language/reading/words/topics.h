#ifndef LATTICEWORLD_LANGUAGE_READING_WORDS_TOPICS_H_
#define LATTICEWORLD_LANGUAGE_READING_WORDS_TOPICS_H_

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace latticeworld {

// A topic is what a sentence of an environment speaks of, without how much or where: "goblin",
// "season winter", "grass dry", "forest density", "lake level", "wind".

// Returns the topics of a sentence of the small language, each once; a sentence with "or" has
// several. Empty: the sentence fits no form of environments.
std::vector<std::string> TopicsOf(std::string_view sentence);

// Returns the words of a topic's name, without those of what a value is of: of "forest maple" it is
// maple, for who says forest may speak of land.
std::set<std::string> OwnWordsOf(const std::string& topic);

// Whether one of the words (TableWordsOf, table_words.h) is one with which people speak of the
// topic: those of data/topic_words.txt, which is made of the examples that the reader was taught;
// its own where that has none.
bool SpeakOf(const std::set<std::string>& words, const std::string& topic);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_WORDS_TOPICS_H_
