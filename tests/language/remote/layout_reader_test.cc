#include "latticeworld/language/remote/layout_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

std::vector<std::string> Rows() {
  std::vector<std::string> rows = Split(LegalMatrix(), '\n');
  rows.pop_back();
  return rows;
}

std::string Spaced(const std::string& row, const std::string& between) {
  std::string text;
  for (const char letter : row) text += (text.empty() ? "" : between) + letter;
  return text;
}

// Every row changed by `change`, joined by `between`.
template <typename Change>
std::string Matrix(const std::string& between, const Change& change) {
  std::vector<std::string> rows = Rows();
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = change(rows[i], i);
  return Join(rows, between);
}
std::string Matrix(const std::string& between) {
  return Matrix(between, [](const std::string& row, std::size_t) { return row; });
}

struct Shape {
  std::string name;
  std::string text;
};

std::vector<Shape> LegalShapes() {
  const std::string matrix = LegalMatrix();
  const std::string other = Matrix("\n", [](std::string row, std::size_t) {
    std::rotate(row.begin(), row.begin() + 5, row.end());
    return row;
  });
  const std::string json = "{\"rows\": [\"" + Matrix("\", \"") + "\"]}";
  return {
      {"plain", matrix},
      {"no newline at the end", Matrix("\n")},
      {"CRLF", Matrix("\r\n") + "\r\n"},
      {"spaces around", "\n\n  " + Matrix("  \n  ") + "  \n\n"},
      {"fence", "```\n" + matrix + "```\n"},
      {"fence with a language", "```text\n" + matrix + "```"},
      {"fence that is not closed", "```\n" + matrix},
      {"fence right after the last row", "```\n" + Matrix("\n") + "```"},
      {"prose before", "Sure! Here is the map, with a lake in the north:\n\n" + matrix},
      {"a word of legal letters before", "DRAB\n" + matrix},
      {"prose after", matrix + "\nThe river (W) runs from north to south.\nAnything else?\n"},
      {"prose and fence", "Here it is:\n```\n" + matrix + "```\nA road crosses it. GOOD LUCK!\n"},
      {"thinking", "<think>\nRow 1: GGGG... no\n" + other + "\n</think>\n\n" + matrix},
      {"thinking whose opening mark the template has", other + "\nhm\n</think>\n" + matrix},
      {"JSON", json},
      {"JSON in a fence", "```json\n" + json + "\n```\nDone."},
      {"JSON over many lines", "{\n  \"rows\": [\n    \"" + Matrix("\",\n    \"") + "\"\n  ]\n}\n"},
      {"JSON array alone", "[\"" + Matrix("\",\"") + "\"]"},
      {"JSON string with escaped newlines", "{\"layout\": \"" + Matrix("\\n") + "\\n\"}"},
      {"JSON arrays of letters",
       "[[\"" +
           Matrix("\"], [\"",
                  [](const std::string& row, std::size_t) { return Spaced(row, "\",\""); }) +
           "\"]]"},
      {"Python list", "rows = ['" + Matrix("', '") + "']"},
      {"spaces between letters",
       Matrix("\n", [](const std::string& row, std::size_t) { return Spaced(row, " "); })},
      {"commas between letters",
       Matrix("\n", [](const std::string& row, std::size_t) { return Spaced(row, ", "); })},
      {"Markdown table",
       Matrix("\n", [](const std::string& row,
                       std::size_t) { return "| " + Spaced(row, " | ") + " |"; })},
      {"groups of eight", Matrix("\n",
                                 [](std::string row, std::size_t) {
                                   for (std::size_t at : {24, 16, 8}) row.insert(at, " ");
                                   return row;
                                 })},
      {"numbered rows",
       Matrix("\n", [](const std::string& row,
                       std::size_t i) { return std::to_string(i + 1) + ". " + row; })},
      {"labelled rows",
       Matrix("\n", [](const std::string& row,
                       std::size_t i) { return "Row " + std::to_string(i + 1) + ": " + row; })},
      {"lower case",
       Matrix("\n", [](const std::string& row, std::size_t) { return ToLowerAscii(row); })},
      {"empty lines between rows", Matrix("\n\n")},
      {"backticks around rows", "`" + Matrix("`\n`") + "`"},
      {"a draft that is bad, then the answer",
       MatrixWithRow(3, "GGG") + "\nWait, line 4 is too short. Again:\n" + matrix},
      {"two matrices, the last one counts", other + "\n\nImproved:\n\n" + matrix},
      {"two matrices with an empty line between", other + "\n\n" + matrix},
      {"the answer, then a bad afterthought", matrix + "\nOr perhaps:\n" + MatrixWithRow(0, "AB")},
  };
}

TEST(LayoutReaderTest, ReadsEveryShapeInWhichAMatrixComes) {
  for (const Shape& shape : LegalShapes()) {
    const auto layout = ReadLayoutAnswer(shape.text, Vocabulary::kSuburb);
    ASSERT_TRUE(layout.ok()) << shape.name << ": " << layout.status().ToString();
    EXPECT_EQ(ToText(*layout), LegalMatrix()) << shape.name;
  }
}

TEST(LayoutReaderTest, ReadsTheSameInWhateverPiecesItComes) {
  for (const Shape& shape : LegalShapes()) {
    for (std::size_t size : {1, 2, 3, 31, 33, 64}) {
      LayoutReader reader(Vocabulary::kSuburb);
      for (std::size_t at = 0; at < shape.text.size(); at += size) {
        reader.Feed(std::string_view(shape.text).substr(at, size));
      }
      reader.Finish();
      EXPECT_EQ(reader.matrix(), Rows()) << shape.name << " in pieces of " << size;
    }
  }
}

struct Refusal {
  std::string name;
  std::string text;
  std::string code;
  std::string pointer;
};

TEST(LayoutReaderTest, RefusesEveryOtherAnswerAndSaysWhatIsWrong) {
  const std::vector<std::string> rows = Rows();
  const auto first = [&rows](std::size_t count) {
    return Join(std::vector<std::string>(rows.begin(), rows.begin() + static_cast<long>(count)),
                "\n");
  };
  const Refusal refusals[] = {
      {"empty", "", "no_matrix", "layout"},
      {"prose", "I cannot draw maps. BAD LUCK, A FRIEND said.", "no_matrix", "layout"},
      {"only thinking", "<think>" + LegalMatrix(), "no_matrix", "layout"},
      {"only thinking that the template opened", LegalMatrix() + "</think>Sorry.", "no_matrix",
       "layout"},
      {"a foreign letter", MatrixWithRow(6, "GGGGGGGGGGSGGGGGGGGGGGGGGGGGGGGG"), "foreign_letter",
       "row 7, column 11"},
      {"a row of foreign letters", MatrixWithRow(6, std::string(32, 'S')), "foreign_letter",
       "row 7, column 1"},
      {"a sign in a row", MatrixWithRow(1, "GGGGGGGG?GGGGGGGGGGGGGGGGGGGGGGG"), "foreign_letter",
       "row 2, column 9"},
      {"a short row", MatrixWithRow(30, std::string(31, 'G')), "wrong_line_length", "row 31"},
      {"a very short row", MatrixWithRow(4, "GGG"), "wrong_line_length", "row 5"},
      {"a long row", MatrixWithRow(0, std::string(33, 'G')), "wrong_line_length", "row 1"},
      {"31 rows", first(31), "wrong_line_count", "layout"},
      {"33 rows", LegalMatrix() + rows[4] + "\n", "wrong_line_count", "layout"},
      {"33 rows in JSON", "[\"" + Matrix("\",\n\"") + "\",\n\"" + rows[1] + "\"]",
       "wrong_line_count", "layout"},
      {"cut in a row", first(20) + "\n" + rows[20].substr(0, 9), "wrong_line_count", "layout"},
      {"cut JSON", "{\"rows\": [\"" + LegalMatrix().substr(0, 32) + "\", \"GGG", "wrong_line_count",
       "layout"},
      {"64 rows", LegalMatrix() + LegalMatrix(), "wrong_line_count", "layout"},
  };
  for (const Refusal& refusal : refusals) {
    const auto layout = ReadLayoutAnswer(refusal.text, Vocabulary::kSuburb);
    ASSERT_FALSE(layout.ok()) << refusal.name;
    EXPECT_EQ(layout.status().code(), StatusCode::kInvalidArgument);
    const auto& violations = layout.status().violations();
    EXPECT_TRUE(std::any_of(violations.begin(), violations.end(),
                            [&](const Violation& violation) {
                              return violation.code == refusal.code &&
                                     violation.pointer == refusal.pointer;
                            }))
        << refusal.name << ": " << layout.status().ToString();
  }
}

TEST(LayoutReaderTest, SaysHowManyRowsHaveComeAndGivesUpOnWhatCannotBecomeLegal) {
  LayoutReader reader(Vocabulary::kSuburb);
  reader.Feed("Here you are:\n```\n");
  EXPECT_EQ(reader.rows(), 0);
  const std::string good = std::string(32, 'G') + "\n";
  reader.Feed(good + good + good);
  EXPECT_EQ(reader.rows(), 3);
  EXPECT_FALSE(reader.hopeless());
  reader.Feed(std::string(30, 'G') + "\n");
  EXPECT_TRUE(reader.hopeless());
}

TEST(LayoutReaderTest, CountsTheRowsOfJsonAsTheirStringsEnd) {
  LayoutReader reader(Vocabulary::kSuburb);
  reader.Feed("{\"rows\":[\"" + Rows()[0] + "\",\"" + Rows()[1] + "\",\"GGG");
  EXPECT_EQ(reader.rows(), 2);
}

TEST(LayoutReaderTest, NeverGivesUpOnALegalAnswer) {
  for (const Shape& shape : LegalShapes()) {
    if (shape.name.find("bad") != std::string::npos) continue;
    LayoutReader reader(Vocabulary::kSuburb);
    for (const char letter : shape.text) {
      reader.Feed(std::string_view(&letter, 1));
      ASSERT_FALSE(reader.hopeless()) << shape.name;
    }
  }
}

TEST(LayoutReaderTest, GivesUpOnRowsWithoutEndAndTooManyRows) {
  LayoutReader endless(Vocabulary::kSuburb);
  endless.Feed(std::string(64, 'G'));
  EXPECT_FALSE(endless.hopeless());
  endless.Feed("G");
  EXPECT_TRUE(endless.hopeless());
  LayoutReader many(Vocabulary::kSuburb);
  many.Feed(LegalMatrix());
  EXPECT_FALSE(many.hopeless());
  EXPECT_EQ(many.rows(), 32);
  many.Feed(Rows()[0] + "\n");
  EXPECT_TRUE(many.hopeless());
  EXPECT_EQ(many.rows(), 32);
}

TEST(LayoutReaderTest, DoesNotGiveUpOverDraftsInThinkingOrProse) {
  LayoutReader reader(Vocabulary::kSuburb);
  reader.Feed("<think>" + std::string(500, 'G') + "\n" + MatrixWithRow(2, "XX") + "</think>\n");
  reader.Feed("The first row, GGGGGGGGGGGGGGGGGGGGGGGGGGGGG, is too short; the second\n");
  reader.Feed(std::string(31, 'G') + "\nis too.\n");
  EXPECT_FALSE(reader.hopeless());
  reader.Feed(LegalMatrix());
  EXPECT_FALSE(reader.hopeless());
  EXPECT_EQ(reader.rows(), 32);
}

TEST(LayoutReaderTest, NoiseGivesALegalLayoutOrViolations) {
  const std::string letters = "ABDFGRWSXabz 09\"'[]{}\\n\r\n\n`,|<>/think:-\x80\xFF";
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(seed, "noise");
    // Random letters, or a legal answer that is cut, torn and sprinkled with them.
    const auto shapes = LegalShapes();
    std::string text = random.Chance(0.3) ? ""
                                          : shapes[static_cast<std::size_t>(random.UniformInt(
                                                       0, static_cast<int>(shapes.size()) - 1))]
                                                .text;
    const int edits = random.UniformInt(0, 5) * (text.empty() ? 400 : 2);
    for (int i = 0; i < edits; ++i) {
      const auto at = static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(text.size())));
      text.insert(at, 1,
                  letters[static_cast<std::size_t>(
                      random.UniformInt(0, static_cast<int>(letters.size()) - 1))]);
    }
    if (random.Chance(0.5)) {
      text.resize(static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(text.size()))));
    }
    const auto layout = ReadLayoutAnswer(text, Vocabulary::kSuburb);
    if (layout.ok()) {
      EXPECT_TRUE(ParseLayout(ToText(*layout), Vocabulary::kSuburb).ok()) << seed;
    } else {
      EXPECT_FALSE(layout.status().violations().empty()) << seed;
    }
  }
}

}  // namespace
}  // namespace latticeworld
