#ifndef LATTICEWORLD_LAYOUT_THING_KINDS_H_
#define LATTICEWORLD_LAYOUT_THING_KINDS_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/enum_names.h"

namespace latticeworld {

// What stands for a kind of single things.
enum class ThingSource : std::uint8_t {
  kAsset,  // whatever model of an asset kind grows or lies where it stands
  kModel,  // one model of the catalogue; it stays where it is, or is felled
  kRun,    // a model too, of which many stand end to end: fences, hedges, walls
  kProp    // a prop, which can be moved
};
constexpr std::array<EnumName<ThingSource>, 4> EnumNames(ThingSource) {
  return {{{ThingSource::kAsset, "asset"},
           {ThingSource::kModel, "model"},
           {ThingSource::kRun, "run"},
           {ThingSource::kProp, "element"}}};
}

struct ThingKind {
  std::string name;  // "bench"
  ThingSource source = ThingSource::kModel;
  std::string stands_for;          // name of the asset kind, model or element kind
  double spacing_m = 1.0;          // between the middles of neighbours where nothing is said
  std::vector<std::string> words;  // nouns of it, singular; the name first
};

// data/things.txt, in its order.
const std::vector<ThingKind>& AllThingKinds();
// Returns the kind of that name, or of another word for it, in the singular; nullptr: there is
// none.
const ThingKind* FindThingKind(std::string_view word);
// The name that is written most alike.
std::string NearestThingKind(std::string_view word);
// Letters of targets that are no class of the layout: the upper and the lower part of a world's
// relief (scene/land_finder.h).
inline constexpr char kHighGround = '^';
inline constexpr char kLowGround = '_';
// What a noun of relief in the singular means for things that stand there: "hill" is high ground,
// "valley" low; '\0': no such noun.
char GroundNamed(std::string_view noun);
// All names, parted by commas.
std::string LegalThingKinds();

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_THING_KINDS_H_
