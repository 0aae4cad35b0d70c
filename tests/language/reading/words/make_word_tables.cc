// Prints what a file of words holds below its comments. Usage: make_word_tables topics|subjects
// EXAMPLES

#include <cstdio>
#include <string>

#include "language/reading/words/word_tables.h"

int main(int argc, char** argv) {
  const std::string which = argc == 3 ? argv[1] : "";
  if (which != "topics" && which != "subjects") {
    std::fprintf(stderr, "usage: %s topics|subjects EXAMPLES\n", argv[0]);
    return 2;
  }
  const std::string table =
      which == "topics" ? latticeworld::TopicTable(argv[2]) : latticeworld::SubjectTable(argv[2]);
  std::fputs(table.c_str(), stdout);
  return 0;
}
