#ifndef LATTICEWORLD_TESTS_LANGUAGE_READING_WORDS_WORD_TABLES_H_
#define LATTICEWORLD_TESTS_LANGUAGE_READING_WORDS_WORD_TABLES_H_

#include <filesystem>
#include <string>

namespace latticeworld {

// What files of words hold below their comments, made of all examples for readers in a folder
// (training/examples: *.jsonl).

// data/topic_words.txt. A word is one of a topic if at least eight texts have both, and the topic
// is in the texts with the word eight times as often as in all, or in two fifths of them. Texts of
// layouts count as texts of no topic. The words of the topic's own name are its words as well. A
// topic of less than twenty texts has no words.
std::string TopicTable(const std::filesystem::path& examples);

// data/subject_words.txt. The weight of a word is the natural logarithm of how much more frequent
// the sentences with it are in texts of environments than in texts of layouts, rounded to a tenth
// and at most 3 in size. Words of less than twenty sentences, and those with less than 1, have
// none.
std::string SubjectTable(const std::filesystem::path& examples);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_READING_WORDS_WORD_TABLES_H_
