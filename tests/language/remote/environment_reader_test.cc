#include "latticeworld/language/remote/environment_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "language/remote/fake_chat_server.h"
#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

std::string Replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(EnvironmentReaderTest, ReadsEveryShapeInWhichAnObjectComes) {
  const std::string json = LegalEnvironment();
  std::string crlf;
  for (const char c : json) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::string other = Replaced(json, "\"sunny\"", "\"rain\"");
  const std::pair<std::string, std::string> shapes[] = {
      {"plain", json},
      {"CRLF", crlf},
      {"fence", "```\n" + json + "```"},
      {"fence with a language", "```json\n" + json + "\n```\n"},
      {"fence that is not closed", "```json\n" + json},
      {"prose around", "Here is {the configuration}:\n" + json + "\nIt's set in autumn :-}"},
      {"thinking", "<think>{\"coarse\": {}} or " + other + "</think>" + json},
      {"thinking that the template opened", other + "</think>" + json},
      {"two objects, the last legal one counts", other + "\nBetter:\n" + json},
      {"a bad afterthought", json + "\nOr: {\"coarse\": 1}"},
      {"a longer bad afterthought",
       json + "\nOr: " + Replaced(json, "\"coarse\"", "\"the mood of it all\": 1, \"coarse\"")},
      {"a brace that prose leaves open", "The set {a, b is left open. " + json},
  };
  for (const auto& [name, text] : shapes) {
    const auto environment = ReadEnvironmentAnswer(text);
    ASSERT_TRUE(environment.ok()) << name << ": " << environment.status().ToString();
    EXPECT_EQ(ToJson(*environment), json) << name;
  }
}

TEST(EnvironmentReaderTest, RefusesEveryOtherAnswerAndSaysWhatIsWrong) {
  const std::string json = LegalEnvironment();
  struct Refusal {
    std::string name, text, code, pointer;
  };
  const Refusal refusals[] = {
      {"empty", "", "no_object", ""},
      {"prose", "I am a language model.", "no_object", ""},
      {"only thinking", "<think>" + json, "no_object", ""},
      {"cut", json.substr(0, json.size() / 2), "parse_error", ""},
      {"half a string", "{\"coarse\": {\"season\": \"aut", "parse_error", ""},
      {"an unknown key", Replaced(json, "\"coarse\": {", "\"coarse\": {\"mood\": 1,"),
       "unknown_key", "/coarse/mood"},
      {"an unknown key whose text has a quote and a brace",
       Replaced(json, "\"coarse\"", "\"note\": \"\\\"}\", \"coarse\""), "unknown_key", "/note"},
      {"a key twice", Replaced(json, "\"agents\"", "\"agents\": [], \"agents\""), "duplicate_key",
       "/agents"},
      {"another season", Replaced(json, "\"autumn\"", "\"winter\""), "conflict",
       "/fine/forest/season_variant"},
      {"an invented weather", Replaced(json, "\"sunny\"", "\"balmy\""), "unknown_value",
       "/coarse/weather"},
      {"a goblin that grazes", Replaced(json, "\"sheep\"", "\"goblin\""), "conflict",
       "/agents/0/state"},
      {"too many", Replaced(json, "\"quantity\": 9", "\"quantity\": 900"), "out_of_range",
       "/agents/0/quantity"},
      {"a JSON array", "[1, 2]", "no_object", ""},
  };
  for (const Refusal& refusal : refusals) {
    const auto environment = ReadEnvironmentAnswer(refusal.text);
    ASSERT_FALSE(environment.ok()) << refusal.name;
    EXPECT_EQ(environment.status().code(), StatusCode::kInvalidArgument);
    const auto& violations = environment.status().violations();
    EXPECT_TRUE(std::any_of(violations.begin(), violations.end(),
                            [&](const Violation& violation) {
                              return violation.code == refusal.code &&
                                     violation.pointer == refusal.pointer;
                            }))
        << refusal.name << ": " << environment.status().ToString();
  }
}

TEST(EnvironmentReaderTest, HostileTextIsReadInBoundedTime) {
  const std::string braces(200000, '{');
  EXPECT_FALSE(ReadEnvironmentAnswer(braces).ok());
  std::string objects;
  for (int i = 0; i < 50000; ++i) objects += "{}";
  EXPECT_FALSE(ReadEnvironmentAnswer(objects).ok());
}

TEST(EnvironmentReaderTest, NoiseGivesALegalEnvironmentOrViolations) {
  const std::string letters = "{}[]\":,0123456789.-eaxn \n\\</think>\x80\xFF";
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(seed, "noise");
    std::string text = random.Chance(0.3) ? "" : LegalEnvironment();
    const int edits = random.UniformInt(0, 4) * (text.empty() ? 200 : 1);
    for (int i = 0; i < edits; ++i) {
      const auto at = static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(text.size())));
      const char letter = letters[static_cast<std::size_t>(
          random.UniformInt(0, static_cast<int>(letters.size()) - 1))];
      if (at < text.size() && random.Chance(0.5)) {
        text[at] = letter;
      } else {
        text.insert(at, 1, letter);
      }
    }
    if (random.Chance(0.3)) {
      text.resize(static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(text.size()))));
    }
    const auto environment = ReadEnvironmentAnswer(text);
    if (environment.ok()) {
      EXPECT_TRUE(Validate(*environment).empty()) << seed;
    } else {
      EXPECT_FALSE(environment.status().message().empty()) << seed;
    }
  }
}

}  // namespace
}  // namespace latticeworld
