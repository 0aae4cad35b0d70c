#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"

namespace latticeworld {

// Made by the build: data/class_words.txt.
std::string_view WordFile(std::string_view file_name);

namespace {

constexpr std::size_t kFields = 5;
constexpr int kMaxCells = 1024;  // of a layout

class LineReader {
 public:
  explicit LineReader(std::vector<Violation>* violations) : violations_(violations) {}

  void Read(int number, std::string_view line, std::vector<ClassWord>* words) {
    number_ = number;
    failed_ = false;
    std::array<std::string_view, kFields> fields;
    std::size_t count = 0;
    for (std::string_view rest = line; count < kFields; ++count) {
      const std::size_t tab = rest.find('\t');
      fields[count] = rest.substr(0, tab);
      if (tab == std::string_view::npos) {
        ++count;
        break;
      }
      rest.remove_prefix(tab + 1);
      if (count + 1 == kFields) ++count;
    }
    if (count != kFields || fields[kFields - 1].find('\t') != std::string_view::npos) {
      Fail("wrong_field_count", "must have 5 fields apart by tabs", line);
      return;
    }
    ClassWord word{};
    word.phrase = ReadPhrase(fields[0]);
    std::tie(word.suburb, word.suburb_exact) = ReadLetter(Vocabulary::kSuburb, fields[1]);
    std::tie(word.wild, word.wild_exact) = ReadLetter(Vocabulary::kWild, fields[2]);
    const std::optional<WordShape> shape = ReadForm(fields[3]);
    word.shape = shape.value_or(WordShape::kMass);
    if (shape.has_value()) word.cells = ReadCells(*shape, fields[4]);
    if (word.suburb == '\0' && word.wild == '\0' && !failed_) {
      Fail("no_class", "must name a class in one vocabulary at least", line);
    }
    if (!failed_) words->push_back(word);
  }

 private:
  void Fail(std::string code, std::string message, std::string_view given) {
    violations_->push_back({std::move(code), "line " + std::to_string(number_),
                            std::move(message) + ", not " + Quote(given), std::string(given)});
    failed_ = true;
  }

  std::string_view ReadPhrase(std::string_view field) {
    const std::vector<Token> tokens = Tokenize(field);
    if (tokens.empty() || JoinWords(tokens, 0, tokens.size()) != field) {
      Fail("bad_phrase", "the phrase must be lower case words with single spaces", field);
    } else if (!phrases_.insert(field).second) {
      Fail("repeated_phrase", "the phrase must stand in the file once", field);
    }
    return field;
  }

  std::pair<char, bool> ReadLetter(Vocabulary vocabulary, std::string_view field) {
    if (field == "-") return {'\0', false};
    const bool legal = field.size() == 2 && (field[1] == '=' || field[1] == '~') &&
                       FindClass(vocabulary, field[0]) != nullptr;
    if (!legal) {
      Fail("bad_letter",
           "must be a letter of the " + std::string(NameOf(vocabulary)) +
               " vocabulary and \"=\" or \"~\", or \"-\"",
           field);
      return {'\0', false};
    }
    return {field[0], field[1] == '='};
  }

  std::optional<WordShape> ReadForm(std::string_view field) {
    if (field == "spread") return WordShape::kMass;
    if (field == "patch") return WordShape::kThing;
    if (field == "line") return WordShape::kLine;
    Fail("bad_form", "the form must be spread, patch or line", field);
    return std::nullopt;
  }

  int ReadCells(WordShape shape, std::string_view field) {
    int cells = -1;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), cells);
    const bool number = error == std::errc() && end == field.data() + field.size();
    const bool line = shape == WordShape::kLine;
    if (!number || (line ? cells != 0 : cells < 1 || cells > kMaxCells)) {
      Fail("bad_cells", line ? "the cells of a line must be 0" : "the cells must be 1 to 1024",
           field);
    }
    return cells;
  }

  std::vector<Violation>* violations_;
  int number_ = 0;
  bool failed_ = false;
  std::set<std::string_view> phrases_;
};

}  // namespace

Result<std::vector<ClassWord>> ReadClassWords(std::string_view text) {
  std::vector<ClassWord> words;
  std::vector<Violation> violations;
  LineReader reader(&violations);
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.front() != '#') reader.Read(number, line, &words);
  }
  if (!violations.empty()) return Status::FromViolations("class words", std::move(violations));
  return words;
}

std::string_view ClassWordFile() { return WordFile("class_words.txt"); }

const std::vector<ClassWord>& AllClassWords() {
  static const std::vector<ClassWord> words = [] {
    Result<std::vector<ClassWord>> read = ReadClassWords(ClassWordFile());
    LW_CHECK(read.ok(), read.status().ToString());
    return *std::move(read);
  }();
  return words;
}

}  // namespace latticeworld
