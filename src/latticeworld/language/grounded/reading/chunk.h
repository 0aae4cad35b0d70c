#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_CHUNK_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_CHUNK_H_

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/grounded/reading/lexeme.h"
#include "latticeworld/language/places.h"

namespace latticeworld {

// What the words around a noun, or after a verb, say of a thing.
struct Qualities {
  std::optional<CountMatch> count;
  std::optional<ShareMatch> share;
  double size = 1.0;         // factor
  double least_share = 0.0;  // "vast": of the map
  double width = 1.0;        // of a line
  Texture texture = Texture::kUnsaid;
  std::optional<ClaimShape> shape;
  std::optional<AxisMatch> axis;  // "an east-west road"
  bool group = false;             // "a row of", "a string of": several
  bool few = false;
  bool little = false;  // "a bit of", "sparse"
  bool much = false;
  bool mostly = false;
  bool parallel = false;
  bool at_most = false;  // "must not exceed 15 %"
  bool more = false;     // "more forest than ..."
  bool less = false;
  bool none = false;            // "trees: none"
  Sense beside = Sense::kNone;  // kRiverside, kLakeside, kRoadside
  bool any = false;             // something was said
};

enum class Head {
  kThing,  // a noun of a class
  kMap,
  kRest,
  kIt,
  kThey,
  kBoth,
  kFormer,
  kLatter,
  kOne,
  kOther,
  kAnother,
  kFirst,
  kThird,
  kShore,  // of the water that was spoken of
};

struct NounPhrase {
  Head head = Head::kThing;
  const ClassWord* noun = nullptr;
  bool plural = false;
  bool definite = false;
  bool indefinite = false;
  bool another = false;
  bool each = false;
  bool negated = false;
  bool shore = false;  // "the shore of the lake"
  Qualities qualities;
  std::vector<Place> places;  // "the northern lake"
};

enum class ChunkKind {
  kNounPhrase,
  kPlace,
  kDirection,
  kAxis,
  kQualities,  // said of a thing that is named elsewhere
  kSense,      // relations, verbs, conjunctions
  kComma,
  kStop,
  kUnknown,
};

// What a clause is made of.
struct Chunk {
  ChunkKind kind = ChunkKind::kUnknown;
  NounPhrase phrase;      // kNounPhrase
  Qualities qualities;    // kQualities
  Lexeme lexeme;          // of the others: the only lexeme, else the last one
  std::size_t begin = 0;  // bytes of the instruction: [begin, end)
  std::size_t end = 0;
  std::size_t first_token = 0;

  bool Is(Sense sense) const { return kind == ChunkKind::kSense && lexeme.sense == sense; }
};

// The chunks of an instruction, function words left out; `unread` collects the bytes of what no
// list knows, [begin, end) each.
struct Chunks {
  std::vector<Chunk> chunks;
  std::vector<std::pair<std::size_t, std::size_t>> unread;
};
Chunks ChunkLayout(const std::vector<Token>& tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_CHUNK_H_
