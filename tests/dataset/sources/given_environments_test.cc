#include "latticeworld/dataset/sources/given_environments.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

std::vector<GivenInstruction> Asked() {
  return {
      {"rain", Vocabulary::kSuburb, "Rain on an autumn night. Three eagles circle in the west."},
      {"snow", Vocabulary::kWild, "A winter morning, snow falling, and two goblins."},
      {"heat", Vocabulary::kWild, "Noon in summer."}};
}

TEST(GivenEnvironmentsTest, EveryAnswerHasWhatWasAskedFor) {
  GivenInstructionsOptions options;
  options.answers = 4;
  const auto source = MakeGivenEnvironmentSource(Asked(), "Weather", options).value();
  const auto annotator = MakeGivenEnvironmentAnnotator(Asked());
  ASSERT_EQ(source->group_count(), 3u);
  std::set<std::string> ids, layouts;
  for (std::size_t group = 0; group < 3; ++group) {
    EXPECT_EQ(source->GroupName(group), Asked()[group].id);
    const std::vector<Instance> places = source->ReadGroup(group).value();
    EXPECT_EQ(places.size(), 4u);
    for (const Instance& place : places) {
      EXPECT_EQ(place.group, Asked()[group].id);
      EXPECT_EQ(place.layout.vocabulary, Asked()[group].vocabulary);
      ids.insert(place.id);
      layouts.insert(ToText(place.layout));
      const LayoutCaption layout = annotator->DescribeLayout(place, 1, Progress()).value();
      const EnvironmentCaption caption =
          annotator->DescribeEnvironment(place, layout, 1, Progress()).value();
      EXPECT_EQ(caption.text, Asked()[group].words);
      const auto claims = ReadEnvironmentInstruction(caption.text, &place.layout).claims;
      EXPECT_GE(claims.size(), 2u);
      for (const EnvironmentClaim& claim : claims)
        EXPECT_TRUE(Measure(claim, caption.environment).holds) << place.id;
    }
  }
  EXPECT_EQ(ids.size(), 12u);
  EXPECT_EQ(layouts.size(), 12u) << "places differ";
}

TEST(GivenEnvironmentsTest, TheSameSeedGivesTheSamePlaces) {
  GivenInstructionsOptions options, other;
  other.seed = 7;
  const auto first = [](const GivenInstructionsOptions& of) {
    return ToText(MakeGivenEnvironmentSource(Asked(), "Weather", of)
                      .value()
                      ->ReadGroup(0)
                      .value()
                      .front()
                      .layout);
  };
  EXPECT_EQ(first(options), first(options));
  EXPECT_NE(first(options), first(other));
}

TEST(GivenEnvironmentsTest, EveryNthIsLeftOut) {
  GivenInstructionsOptions options;
  options.leave_out = 2;
  const auto source = MakeGivenEnvironmentSource(Asked(), "Weather", options).value();
  ASSERT_EQ(source->group_count(), 1u);
  EXPECT_EQ(source->GroupName(0), "snow");
  options.answers = 0;
  EXPECT_EQ(MakeGivenEnvironmentSource(Asked(), "Weather", options).status().code(),
            StatusCode::kInvalidArgument);
}

TEST(GivenEnvironmentsTest, WhatSaysNothingHasNoAnswer) {
  const std::vector<GivenInstruction> hm = {{"a", Vocabulary::kSuburb, "Hm."}};
  const auto source = MakeGivenEnvironmentSource(hm, "Nothing", {}).value();
  const Instance place = source->ReadGroup(0).value().front();
  const auto annotator = MakeGivenEnvironmentAnnotator(hm);
  EXPECT_EQ(annotator->DescribeEnvironment(place, {}, 1, Progress()).status().code(),
            StatusCode::kDataLoss);
  Instance nobodys = place;
  nobodys.group = "b";
  EXPECT_EQ(annotator->DescribeEnvironment(nobodys, {}, 1, Progress()).status().code(),
            StatusCode::kDataLoss);
}

}  // namespace
}  // namespace latticeworld
