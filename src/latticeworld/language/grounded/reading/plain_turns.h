#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLAIN_TURNS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLAIN_TURNS_H_

#include <vector>

#include "latticeworld/language/tokens.h"

// The steps of WithPlainWords(), each of which puts one family of turns of phrase in plainer words.
// Examples stand with their definitions.
namespace latticeworld {

// plain_sides.cc: sides and bounds of things.
void TurnPossessives(std::vector<Token>* tokens);
void TurnBounds(std::vector<Token>* tokens);
void TurnBeyond(std::vector<Token>* tokens);

// plain_amounts.cc: comparisons, negations, exceptions.
void TurnComparisons(std::vector<Token>* tokens);
void TurnComparatives(std::vector<Token>* tokens);
void TurnNegations(std::vector<Token>* tokens);
void TurnExceptions(std::vector<Token>* tokens);
void TurnExclusions(std::vector<Token>* tokens);

// plain_idioms.cc: slips of the pen, likenesses, verbs in two parts, words left out.
void TurnSlips(std::vector<Token>* tokens);
void TurnCompany(std::vector<Token>* tokens);
void TurnLikenesses(std::vector<Token>* tokens);
void TurnReached(std::vector<Token>* tokens);
void TurnMatrix(std::vector<Token>* tokens);
void TurnOthers(std::vector<Token>* tokens);

// other_places.cc: places told by those that are taken.
std::vector<Token> WithOtherPlaces(std::vector<Token> tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLAIN_TURNS_H_
