#include "latticeworld/language/grounded/reading/chunk_qualities.h"

#include <algorithm>
#include <optional>

namespace latticeworld {
namespace {

std::optional<ClaimShape> ShapeOf(Sense sense) {
  switch (sense) {
    case Sense::kRound:
      return ClaimShape::kRound;
    case Sense::kElongated:
      return ClaimShape::kElongated;
    case Sense::kBent:
      return ClaimShape::kBent;
    case Sense::kRing:
      return ClaimShape::kRing;
    case Sense::kStraight:
      return ClaimShape::kStraight;
    case Sense::kWinding:
      return ClaimShape::kWinding;
    case Sense::kGridded:
      return ClaimShape::kGridded;
    default:
      return std::nullopt;
  }
}

// A shape that a word tells.
void AddShape(ClaimShape shape, Qualities* said) {
  // "a straight strip of grassland": a strip is long anyway.
  const bool line = shape == ClaimShape::kElongated &&
                    (said->shape == ClaimShape::kStraight || said->shape == ClaimShape::kWinding);
  if (!line) said->shape = shape;
}

// Whether the sense tells how much, how many or how close to each other; it is added then.
bool AddQuantity(Sense sense, Qualities* said) {
  switch (sense) {
    case Sense::kScattered:
      said->texture = Texture::kScattered;
      return true;
    case Sense::kClustered:
      said->texture = Texture::kClustered;
      return true;
    case Sense::kSparse:
    case Sense::kLittle:
      said->little = true;
      return true;
    case Sense::kMuch:
      said->much = true;
      return true;
    case Sense::kFew:
      said->few = true;
      return true;
    case Sense::kSeveral:
      said->group = true;
      return true;
    case Sense::kMany:
      said->count = CountMatch{4, CountMatch::kUnbounded, 1};
      return true;
    case Sense::kSingle:
      said->count = CountMatch{1, 1, 1};
      return true;
    case Sense::kMostly:
      said->mostly = true;
      return true;
    case Sense::kAbsent:
      said->none = true;
      return true;
    case Sense::kAtMost:
      said->at_most = true;
      return true;
    default:
      return false;
  }
}

// Whether the sense tells how a thing lies or what it looks like; it is added then.
bool AddAlignment(Sense sense, Qualities* said) {
  switch (sense) {
    case Sense::kParallelEach:
      said->parallel = true;
      return true;
    case Sense::kHorizontal:
      said->axis = AxisMatch{{-1, 0}, {1, 0}, 1};
      return true;
    case Sense::kVertical:
      said->axis = AxisMatch{{0, -1}, {0, 1}, 1};
      return true;
    case Sense::kDense:
    case Sense::kSquare:
      return true;  // understood, though a layout does not show it
    default:
      return false;
  }
}

// Whether the sense tells a quality; it is added then.
bool AddSense(Sense sense, Qualities* said) {
  if (const auto shape = ShapeOf(sense); shape.has_value()) {
    AddShape(*shape, said);
    return true;
  }
  return AddQuantity(sense, said) || AddAlignment(sense, said);
}

}  // namespace

bool AddQuality(const Lexeme& lexeme, Qualities* said) {
  switch (lexeme.kind) {
    case LexemeKind::kCount:
      said->count = lexeme.count;
      break;
    case LexemeKind::kShare:
      said->share = lexeme.share;
      said->mostly = said->mostly || lexeme.share.mostly;
      break;
    case LexemeKind::kSize:
      said->size *= lexeme.size.factor;
      said->least_share = std::max(said->least_share, lexeme.size.least_share);
      said->width *= lexeme.size.width;
      break;
    case LexemeKind::kAxis:
      said->axis = lexeme.axis;
      break;
    case LexemeKind::kSense:
      if (!AddSense(lexeme.sense, said)) return false;
      break;
    default:
      return false;
  }
  said->any = true;
  return true;
}

}  // namespace latticeworld
