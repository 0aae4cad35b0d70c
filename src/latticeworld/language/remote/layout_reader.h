#ifndef LATTICEWORLD_LANGUAGE_REMOTE_LAYOUT_READER_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_LAYOUT_READER_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/remote/thinking_filter.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// LayoutReader finds the matrix in an answer, letter by letter as it arrives. It reads plain lines
// and JSON strings alike, with thinking, prose and Markdown fences around, CRLF, spaces, commas or
// bars between letters, and line numbers before them. Lower case counts as upper case: no
// vocabulary tells them apart, so nothing is guessed. If there are several matrices, the last legal
// one counts, or without one the longest (of equally long ones the last).
class LayoutReader {
 public:
  explicit LayoutReader(Vocabulary vocabulary) : vocabulary_(vocabulary) {}

  void Feed(std::string_view piece);
  // Ends the answer.
  void Finish();

  // Returns how many rows the matrix that is being written has, or the best one so far where that
  // has more.
  int rows() const;
  // Returns whether what is being written can no longer become legal: a matrix of at least four
  // rows with a bad one among them or with too many, or a row that does not end.
  bool hopeless() const;
  // Returns the rows of the matrix that counts; empty when there is none. To be called after
  // Finish.
  const std::vector<std::string>& matrix() const { return best_; }

 private:
  void Read(char letter);
  void EndLine();
  void EndMatrix();
  void Take(std::string row);
  bool LooksLikeRow(std::string_view text) const;
  bool IsLegal(const std::string& row) const;
  int CountLegal(std::string_view text) const;

  Vocabulary vocabulary_;
  ThinkingFilter filter_;
  std::string passed_;
  std::string line_;
  bool backslash_ = false;  // the letter before was one
  std::size_t word_ = 0;    // letters since the last separator
  std::size_t run_ = 0;     // letters of the vocabulary since any other character
  std::vector<std::string> current_;
  bool current_is_bad_ = false;  // holds a row that is not legal
  std::vector<std::string> best_;
  bool best_is_legal_ = false;
};

// Reads the layout of a whole answer. Errors: INVALID_ARGUMENT with every violation, as ParseLayout
// gives them, or no_matrix when the answer holds nothing like a matrix.
Result<SymbolicLayout> ReadLayoutAnswer(std::string_view text, Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_LAYOUT_READER_H_
