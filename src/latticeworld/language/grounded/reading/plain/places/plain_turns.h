#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLAIN_PLACES_PLAIN_TURNS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLAIN_PLACES_PLAIN_TURNS_H_

#include <vector>

#include "latticeworld/language/tokens.h"

// The steps of WithPlainWords(), each of which puts one family of turns of phrase in plainer words.
// Examples stand with their definitions.
namespace latticeworld {

// plain_manners.cc: "the river is going up", "at north from the lake", "roads should not exist":
// goes up, north of the lake, no roads.
void TurnManners(std::vector<Token>* tokens);

// plain_labels.cc: "bare rock: 0", "on 3 sides": none, three sides.
void TurnLabels(std::vector<Token>* tokens);

// plain_percents.cc: "forest: 0.4", "70 percent is forest, 30 percent is water", "the village has
// 15 percent": 40 percent; forest covers 70 percent of the map; the village covers 15 percent.
void TurnDecimals(std::vector<Token>* tokens);
void TurnPercents(std::vector<Token>* tokens);

// plain_places.cc: "a lake and grass elsewhere", "every edge is forest except the southern one",
// "one house in every corner": a lake. Grass elsewhere; the three other edges; four houses.
void TurnPlaces(std::vector<Token>* tokens);

// plain_numbered.cc: "more than two but fewer than six lakes", "rows 1 to 10 are forest", "forest
// is the largest area": between 3 and 5 lakes; the upper third; mostly forest.
void TurnNumbered(std::vector<Token>* tokens);

// plain_ellipses.cc: "no houses in the north, but some in the south", "not many houses", "apart
// from a pond there is no water": some houses in the south; few houses; a pond.
void TurnEllipses(std::vector<Token>* tokens);

// plain_uses.cc: "people live on both banks", "forget about forests", "the infield is sand":
// houses, no forests, inside the loop.
void TurnUses(std::vector<Token>* tokens);

// plain_denials.cc: "a river without a bridge", "through the forest but not through the village",
// "a road with no bends": a river, and never through the village, in a straight line.
void TurnDenials(std::vector<Token>* tokens);

// plain_keepouts.cc: "ends before it reaches the wood", "keep the river bank free of houses", "a
// village with no forest around it, and a lake": stops short of it, the houses not next to the
// river, a village and a lake. The forest not close to the village.
void TurnKeepouts(std::vector<Token>* tokens);

// plain_passages.cc: "a road with houses on both sides runs from west to east", "two rivers meet in
// the south", "passes the village on the north side": it runs there, with houses on both sides;
// rivers meet there; passes north of it.
void TurnPassages(std::vector<Token>* tokens);

// plain_arms.cc: "roads run from the center to all four corners", "a road goes all around the map":
// to the northwest corner, ...; a ring road along the edges.
void TurnArms(std::vector<Token>* tokens);

// plain_offsets.cc: "one third from the top", "outside the town there is only farmland", "a path of
// grass": in the northern third, around the town, a strip of grass.
void TurnOffsets(std::vector<Token>* tokens);
// plain_across.cc: "the lake and the town are at opposite ends of the map", "across the river from
// the town lies a forest", "trees shield the houses from the road": the lake is far away from the
// town, the river lies between the town and a forest, trees lie between the houses and the road.
void TurnAcross(std::vector<Token>* tokens);

// plain_contrasts.cc: "a lake, not a river, in the middle", "not a lake but a forest", "around the
// lake no trees, only meadow": a lake in the middle, a forest, around the lake only meadow.
void TurnContrasts(std::vector<Token>* tokens);

// plain_vantage.cc: "behind the lake, seen from the west", "the town overlooks a lake to the
// south", "walled by rock to the east": to the east of the lake, to the south of the town, on its
// east side.
void TurnVantage(std::vector<Token>* tokens);

// plain_relatives.cc: "the lake whose shore is wooded lies in the west", "a town through which a
// river flows": the lake lies in the west. Forest on the shore of the lake; a river runs through
// the town.
void TurnRelatives(std::vector<Token>* tokens);

// plain_clumps.cc: "an island of rock", "a buffer of trees", "snow and rock to its north and south
// respectively": a rocky island, a strip of trees, snow to its north and rock to its south.
void TurnClumps(std::vector<Token>* tokens);

// plain_measures.cc: "may take up to 20 percent", "a 5 by 5 lake", "all the houses are in the
// north": at most 20 percent, 5 cells across, only in the north.
void TurnMapMeasures(std::vector<Token>* tokens);

// plain_approaches.cc: "roads reach it from the west and the south", "driving north on the road you
// have the sea on your left": roads in the west and the south, the sea to the west of the road.
void TurnApproaches(std::vector<Token>* tokens);

// plain_bends.cc: "up to the middle, where it turns and leaves by the left edge", "a town on the
// inner side of the bend": via the center to the western edge, to the north-east of the river.
void TurnBends(std::vector<Token>* tokens);

// plain_motions.cc: "follows the river on its east bank", "to the middle, where it ends at a
// village": follows the east bank of the river, to a village in the center.
void TurnMotions(std::vector<Token>* tokens);

// plain_listed.cc: "houses are scattered all over the map", "more forest than any other land",
// "exactly four meadows. A house inside every meadow": scattered houses, mostly forest, four
// houses.
void TurnListed(std::vector<Token>* tokens);

// plain_counts.cc: "three houses in the north and two in the south": five, three of them in the
// north.
void TurnCounts(std::vector<Token>* tokens);

// plain_placing.cc: "a town on the river, on the south side", "the middle stays empty": on the
// south side of the river, keep the middle empty.
void TurnPlacing(std::vector<Token>* tokens);

// plain_totals.cc: "the forest is larger than all the rest", "the rest is half fields and half
// grass": covers more than everything else; the rest is fields and grass.
void TurnTotals(std::vector<Token>* tokens);

// plain_exceptions.cc: "forest on all sides but the west", "no houses at all apart from one farm":
// surrounded by forest; one farm, no other houses.
void TurnLeftOut(std::vector<Token>* tokens);

// plain_grouping.cc: "the only trees, in the north", "the lake and the village lie far apart", "a
// wood shelters it from the north": only there, away from it, on its northern side.
void TurnGrouping(std::vector<Token>* tokens);

// plain_allotments.cc: "the eastern half is a third forest and two thirds grass": in the eastern
// half there is 33 percent forest.
void TurnAllotments(std::vector<Token>* tokens);

// plain_negatives.cc: "a meadow without trees surrounds it", "roads should avoid the lake",
// "neither the lake nor the wood is near it": a treeless meadow, keep away from it, both are not
// near it.
void TurnNegatives(std::vector<Token>* tokens);

// plain_both.cc: "both the wood and the lake", "a lake and a wood, neither near the road", "the
// northern one": the wood and the lake, they are not near it, the northern village.
void TurnBoth(std::vector<Token>* tokens);

// plain_borders.cc: "forest borders the lake on all sides", "a lake bordered on the north by
// woods": surrounds it, with woods on its northern side.
void TurnBorders(std::vector<Token>* tokens);

// plain_inserts.cc: "below it, next to the lake, houses", "a lake and, to its east, a wood", "a
// river, right, and a town": houses below it, and to its east a wood, no side.
void TurnInserts(std::vector<Token>* tokens);

// plain_asides.cc: "a manor. Surrounded by forest", "as it was in 1900", "grass where there is
// room": it is surrounded by forest, the rest is grass.
void TurnAsides(std::vector<Token>* tokens);

// plain_pairs.cc: "one cottage on each bank", "two lakes, a big one in the north and a small one in
// the south": two cottages on both banks, one in the north.
void TurnPairs(std::vector<Token>* tokens);

// plain_divisions.cc: "divides the map into a forested north and an open south", "a lake in one
// corner, a village in the opposite one", "half forest, half field, with a road along the border".
void TurnDivisions(std::vector<Token>* tokens);

// plain_stripes.cc: "Four stripes from the left. The first is forest, the second grass, ...",
// "three equal columns: snow, rock, grass": the band of each.
void TurnStripes(std::vector<Token>* tokens);

// plain_slants.cc: "everything below a line from the lower left to the upper right corner", "cut
// along the diagonal: the north-east is snow": the part of the map on that side.
void TurnSlants(std::vector<Token>* tokens);

// plain_portions.cc: "three hamlets, two of them in the north, the third in the south": how many of
// them each time.
void TurnPortions(std::vector<Token>* tokens);

// plain_corners.cc: "three of the four corners are woods, the fourth, in the south-east, is water":
// all of them by their names.
void TurnCorners(std::vector<Token>* tokens);

// plain_sides.cc: sides and bounds of things.
void TurnPossessives(std::vector<Token>* tokens);
void TurnBounds(std::vector<Token>* tokens);
void TurnBeyond(std::vector<Token>* tokens);

// plain_banks.cc: "splits the land into a western part, all forest, and an eastern part, all
// fields", "you look north over fields": to the west of it, to the north of it.
void TurnBanks(std::vector<Token>* tokens);

// plain_shores.cc: "a lake whose northern shore is wooded", "forest on its south side, heath on the
// north": its northern shore is, on its north side.
void TurnShores(std::vector<Token>* tokens);

// plain_flanks.cc: "on the town's other side, to the west, a lake", "what lies north of it is
// forest", "in one corner, the top right": to the west of the town, north of it there is forest, in
// the top right corner.
void TurnFlanks(std::vector<Token>* tokens);

// plain_detours.cc: "a road all the way around it", "bends north around a lake": around it,
// passes north of a lake.
void TurnDetours(std::vector<Token>* tokens);

// plain_corrections.cc: "a pond in the north, sorry, in the south": in the south.
void TurnCorrections(std::vector<Token>* tokens);

// plain_rows.cc: "a wood, a lake and a village in a row from west to east": from west to east, a
// wood, ...
void TurnRows(std::vector<Token>* tokens);

// plain_joins.cc: "a mill where the river and the road cross", "roads in the shape of an X": next
// to both, from corner to corner.
void TurnJoins(std::vector<Token>* tokens);

// plain_sizes.cc: "a lake about half that size": covering 20 percent of the map.
void TurnSizes(std::vector<Token>* tokens);

// plain_outward.cc: "between the river to its west and the wood to its east", "outside of that
// fields", "inland from it grass, then forest", "on its far shore".
void TurnOutward(std::vector<Token>* tokens);

// plain_lists.cc: "From south to north a beach, grass and forest", "one north and one south of the
// river", "the southern half is split between fields on the left and houses on the right".
void TurnLists(std::vector<Token>* tokens);

// plain_halfway.cc: "a road from left to right and a hamlet halfway along": next to the road in the
// center.
void TurnHalfway(std::vector<Token>* tokens);

// plain_spans.cc: "a strip 5 cells wide", "a lake 10 cells across": no number of strips; covering
// about 8 percent of the map.
void TurnSpans(std::vector<Token>* tokens);

// plain_rings.cc: "forest on all four sides, a meadow within", "a town inside a ring road, fields
// outside": a meadow surrounded by forest, the rest is fields.
void TurnRings(std::vector<Token>* tokens);

// plain_ends.cc: "a village at each end of the road", "roads leave the town in all four
// directions": two villages, to the northern edge, the southern edge, ...
void TurnEnds(std::vector<Token>* tokens);

// plain_fellows.cc: "a village north of the lake, another one south of it", "half of the houses are
// in the north": another village, the houses.
void TurnFellows(std::vector<Token>* tokens);

// plain_fills.cc: "fill the north with houses and the south with fields", "circle it with grass",
// "a hole in the middle with sand": houses fill the north, surround it, a patch of sand.
void TurnFills(std::vector<Token>* tokens);

// plain_scopes.cc: "the north is woods and there is no rock anywhere", "nobody lives here", "fields
// on every other side": no rock on the whole map, no houses, around it.
void TurnScopes(std::vector<Token>* tokens);

// plain_chains.cc: "around the lake is sand, then forest", "first comes snow, second comes rock",
// "until it reaches a town": around the sand is forest, then rock, to a town.
void TurnChains(std::vector<Token>* tokens);

// plain_ways.cc: "snow, then rock as you go down", "a wooded country", "grass wherever there is no
// water": from north to south, mostly forest, elsewhere.
void TurnWays(std::vector<Token>* tokens);

// plain_remainders.cc: "the western half is forest, the other half grass", "the background is
// grass", "keep the center empty": the eastern half; the rest is grass; grass in the center.
void TurnRemainders(std::vector<Token>* tokens);

// plain_loose.cc: "lake-free", "a road leads up to two sheds", "like a quarry", "lake. big.",
// "south of all three": no lake, to two sheds, nothing, a big lake, south of them.
void TurnLoose(std::vector<Token>* tokens);

// plain_pointers.cc: "a wood east of that", "houses on one side and fields on the other", "north of
// which", "a big one": east of the village, on the other side of the road, north of it, a big wood.
void TurnPointers(std::vector<Token>* tokens);

// plain_journeys.cc: "walking north from the lake you pass a field, then reach a wood", "snow in
// the north gives way to rock, then to forest": from south to north, the lake, then a field, then a
// wood; from north to south, snow, then rock, then forest.
void TurnJourneys(std::vector<Token>* tokens);

// plain_linked.cc: "..., connected by roads", "it gets sandier towards the north".
void TurnLinked(std::vector<Token>* tokens);

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

// plain_relations.cc: relations and measures told in a roundabout way.
// "Except for a lake, the map is forest": "the map is forest except for a lake".
void TurnLeadingExceptions(std::vector<Token>* tokens);
// "the town is separated from the road by a wood": "a wood lies between the town and the road".
void TurnSeparations(std::vector<Token>* tokens);
// "the river splits the town into two halves": the town lies on both sides of it.
void TurnParts(std::vector<Token>* tokens);
// "no trees within 3 cells of a house", "as far from the road as possible", "the wood ends where
// the meadow begins", "the river bends round the town".
void TurnDistances(std::vector<Token>* tokens);
// "covers more than 40 percent", "covers more than everything else together", "lots of forest, less
// grassland", "fill whatever is left with grass".
void TurnMeasures(std::vector<Token>* tokens);
// "on the coast": by the sea, where no water is named.
void TurnCoasts(std::vector<Token>* tokens);

// plain_orders.cc: rows of things, sides of things, what may not stand near.
// "First comes the town, then a wood, from left to right": "from left to right, the town, then
// ...".
void TurnOrders(std::vector<Token>* tokens);
// "to the left and to the right of the road": "on both sides of the road". "On one side of the
// river fields, on the other a wood": the river lies between them. "Around the village on the
// east": "to the east of the village".
void TurnOpposites(std::vector<Token>* tokens);
// "no houses next to the river": "the houses not next to the river". "Closer to the lake than to
// the wood": "near the lake".
void TurnRefusals(std::vector<Token>* tokens);

// plain_gaps.cc: what is said once and meant twice, parts of what was counted.
// "The lake is round and the forest long", "around the town fields", "surrounded by fields, those
// by forest", "the two lakes are separated by a wood".
void TurnGaps(std::vector<Token>* tokens);
// "Five ponds, three of them in the north", "at right angles".
void TurnShares(std::vector<Token>* tokens);

// other_places.cc: places told by those that are taken.
std::vector<Token> WithOtherPlaces(std::vector<Token> tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLAIN_PLACES_PLAIN_TURNS_H_
