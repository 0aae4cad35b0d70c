#ifndef LATTICEWORLD_LANGUAGE_READING_SENTENCES_OF_CLAIMS_H_
#define LATTICEWORLD_LANGUAGE_READING_SENTENCES_OF_CLAIMS_H_

#include <map>
#include <string>
#include <vector>

#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// Says a claim in the small language, so that whoever reads the result makes the same claim of it.
// The result is one sentence, or one that places a thing and gives it a label ("Forest A in the
// north") and one that speaks of it, without their stops. It is empty where no form has what the
// claim says. Bounds are said as far as a form has them: "touches", "near", "at most 7 cells from".
std::vector<std::string> SentencesOf(const Claim& claim, Vocabulary vocabulary);
std::vector<std::string> SentencesOf(const EnvironmentClaim& claim);

// What sentences before call the land of a class, by its letter: "the river".
using LandNames = std::map<char, std::string>;

// Says all claims, in their order, and each sentence once. Land that has a name already is called
// by it and not placed anew.
std::vector<std::string> SentencesOf(const std::vector<Claim>& claims, Vocabulary vocabulary,
                                     const LandNames& names = {});
std::vector<std::string> SentencesOf(const std::vector<EnvironmentClaim>& claims);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_SENTENCES_OF_CLAIMS_H_
