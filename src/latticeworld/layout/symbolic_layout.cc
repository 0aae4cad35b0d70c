#include "latticeworld/layout/symbolic_layout.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {

Result<SymbolicLayout> ParseLayout(std::string_view text, Vocabulary vocabulary) {
  std::vector<std::string> lines = Split(text, '\n');
  if (lines.back().empty()) lines.pop_back();
  std::vector<Violation> violations;
  if (lines.size() != kLayoutSize) {
    violations.push_back({"wrong_line_count", "layout",
                          "has " + std::to_string(lines.size()) + " lines; " +
                              std::to_string(kLayoutSize) + " are legal",
                          std::to_string(lines.size())});
  }
  SymbolicLayout layout{vocabulary, Grid<char>(kLayoutSize, kLayoutSize, '?')};
  // Beyond a screenful of lines and columns, further violations would tell nothing new.
  const int rows = static_cast<int>(std::min<std::size_t>(lines.size(), 2 * kLayoutSize));
  for (int row = 0; row < rows; ++row) {
    std::string& line = lines[static_cast<std::size_t>(row)];
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::string where = "row " + std::to_string(row + 1);
    if (line.size() != kLayoutSize) {
      violations.push_back({"wrong_line_length", where,
                            "has " + std::to_string(line.size()) + " letters; " +
                                std::to_string(kLayoutSize) + " are legal",
                            Quote(line)});
    }
    const int cols = static_cast<int>(std::min<std::size_t>(line.size(), 2 * kLayoutSize));
    for (int col = 0; col < cols; ++col) {
      const char letter = line[static_cast<std::size_t>(col)];
      if (FindClass(vocabulary, letter) == nullptr) {
        const std::string given = Quote(std::string_view(&line[static_cast<std::size_t>(col)], 1));
        violations.push_back({"foreign_letter", where + ", column " + std::to_string(col + 1),
                              given + " is no letter of the " + std::string(NameOf(vocabulary)) +
                                  " vocabulary; legal are " + std::string(LegalLetters(vocabulary)),
                              given});
      } else if (row < kLayoutSize && col < kLayoutSize) {
        layout.cells(row, col) = letter;
      }
    }
  }
  if (!violations.empty()) return Status::FromViolations("illegal layout", std::move(violations));
  return layout;
}

std::string ToText(const SymbolicLayout& layout) {
  std::string text;
  text.reserve(kLayoutSize * (kLayoutSize + 1));
  for (int row = 0; row < kLayoutSize; ++row) {
    text.append(layout.cells.row(row), kLayoutSize);
    text += '\n';
  }
  return text;
}

std::string ToColoredText(const SymbolicLayout& layout) {
  std::string text;
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      const char letter = layout.cells(row, col);
      const LayoutClass* entry = FindClass(layout.vocabulary, letter);
      const Rgb color = entry != nullptr ? entry->color : Rgb{};
      const bool light = color.r + color.g + color.b > 330;
      text += "\033[48;2;" + std::to_string(color.r) + ";" + std::to_string(color.g) + ";" +
              std::to_string(color.b) + (light ? "m\033[30m" : "m\033[97m") + letter + letter;
    }
    text += "\033[0m\n";
  }
  return text;
}

}  // namespace latticeworld
