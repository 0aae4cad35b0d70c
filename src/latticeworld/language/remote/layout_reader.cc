#include "latticeworld/language/remote/layout_reader.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::size_t kRows = kLayoutSize;
constexpr std::size_t kFewestForRow = 16;       // letters that make a row of what stands alone
constexpr double kLegalShareOfRow = 0.75;       // in what is not all upper case
constexpr std::size_t kFewestForMatrix = 4;     // rows from which on it is meant as one
constexpr std::size_t kEndlessRow = 2 * kRows;  // letters without a break

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool IsSeparator(char c) {
  return IsSpace(c) || c == ',' || c == ';' || c == '|' || c == '"' || c == '\'' || c == '`';
}
bool IsUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
char ToUpper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::vector<std::string> TokensOf(std::string_view line) {
  std::vector<std::string> tokens;
  std::string token;
  for (const char c : line) {
    if (!IsSeparator(c)) {
      token += c;
    } else if (!token.empty()) {
      tokens.push_back(std::exchange(token, ""));
    }
  }
  if (!token.empty()) tokens.push_back(std::move(token));
  return tokens;
}

// "07", "7)", "-": what lists put before a row.
bool IsRowLabel(std::string_view token) {
  const std::string word = ToLowerAscii(token);
  if (word == "row" || word == "line" || word == "-" || word == "*" || word == ">") return true;
  if (token.size() > 4 || !IsDigit(token.front())) return false;
  return std::all_of(token.begin(), token.end(),
                     [](char c) { return IsDigit(c) || c == '.' || c == ')'; });
}

// Takes "Row 7:", a JSON key or "Here is the map:" from before a row.
void DropLabels(std::vector<std::string>* tokens) {
  for (std::size_t i = tokens->size() - 1; i-- > 0;) {
    if ((*tokens)[i].back() != ':') continue;
    tokens->erase(tokens->begin(), tokens->begin() + static_cast<std::ptrdiff_t>(i) + 1);
    break;
  }
  while (tokens->size() > 1 && IsRowLabel(tokens->front())) tokens->erase(tokens->begin());
}

}  // namespace

int LayoutReader::CountLegal(std::string_view text) const {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [this](char c) {
    return FindClass(vocabulary_, ToUpper(c)) != nullptr;
  }));
}

bool LayoutReader::IsLegal(const std::string& row) const {
  return row.size() == kRows && CountLegal(row) == kLayoutSize;
}

bool LayoutReader::LooksLikeRow(std::string_view text) const {
  return text.size() >= kFewestForRow &&
         CountLegal(text) >= kLegalShareOfRow * static_cast<double>(text.size());
}

void LayoutReader::Feed(std::string_view piece) {
  for (const char letter : piece) {
    if (filter_.Push(letter, &passed_) == ThinkingFilter::Action::kDiscardAll) {
      const ThinkingFilter filter = filter_;
      *this = LayoutReader(vocabulary_);
      filter_ = filter;
    }
    for (const char c : passed_) Read(c);
  }
}

void LayoutReader::Finish() {
  for (const char c : filter_.Finish()) Read(c);
  EndLine();
  EndMatrix();
}

int LayoutReader::rows() const {
  // The last row needs no newline.
  const bool at_last_row = current_.size() == kRows - 1 && word_ == kRows && run_ == kRows;
  const std::size_t rows = std::max(at_last_row ? kRows : current_.size(), best_.size());
  return static_cast<int>(std::min(rows, kRows));
}

bool LayoutReader::hopeless() const {
  if (run_ > kEndlessRow) return true;
  return current_.size() > kRows || (current_.size() >= kFewestForMatrix && current_is_bad_);
}

void LayoutReader::Read(char letter) {
  run_ = FindClass(vocabulary_, ToUpper(letter)) != nullptr ? run_ + 1 : 0;
  const std::size_t word = std::exchange(word_, IsSeparator(letter) ? 0 : word_ + 1);
  // "\n" as a JSON string writes it.
  if (std::exchange(backslash_, letter == '\\') && letter == 'n') {
    line_.pop_back();
    run_ = 0;
    return EndLine();
  }
  switch (letter) {
    case '\n': {
      // An empty line parts two matrices, but not the rows of one.
      const bool blank = std::all_of(line_.begin(), line_.end(), IsSpace);
      EndLine();
      if (blank && current_.size() == kRows) EndMatrix();
      return;
    }
    case '[':
    case ']':
    case '{':
    case '}':
      return EndLine();
    case '"':
    case '\'':
      // The end of a JSON string with a row in it: no need to wait for the end of the line.
      if (word >= kFewestForRow) return EndLine();
      line_ += letter;
      return;
    case '`':
      line_ += letter;
      // A Markdown fence begins or ends something else.
      if (line_.size() >= 3 && line_.compare(line_.size() - 3, 3, "```") == 0) {
        EndLine();
        EndMatrix();
      }
      return;
    default:
      line_ += letter;
  }
}

void LayoutReader::EndLine() {
  std::vector<std::string> tokens = TokensOf(line_);
  line_.clear();
  word_ = 0;
  if (tokens.empty()) return;
  DropLabels(&tokens);

  // One or several whole rows.
  const bool all_rows = std::all_of(tokens.begin(), tokens.end(), [this](const std::string& token) {
    return LooksLikeRow(token) ||
           (token.size() >= kFewestForRow && std::all_of(token.begin(), token.end(), IsUpper));
  });
  if (all_rows) {
    for (std::string& token : tokens) Take(std::move(token));
    return;
  }
  // A row in pieces, or one that is too short in the middle of a matrix.
  std::string joined;
  for (const std::string& token : tokens) joined += token;
  const bool short_row = !current_.empty() && current_.size() < kRows &&
                         CountLegal(joined) == static_cast<int>(joined.size());
  if (LooksLikeRow(joined) || short_row) return Take(std::move(joined));
  EndMatrix();
}

void LayoutReader::Take(std::string row) {
  std::transform(row.begin(), row.end(), row.begin(), ToUpper);
  current_is_bad_ = current_is_bad_ || !IsLegal(row);
  current_.push_back(std::move(row));
}

void LayoutReader::EndMatrix() {
  const bool legal = current_.size() == kRows && !current_is_bad_;
  if (legal || (!best_is_legal_ && current_.size() >= best_.size())) {
    best_ = std::move(current_);
    best_is_legal_ = legal;
  }
  current_.clear();
  current_is_bad_ = false;
}

Result<SymbolicLayout> ReadLayoutAnswer(std::string_view text, Vocabulary vocabulary) {
  LayoutReader reader(vocabulary);
  reader.Feed(text);
  reader.Finish();
  if (reader.matrix().empty()) {
    return Status::FromViolations(
        "illegal layout",
        {{"no_matrix", "layout",
          "there is no matrix in the answer " + Quote(text) + "; 32 lines of 32 letters are legal",
          Quote(text)}});
  }
  return ParseLayout(Join(reader.matrix(), "\n"), vocabulary);
}

}  // namespace latticeworld
