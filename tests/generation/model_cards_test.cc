// The cards of the shipped models, models/README.md, beside the files.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 45'000'000;  // of all files: what a clone fetches

// The lines of each card by the name of its file: a heading "# layouts.gguf: what it is" begins it.
std::map<std::string, std::vector<std::string>> ReadCards() {
  std::map<std::string, std::vector<std::string>> cards;
  std::string name;
  const auto text = ReadFile(LATTICEWORLD_MODELS "/README.md", 1 << 20);
  EXPECT_TRUE(text.ok()) << text.status().ToString();
  for (const std::string& line : Split(text.ok() ? *text : "", '\n')) {
    if (StartsWith(line, "# ")) name = line.substr(2, line.find(':') - 2);
    cards[name].push_back(line);
  }
  return cards;
}

// 1,440,704
std::string WithCommas(std::uintmax_t number) {
  std::string digits = std::to_string(number);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) digits.insert(at, ",");
  return digits;
}

TEST(ModelCardsTest, EveryModelHasACardWithTheSizeAndDigestOfItsFile) {
  auto cards = ReadCards();
  int models = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(LATTICEWORLD_MODELS)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".gguf" && extension != ".onnx") continue;
    ++models;
    const auto content = ReadFile(entry.path(), kMostBytes);
    ASSERT_TRUE(content.ok()) << entry.path() << ": " << content.status().ToString();
    const std::string row = "| file | " + WithCommas(content->size()) + " bytes, SHA-256 `" +
                            Sha256Hex(*content) + "` |";
    const std::vector<std::string>& card = cards[entry.path().filename().string()];
    EXPECT_EQ(std::count(card.begin(), card.end(), row), 1)
        << "models/README.md needs, once, below the heading '# " << entry.path().filename().string()
        << ": ...', the row\n"
        << row;
  }
  EXPECT_GE(models, 2);
}

TEST(ModelCardsTest, EveryCardIsThatOfAFile) {
  for (const auto& [name, lines] : ReadCards())
    EXPECT_TRUE(fs::is_regular_file(fs::path(LATTICEWORLD_MODELS) / name))
        << "'" << lines.front() << "' names no file of models/";
}

TEST(ModelCardsTest, AllModelsTogetherAreSmall) {
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(LATTICEWORLD_MODELS))
    if (entry.is_regular_file()) bytes += entry.file_size();
  EXPECT_GT(bytes, 0u);
  EXPECT_LE(bytes, kMostBytes);
}

}  // namespace
}  // namespace latticeworld
