#include "latticeworld/language/grounded/reading/plain/wording/plain_words.h"

#include <utility>

#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"

namespace latticeworld {

// Each step reads what the steps before it have left.
std::vector<Token> WithPlainWords(std::vector<Token> tokens) {
  TurnDecimals(&tokens);
  TurnManners(&tokens);
  TurnLabels(&tokens);
  TurnNumbered(&tokens);
  TurnListed(&tokens);
  TurnPlaces(&tokens);
  TurnUses(&tokens);
  TurnDenials(&tokens);
  TurnKeepouts(&tokens);
  TurnPassages(&tokens);
  TurnArms(&tokens);
  TurnOffsets(&tokens);
  TurnClumps(&tokens);
  TurnRelatives(&tokens);
  TurnAcross(&tokens);
  TurnContrasts(&tokens);
  TurnVantage(&tokens);
  TurnAsides(&tokens);
  TurnNegatives(&tokens);
  TurnBoth(&tokens);
  TurnInserts(&tokens);
  TurnLeftOut(&tokens);
  TurnTotals(&tokens);
  TurnCounts(&tokens);
  TurnEllipses(&tokens);
  TurnPlacing(&tokens);
  TurnBorders(&tokens);
  TurnMotions(&tokens);
  TurnApproaches(&tokens);
  TurnBends(&tokens);
  TurnGrouping(&tokens);
  TurnAllotments(&tokens);
  TurnPercents(&tokens);
  TurnPairs(&tokens);
  TurnMapMeasures(&tokens);
  TurnDivisions(&tokens);
  TurnCorrections(&tokens);
  TurnSpans(&tokens);
  TurnFills(&tokens);
  TurnScopes(&tokens);
  TurnChains(&tokens);
  TurnRemainders(&tokens);
  TurnJourneys(&tokens);
  TurnPointers(&tokens);
  TurnLoose(&tokens);
  TurnWays(&tokens);
  TurnRings(&tokens);
  TurnEnds(&tokens);
  TurnFellows(&tokens);
  TurnRows(&tokens);
  TurnStripes(&tokens);
  TurnSlants(&tokens);
  TurnPortions(&tokens);
  TurnLists(&tokens);
  TurnSizes(&tokens);
  TurnOutward(&tokens);
  TurnHalfway(&tokens);
  TurnLinked(&tokens);
  TurnSlips(&tokens);
  TurnPossessives(&tokens);
  TurnFlanks(&tokens);
  TurnDetours(&tokens);
  TurnBanks(&tokens);
  TurnShores(&tokens);
  TurnJoins(&tokens);
  TurnLeadingExceptions(&tokens);
  TurnSeparations(&tokens);
  TurnParts(&tokens);
  TurnDistances(&tokens);
  TurnMeasures(&tokens);
  TurnCoasts(&tokens);
  TurnOrders(&tokens);
  TurnOpposites(&tokens);
  TurnRefusals(&tokens);
  TurnCorners(&tokens);
  TurnGaps(&tokens);
  TurnShares(&tokens);
  TurnComparisons(&tokens);
  TurnCompany(&tokens);
  TurnLikenesses(&tokens);
  TurnBounds(&tokens);
  TurnComparatives(&tokens);
  TurnReached(&tokens);
  TurnNegations(&tokens);
  TurnMatrix(&tokens);
  TurnExceptions(&tokens);
  TurnExclusions(&tokens);
  TurnOthers(&tokens);
  TurnBeyond(&tokens);
  return WithOtherPlaces(std::move(tokens));
}

}  // namespace latticeworld
