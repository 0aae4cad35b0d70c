#include "latticeworld/language/grounded/synthesis/relief_conflicts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

// Heights over the map: u from 0 in the west to 1 in the east, v from 0 in the north to 1 in the
// south.
using Land = std::function<double(double u, double v)>;

Relief ReliefOf(const Land& land) {
  Grid<float> height_m(65, 65);
  for (int row = 0; row < 65; ++row) {
    for (int col = 0; col < 65; ++col) {
      height_m(row, col) = static_cast<float>(100.0 * land(col / 64.0, row / 64.0));
    }
  }
  return MakeRelief(std::move(height_m));
}

std::vector<std::string> Conflicts(const std::string& words, const Land& land) {
  const Vocabulary vocabulary = Vocabulary::kWild;
  return ReliefConflicts(ReadLayoutInstruction(words, vocabulary).plan.claims, vocabulary,
                         ReliefOf(land));
}

struct Course {
  std::string words;
  std::string from, to;  // as the warning names them
  Land down;             // land that falls along it
};

const std::vector<Course>& Courses() {
  static const std::vector<Course> courses = {
      {"A river runs from the north to the south.", "northern edge", "southern edge",
       [](double, double v) { return 1.0 - v; }},
      {"A river flows from south to north.", "southern edge", "northern edge",
       [](double, double v) { return v; }},
      {"A stream runs west to east.", "western edge", "eastern edge",
       [](double u, double) { return 1.0 - u; }},
      {"A river enters in the east and leaves in the west.", "eastern edge", "western edge",
       [](double u, double) { return u; }},
      // Rough land with hills of a tenth of its height falls all the same.
      {"A winding river runs from the north to the south.", "northern edge", "southern edge",
       [](double u, double v) { return 1.0 - v + 0.1 * std::sin(23.0 * u) * std::cos(31.0 * v); }},
  };
  return courses;
}

TEST(ReliefConflictsTest, ARiverThatIsToldToRunUphillIsWarnedOf) {
  for (const Course& course : Courses()) {
    const auto uphill =
        Conflicts(course.words, [&course](double u, double v) { return 1.0 - course.down(u, v); });
    ASSERT_EQ(uphill.size(), 1u) << course.words;
    const std::string words = course.words.substr(0, course.words.size() - 1);
    EXPECT_EQ(uphill[0].rfind("against the relief: \"" + words, 0), 0u) << uphill[0];
    EXPECT_NE(uphill[0].find("the " + course.from + " lies lower than the " + course.to),
              std::string::npos)
        << uphill[0];
  }
}

TEST(ReliefConflictsTest, ARiverThatRunsDownhillOrOverLevelLandIsNot) {
  const std::vector<Land> level = {
      [](double, double) { return 0.0; },
      // Hills, a ridge and a valley, whose ends lie as high as each other.
      [](double u, double v) { return std::sin(19.0 * u) * std::sin(17.0 * v); },
      [](double u, double v) { return 1.0 - std::abs(u - 0.5) - std::abs(v - 0.5); },
      [](double u, double v) { return std::abs(u - 0.5) + std::abs(v - 0.5); },
      // A tower in the middle, beside which all the land rises by a tenth of the relief's height.
      [](double u, double v) {
        return u > 0.45 && u < 0.55 && v > 0.45 && v < 0.55 ? 1.0 : 0.1 * v;
      },
  };
  for (const Course& course : Courses()) {
    EXPECT_TRUE(Conflicts(course.words, course.down).empty()) << course.words;
    for (const Land& land : level) {
      const auto conflicts = Conflicts(course.words, land);
      EXPECT_TRUE(conflicts.empty()) << course.words << " | " << conflicts.front();
    }
  }
}

TEST(ReliefConflictsTest, WhereNoBeginningIsNamedEitherWayIsRight) {
  for (const char* words : {"A vertical river.", "A river runs down the middle.",
                            "A river splits the map into a western and an eastern half."}) {
    EXPECT_TRUE(Conflicts(words, [](double, double v) { return v; }).empty()) << words;
    EXPECT_TRUE(Conflicts(words, [](double, double v) { return 1.0 - v; }).empty()) << words;
  }
  for (const char* words : {"A horizontal river.", "A river runs from side to side."}) {
    EXPECT_TRUE(Conflicts(words, [](double u, double) { return u; }).empty()) << words;
    EXPECT_TRUE(Conflicts(words, [](double u, double) { return 1.0 - u; }).empty()) << words;
  }
}

TEST(ReliefConflictsTest, RoadsMayRunUphill) {
  const std::vector<Claim> claims =
      ReadLayoutInstruction("A road runs from the north to the south.", Vocabulary::kSuburb)
          .plan.claims;
  ASSERT_FALSE(claims.empty());
  const Relief relief = ReliefOf([](double, double v) { return v; });
  EXPECT_TRUE(ReliefConflicts(claims, Vocabulary::kSuburb, relief).empty());
}

}  // namespace
}  // namespace latticeworld
