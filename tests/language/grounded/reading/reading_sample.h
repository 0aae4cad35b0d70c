#ifndef LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_READING_READING_SAMPLE_H_
#define LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_READING_READING_SAMPLE_H_

#include <ostream>
#include <string>
#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// An instruction and what is to be read in it.
struct Sample {
  std::string instruction;
  Vocabulary vocabulary;
  // In the words of Show(), or with bounds: "amount F 32..48", percent.
  std::vector<std::string> claims;      // each must be read
  std::vector<std::string> wrong = {};  // none may be
};

inline void PrintTo(const Sample& sample, std::ostream* os) { *os << sample.instruction; }

// A claim in words: "adjacent B W", "present F@upper left", "course W northern
// edge>southern edge", "order SRF>S", "direction B W N", "absent R@eastern third", "count W 3..3",
// "shape R ring".
std::string Show(const Claim& claim);
// All claims of a plan so.
std::vector<std::string> Claims(const LayoutPlan& plan);
// A line each.
std::string Listed(const std::vector<std::string>& lines);

// Expects the sample's claims, and none of the wrong ones.
void ExpectRead(const Sample& sample);
// Expects that letter case tells nothing.
void ExpectReadInCapitals(const Sample& sample);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_READING_READING_SAMPLE_H_
