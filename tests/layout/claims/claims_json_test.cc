#include "latticeworld/layout/claims/claims_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "layout/claim_checks.h"

namespace latticeworld {
namespace {

constexpr char kEveryKind[] = R"([
  {"kind": "present", "subject": "F", "zone": "upper left", "words": "a forest \"up\" there, é"},
  {"kind": "absent", "subject": "W"},
  {"kind": "absent", "subject": "W", "zone": "edges", "most": 0.125},
  {"kind": "amount", "subject": "A", "zone": "eastern half", "least": 0.4, "most": 0.6},
  {"kind": "dominant", "subject": "G"},
  {"kind": "more_than", "subject": "F", "object": "A"},
  {"kind": "located", "subject": "B", "zone": "northern third", "least": 0.75},
  {"kind": "count", "subject": "W", "least": 3, "most": 3},
  {"kind": "clustered", "subject": "B", "most": 2},
  {"kind": "scattered", "subject": "B", "least": 6},
  {"kind": "adjacent", "subject": "B", "object": "W", "most": 4},
  {"kind": "apart", "subject": "B", "object": "W", "object_zone": "western half", "least": 6},
  {"kind": "surrounds", "subject": "F", "object": "W", "least": 0.8},
  {"kind": "within", "subject": "B", "object": "F"},
  {"kind": "both_sides", "subject": "B", "object": "R"},
  {"kind": "between", "subject": "B", "object": "W", "second_object": "F"},
  {"kind": "direction", "subject": "B", "object": "W", "heading": "north-west"},
  {"kind": "order", "sequence": "WAF", "heading": "south"},
  {"kind": "course", "subject": "R", "from": "western edge", "to": "eastern edge"},
  {"kind": "course", "subject": "R", "to": "north-west corner"},
  {"kind": "through", "subject": "R", "object": "F"},
  {"kind": "along", "subject": "B", "object": "R", "least": 0.9},
  {"kind": "along", "subject": "W", "zone": "southern edge"},
  {"kind": "crosses", "subject": "R", "object": "W"},
  {"kind": "parallel", "subject": "R", "object": "W"},
  {"kind": "connects", "subject": "R", "object": "B", "second_object": "B"},
  {"kind": "shape", "subject": "W", "shape": "winding"},
  {"kind": "rest", "subject": "G", "sequence": "WB", "least": 0.9},
  {"kind": "present", "subject": "F",
   "zone": {"name": "two strips", "boxes": [[0, 0.1, 0, 1], [0.9, 1, 0.25, 0.75]]}}
])";

TEST(ClaimsJsonTest, ReadsEveryKind) {
  const auto claims = DecodeClaims(kEveryKind, Vocabulary::kSuburb);
  ASSERT_TRUE(claims.ok()) << claims.status().ToString();
  ASSERT_EQ(claims->size(), 29u);
  for (const auto& kind : EnumNames(ClaimKind{})) {
    EXPECT_TRUE(std::any_of(claims->begin(), claims->end(), [&](const Claim& claim) {
      return claim.kind == kind.value;
    })) << kind.name;
  }
  EXPECT_EQ((*claims)[0].words, "a forest \"up\" there, é");
  EXPECT_EQ((*claims)[0].subject, 'F');
  EXPECT_EQ((*claims)[0].least, Claim::kUnsaid);
  EXPECT_EQ((*claims)[2].zone, FindZone("edges"));
  EXPECT_EQ((*claims)[3].least, 0.4);
  EXPECT_EQ((*claims)[3].most, 0.6);
  EXPECT_EQ((*claims)[11].object_zone, FindZone("western half"));
  EXPECT_EQ((*claims)[15].second_object, 'F');
  EXPECT_EQ((*claims)[16].heading, (Claim::Heading{-1, -1}));
  EXPECT_EQ((*claims)[17].sequence, "WAF");
  EXPECT_TRUE((*claims)[19].from.is_anywhere());
  EXPECT_EQ((*claims)[19].to, FindZone("north-west corner"));
  EXPECT_EQ((*claims)[22].object, '\0');
  EXPECT_EQ((*claims)[26].shape, ClaimShape::kWinding);
  ASSERT_EQ((*claims)[28].zone.boxes.size(), 2u);
  EXPECT_EQ((*claims)[28].zone.name, "two strips");
  EXPECT_EQ((*claims)[28].zone.boxes[1].v_min, 0.25);
}

TEST(ClaimsJsonTest, WritesWhatItReads) {
  const auto claims = DecodeClaims(kEveryKind, Vocabulary::kSuburb);
  ASSERT_TRUE(claims.ok());
  const std::string written = EncodeClaims(*claims);
  const auto again = DecodeClaims(written, Vocabulary::kSuburb);
  ASSERT_TRUE(again.ok()) << again.status().ToString() << written;
  ASSERT_EQ(again->size(), claims->size());
  EXPECT_EQ(EncodeClaims(*again), written);
  for (std::size_t i = 0; i < claims->size(); ++i) {
    const Claim &a = (*claims)[i], &b = (*again)[i];
    EXPECT_EQ(a.kind, b.kind) << i;
    EXPECT_EQ(a.subject, b.subject) << i;
    EXPECT_EQ(a.object, b.object) << i;
    EXPECT_EQ(a.second_object, b.second_object) << i;
    EXPECT_EQ(a.zone, b.zone) << i;
    EXPECT_EQ(a.object_zone, b.object_zone) << i;
    EXPECT_EQ(a.from, b.from) << i;
    EXPECT_EQ(a.to, b.to) << i;
    EXPECT_EQ(a.sequence, b.sequence) << i;
    EXPECT_EQ(a.heading, b.heading) << i;
    EXPECT_EQ(a.least, b.least) << i;
    EXPECT_EQ(a.most, b.most) << i;
    EXPECT_EQ(a.shape, b.shape) << i;
    EXPECT_EQ(a.words, b.words) << i;
  }
}

TEST(ClaimsJsonTest, WritesOneClaimALine) {
  EXPECT_EQ(EncodeClaims({}), "[]\n");
  EXPECT_EQ(EncodeClaims({WithBounds(About(ClaimKind::kCount, 'W'), 3, 3),
                          Course('R', "anywhere", "eastern edge")}),
            "[\n"
            "  {\"kind\":\"count\",\"subject\":\"W\",\"least\":3,\"most\":3},\n"
            "  {\"kind\":\"course\",\"subject\":\"R\",\"to\":\"eastern edge\"}\n"
            "]\n");
}

TEST(ClaimsJsonTest, ZonesThatOnlyBorrowANameKeepTheirBoxes) {
  Claim claim = About(ClaimKind::kPresent, 'W');
  claim.zone = {"upper left", {{0.0, 0.5, 0.0, 0.5}}};
  const auto again = DecodeClaims(EncodeClaims({claim}), Vocabulary::kSuburb);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ((*again)[0].zone, claim.zone);
}

struct Wrong {
  std::string json;
  std::string code;
  std::string pointer;
  std::string message;  // a part of it
};

TEST(ClaimsJsonTest, SaysWhatIsWrongAndWhere) {
  const std::vector<Wrong> wrongs = {
      {R"([1])", "wrong_type", "/0", "an object"},
      {R"([{}])", "missing_key", "/0/kind", "present"},
      {R"([{"kind": 3}])", "wrong_type", "/0/kind", "3"},
      {R"([{"kind": "presence"}])", "unknown_kind", "/0/kind", "located"},
      {R"([{"kind": "present"}])", "missing_key", "/0/subject", "present"},
      {R"([{"kind": "present", "subject": "S"}])", "foreign_letter", "/0/subject", "A, B, D"},
      {R"([{"kind": "present", "subject": "f"}])", "foreign_letter", "/0/subject", "A, B, D"},
      {R"([{"kind": "present", "subject": "FF"}])", "foreign_letter", "/0/subject", "A, B, D"},
      {R"([{"kind": "present", "subject": ""}])", "foreign_letter", "/0/subject", "A, B, D"},
      {R"([{"kind": "present", "subject": null}])", "wrong_type", "/0/subject", "null"},
      {R"([{"kind": "present", "subject": "F", "object": "W"}])", "unknown_key", "/0/object",
       "kind, least, subject, words, zone"},
      {R"([{"kind": "present", "subject": "F", "most": 1}])", "unknown_key", "/0/most", "present"},
      {R"([{"kind": "present", "subject": "F", "a/b~": 1}])", "unknown_key", "/0/a~1b~0", ""},
      {R"([{"kind": "present", "subject": "F", "zone": "north"}])", "unknown_zone", "/0/zone",
       "northern half"},
      {R"([{"kind": "present", "subject": "F", "zone": 1}])", "wrong_type", "/0/zone", "boxes"},
      {R"([{"kind": "present", "subject": "F", "zone": {"boxes": [[0, 1, 0, 1]]}}])", "missing_key",
       "/0/zone/name", ""},
      {R"([{"kind": "present", "subject": "F", "zone": {"name": "x"}}])", "missing_key",
       "/0/zone/boxes", "u_min"},
      {R"([{"kind": "present", "subject": "F", "zone": {"name": "x", "boxes": []}}])",
       "missing_key", "/0/zone/boxes", "1 to 64"},
      {R"([{"kind": "present", "subject": "F", "zone": {"name": "x", "boxes": [[0, 1, 0]]}}])",
       "wrong_type", "/0/zone/boxes/0", "four numbers"},
      {R"([{"kind": "present", "subject": "F", "zone": {"name": "x", "boxes": [[0, 2, 0, 1]]}}])",
       "out_of_range", "/0/zone/boxes/0", "0 to 1"},
      {R"([{"kind": "present", "subject": "F", "zone": {"name": "x", "boxes": [[1, 0, 0, 1]]}}])",
       "out_of_range", "/0/zone/boxes/0", "u_min < u_max"},
      {R"([{"kind": "present", "subject": "F",
            "zone": {"name": "x", "boxes": [[0.5, 0.501, 0, 1]]}}])",
       "out_of_range", "/0/zone/boxes", "no cell"},
      {R"([{"kind": "present", "subject": "F",
            "zone": {"name": "x", "boxes": [[0, 1, 0, 1]], "box": 1}}])",
       "unknown_key", "/0/zone/box", "name and boxes"},
      {R"([{"kind": "located", "subject": "F"}])", "missing_key", "/0/zone", "located"},
      {R"([{"kind": "present", "subject": "F", "least": 1.5}])", "out_of_range", "/0/least",
       "a share from 0 to 1"},
      {R"([{"kind": "present", "subject": "F", "least": -0.1}])", "out_of_range", "/0/least", ""},
      {R"([{"kind": "present", "subject": "F", "least": "much"}])", "wrong_type", "/0/least",
       "a number"},
      {R"([{"kind": "count", "subject": "W", "least": 2.5}])", "out_of_range", "/0/least",
       "a whole number from 0 to 1024"},
      {R"([{"kind": "apart", "subject": "W", "object": "B", "least": 33}])", "out_of_range",
       "/0/least", "0 to 32"},
      {R"([{"kind": "count", "subject": "W", "least": 4, "most": 3}])", "out_of_range", "/0/most",
       "less than least, 4"},
      {R"([{"kind": "amount", "subject": "W"}])", "missing_key", "/0/least", "most"},
      {R"([{"kind": "along", "subject": "W"}])", "missing_key", "/0/object", "zone"},
      {R"([{"kind": "course", "subject": "W"}])", "missing_key", "/0/from", "to"},
      {R"([{"kind": "direction", "subject": "B", "object": "W"}])", "missing_key", "/0/heading",
       ""},
      {R"([{"kind": "direction", "subject": "B", "object": "W", "heading": "up"}])",
       "unknown_heading", "/0/heading", "south-west"},
      {R"([{"kind": "direction", "subject": "B", "object": "W", "heading": [0, 1]}])", "wrong_type",
       "/0/heading", ""},
      {R"([{"kind": "shape", "subject": "W", "shape": "square"}])", "unknown_shape", "/0/shape",
       "gridded"},
      {R"([{"kind": "shape", "subject": "W", "shape": 4}])", "wrong_type", "/0/shape", ""},
      {R"([{"kind": "shape", "subject": "W"}])", "missing_key", "/0/shape", "shape"},
      {R"([{"kind": "order", "sequence": "WX", "heading": "north"}])", "foreign_letter",
       "/0/sequence", "A, B, D"},
      {R"([{"kind": "order", "sequence": "W", "heading": "north"}])", "too_short", "/0/sequence",
       "two"},
      {R"([{"kind": "order", "sequence": "WFW", "heading": "north"}])", "repeated_letter",
       "/0/sequence", "twice"},
      {R"([{"kind": "order", "sequence": ["W", "F"], "heading": "north"}])", "wrong_type",
       "/0/sequence", ""},
      {R"([{"kind": "rest", "subject": "W", "sequence": ""}])", "too_short", "/0/sequence", "one"},
      {R"([{"kind": "rest", "subject": "W", "sequence": "WF"}])", "repeated_letter", "/0/sequence",
       "the rest"},
      {R"([{"kind": "present", "subject": "F", "words": 1}])", "wrong_type", "/0/words", ""},
      {R"([{"kind": "present", "subject": "F", "subject": "W"}])", "repeated_key", "", "subject"},
  };
  for (const Wrong& wrong : wrongs) {
    const auto claims = DecodeClaims(wrong.json, Vocabulary::kSuburb);
    ASSERT_FALSE(claims.ok()) << wrong.json;
    EXPECT_EQ(claims.status().code(), StatusCode::kInvalidArgument);
    const auto& violations = claims.status().violations();
    const bool found =
        std::any_of(violations.begin(), violations.end(), [&](const Violation& violation) {
          return violation.code == wrong.code && violation.pointer == wrong.pointer &&
                 violation.message.find(wrong.message) != std::string::npos;
        });
    EXPECT_TRUE(found) << wrong.json << "\n" << claims.status().ToString();
    EXPECT_EQ(violations.size(), 1u) << wrong.json << "\n" << claims.status().ToString();
  }
}

TEST(ClaimsJsonTest, SaysEverythingThatIsWrongAtOnce) {
  const auto claims = DecodeClaims(
      R"([{"kind": "count", "subject": "X", "least": -1, "zone": "nowhere", "colour": "red"},
          {"kind": "present", "subject": "F"},
          {"kind": "between", "subject": "B"}])",
      Vocabulary::kSuburb);
  ASSERT_FALSE(claims.ok());
  std::vector<std::string> pointers;
  for (const Violation& violation : claims.status().violations()) {
    pointers.push_back(violation.pointer);
  }
  EXPECT_EQ(pointers, (std::vector<std::string>{"/0/subject", "/0/zone", "/0/least", "/0/colour",
                                                "/2/object", "/2/second_object"}));
}

TEST(ClaimsJsonTest, LettersAreThoseOfTheVocabulary) {
  const std::string snow = R"([{"kind": "present", "subject": "S"}])";
  EXPECT_TRUE(DecodeClaims(snow, Vocabulary::kWild).ok());
  EXPECT_FALSE(DecodeClaims(snow, Vocabulary::kSuburb).ok());
}

TEST(ClaimsJsonTest, SurvivesHostileText) {
  std::string keys = R"([{"kind": "present", "subject": "F")";
  for (int i = 0; i < 5000; ++i) keys += ", \"k" + std::to_string(i) + "\": 1";
  std::string many = "[1";
  for (int i = 0; i < 2000; ++i) many += ", 1";
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  for (const std::string& text :
       {std::string(), std::string("null"), std::string("{}"), std::string("\"a\""),
        std::string("[{]"), std::string("\xff\xfe"), std::string(2 << 20, ' '),
        std::string(100000, '['), deep, keys + "}]", many + "]",
        std::string("[{\"kind\": \"\xc3\x28\"}]")}) {
    const auto claims = DecodeClaims(text, Vocabulary::kSuburb);
    ASSERT_FALSE(claims.ok()) << text.substr(0, 40);
    EXPECT_EQ(claims.status().code(), StatusCode::kInvalidArgument);
    EXPECT_LT(claims.status().ToString().size(), 100000u);
  }
  EXPECT_TRUE(DecodeClaims("[]", Vocabulary::kSuburb)->empty());
}

}  // namespace
}  // namespace latticeworld
