// Files that were made to do harm, or were no catalogue to begin with.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "catalogue/larch.h"
#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

using Strings = std::vector<std::string>;

std::string Repeat(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(HostileCatalogueTest, RefusesWhatIsNoJson) {
  const Strings parse_error = {"parse_error user.json#"};
  for (const char* text :
       {"", " ", "{", "[1,", "nonsense", "{\"type\": \"forest\"} x", "{'type': 1}",
        "{\"type\": NaN}", "{\"type\": 1e400}", "// a comment\n{}"}) {
    EXPECT_EQ(FaultsOf(std::string(text)), parse_error) << text;
  }
}

TEST(HostileCatalogueTest, RefusesJsonThatIsNoCatalogue) {
  EXPECT_EQ(FaultsOf("[]"), Strings({"wrong_type user.json#"}));
  EXPECT_EQ(FaultsOf("null"), Strings({"wrong_type user.json#"}));
  EXPECT_EQ(FaultsOf("{}"), Strings({"missing_key user.json#/type"}));
  EXPECT_EQ(FaultsOf(R"({"type": "moon"})"), Strings({"unknown_value user.json#/type"}));
}

TEST(HostileCatalogueTest, RefusesBinaries) {
  EXPECT_EQ(FaultsOf(std::string("\x7f"
                                 "ELF\x02\x01\x01\x00\x00",
                                 9)),
            Strings({"bad_encoding user.json#"}));
  EXPECT_EQ(FaultsOf(std::string("\xff\xfe{}")), Strings({"bad_encoding user.json#"}));
}

TEST(HostileCatalogueTest, RefusesNumbersBeyondDouble) {
  std::string text = LarchFile();
  text.replace(text.find("0.45"), 4, "1e400");
  EXPECT_EQ(FaultsOf(text), Strings({"parse_error user.json#"}));
}

TEST(HostileCatalogueTest, RefusesFilesThatAreTooLong) {
  EXPECT_EQ(FaultsOf(std::string((4 << 20) + 1, ' ')), Strings({"too_long user.json#"}));
}

TEST(HostileCatalogueTest, DepthCostsNothing) {
  for (const char* pair : {"[]", "{}"}) {
    const bool is_array = pair[0] == '[';
    const std::string open = is_array ? "[" : "{\"a\":";
    const int depth = 200000;
    const std::string text = Repeat(open, depth) + "1" + Repeat(std::string(1, pair[1]), depth);
    const Strings faults = FaultsOf(text);
    ASSERT_FALSE(faults.empty());
    EXPECT_EQ(faults.front().rfind("too_deep user.json#", 0), 0u) << faults.front();
    EXPECT_LE(faults.size(), 4u);
  }
}

TEST(HostileCatalogueTest, BreadthCostsLittle) {
  // Half a million elements, each of the wrong type; 100,000 unknown keys; and as many twice.
  const Strings elements =
      FaultsOf("{\"type\": \"road\", \"models\": [" + Repeat("1,", 500000) + "1]}");
  EXPECT_LE(elements.size(), 501u);
  EXPECT_NE(std::find(elements.begin(), elements.end(), "wrong_count user.json#/models"),
            elements.end());
  std::string keys = "{\"type\": \"road\"";
  for (int i = 0; i < 100000; ++i) keys += ",\"k" + std::to_string(i) + "\":0";
  EXPECT_LE(FaultsOf(keys + "}").size(), 501u);
  const Strings twice = FaultsOf("{\"type\": \"road\"" + Repeat(",\"a\":0", 100000) + "}");
  EXPECT_EQ(twice, Strings({"duplicate_key user.json#/a", "unknown_key user.json#/a"}));
}

// All pairs of these names are equal: eight million in a file of a megabyte.
TEST(HostileCatalogueTest, EqualNamesCostLittle) {
  const std::string variant = "{\"models\": [" + Repeat("\"a\",", 255) + "\"a\"]}";
  const Strings faults = FaultsOf("{\"type\": \"forest\", \"season_variants\": [" +
                                  Repeat(variant + ",", 254) + variant + "]}");
  EXPECT_EQ(faults.size(), 501u);
  for (const std::string& fault : faults) EXPECT_EQ(fault.find("duplicate_value"), fault.npos);
}

TEST(HostileCatalogueTest, NoFurtherFileIsReadAfterEnoughFaults) {
  std::string faulty = "{\"type\": \"road\", \"materials\": [";
  for (int i = 0; i < 100; ++i) faulty += "{},";
  faulty += "{}]}";
  std::vector<CatalogueFile> files;
  for (int i = 0; i < 9; ++i) files.push_back({std::to_string(i), faulty});
  const auto catalogue = Catalogue::Extended(files);
  const std::vector<Violation>& violations = catalogue.status().violations();
  ASSERT_EQ(violations.size(), 502u);
  EXPECT_EQ(violations[500].message, "and 207 further violations");  // of one file
  EXPECT_EQ(violations[501].code, "unread_files");
  EXPECT_EQ(violations[501].given, "8");
}

TEST(HostileCatalogueTest, RefusesTooMuchInAll) {
  std::vector<CatalogueFile> files;
  for (int i = 0; i < 9; ++i) files.push_back({std::to_string(i), std::string(4 << 20, ' ')});
  EXPECT_EQ(FaultsOf(files), Strings({"too_long "}));
}

TEST(HostileCatalogueTest, LongNamesAreNotRepeatedInFull) {
  const std::string name(1 << 20, 'n');
  const auto catalogue =
      Catalogue::Extended({{"user.json", "{\"type\": \"road\", \"" + name + "\": 1}"}});
  ASSERT_FALSE(catalogue.ok());
  EXPECT_LT(catalogue.status().message().size(), 1000u);
  const auto value = Catalogue::Extended(
      {{"user.json", "{\"type\": \"road\", \"materials\": [{\"name\": \"" + name + "\"}]}"}});
  ASSERT_FALSE(value.ok());
  EXPECT_LT(value.status().message().size(), 5000u);
}

// A legal file with bytes changed, cut or doubled at random is read or refused, never more.
TEST(HostileCatalogueTest, SurvivesDamagedFiles) {
  RandomStream random(20261121, "tests/damaged catalogue files");
  for (int trial = 0; trial < 300; ++trial) {
    std::string text = LarchFile();
    const int damages = 1 + static_cast<int>(random.Uniform(0.0, 4.0));
    for (int i = 0; i < damages; ++i) {
      const auto at = static_cast<std::size_t>(random.Uniform() * static_cast<double>(text.size()));
      const double choice = random.Uniform();
      if (choice < 0.4) {
        text[at] = "{}[]\",:0-.eE#\\ntf\x01\xc3"[static_cast<std::size_t>(random.Uniform(0, 19))];
      } else if (choice < 0.6) {
        text.erase(at, static_cast<std::size_t>(random.Uniform(1.0, 40.0)));
      } else if (choice < 0.8) {
        text.insert(at, text.substr(at, static_cast<std::size_t>(random.Uniform(1.0, 40.0))));
      } else {
        text.resize(at + 1);
      }
    }
    FaultsOf(text);  // every fault has its message; see there
  }
}

TEST(HostileCatalogueTest, RefusesFileNamesThatCannotBePrinted) {
  for (const std::string& name : {std::string(), std::string("a\nb"), std::string("\xff"),
                                  std::string("a\x1b[2J"), std::string(256, 'n')}) {
    EXPECT_EQ(FaultsOf(std::vector<CatalogueFile>{{name, R"({"type": "road"})"}}),
              Strings({"bad_format "}));
  }
}

TEST(HostileCatalogueTest, RefusesTooManyFiles) {
  std::vector<CatalogueFile> files;
  for (int i = 0; i < 300; ++i) files.push_back({std::to_string(i), R"({"type": "road"})"});
  EXPECT_EQ(FaultsOf(files), Strings({"wrong_count "}));
}

}  // namespace
}  // namespace latticeworld
