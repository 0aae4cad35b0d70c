#include "latticeworld/language/grounded/reading/plain/wording/plain_words.h"

#include <utility>

#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"

namespace latticeworld {
namespace {

// The passes run in this order: each reads what those before it have left.
constexpr void (*kPasses[])(std::vector<Token>* tokens) = {
    TurnDecimals,     TurnManners,     TurnLabels,
    TurnNumbered,     TurnListed,      TurnPlaces,
    TurnUses,         TurnDenials,     TurnKeepouts,
    TurnPassages,     TurnArms,        TurnOffsets,
    TurnClumps,       TurnRelatives,   TurnAcross,
    TurnContrasts,    TurnVantage,     TurnAsides,
    TurnNegatives,    TurnBoth,        TurnInserts,
    TurnLeftOut,      TurnTotals,      TurnCounts,
    TurnEllipses,     TurnPlacing,     TurnBorders,
    TurnMotions,      TurnApproaches,  TurnBends,
    TurnGrouping,     TurnAllotments,  TurnPercents,
    TurnPairs,        TurnMapMeasures, TurnDivisions,
    TurnCorrections,  TurnSpans,       TurnFills,
    TurnScopes,       TurnChains,      TurnRemainders,
    TurnJourneys,     TurnPointers,    TurnLoose,
    TurnWays,         TurnRings,       TurnEnds,
    TurnFellows,      TurnRows,        TurnStripes,
    TurnSlants,       TurnPortions,    TurnLists,
    TurnSizes,        TurnOutward,     TurnHalfway,
    TurnLinked,       TurnSlips,       TurnPossessives,
    TurnFlanks,       TurnDetours,     TurnBanks,
    TurnShores,       TurnJoins,       TurnLeadingExceptions,
    TurnSeparations,  TurnParts,       TurnDistances,
    TurnMeasures,     TurnCoasts,      TurnOrders,
    TurnOpposites,    TurnRefusals,    TurnCorners,
    TurnGaps,         TurnShares,      TurnComparisons,
    TurnCompany,      TurnLikenesses,  TurnBounds,
    TurnComparatives, TurnReached,     TurnNegations,
    TurnMatrix,       TurnExceptions,  TurnExclusions,
    TurnOthers,       TurnBeyond,
};

}  // namespace

std::vector<Token> WithPlainWords(std::vector<Token> tokens) {
  for (const auto pass : kPasses) pass(&tokens);
  return WithOtherPlaces(std::move(tokens));
}

}  // namespace latticeworld
