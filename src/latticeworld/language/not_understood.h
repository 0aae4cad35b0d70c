#ifndef LATTICEWORLD_LANGUAGE_NOT_UNDERSTOOD_H_
#define LATTICEWORLD_LANGUAGE_NOT_UNDERSTOOD_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace latticeworld {

// Collects the words that a parser could not read into warnings that quote them.
class NotUnderstood {
 public:
  explicit NotUnderstood(std::string_view instruction) : instruction_(instruction) {}

  // Bytes [begin, end) of the instruction; words without a Close between them are quoted together.
  void Add(std::size_t begin, std::size_t end);
  void Close();
  // Appends at most kMaxWarnings warnings, then one that counts the others.
  void AppendTo(std::vector<std::string>* warnings);

  static constexpr std::size_t kMaxWarnings = 20;

 private:
  std::string_view instruction_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool open_ = false;
  std::vector<std::string> warnings_;
  std::size_t left_out_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_NOT_UNDERSTOOD_H_
