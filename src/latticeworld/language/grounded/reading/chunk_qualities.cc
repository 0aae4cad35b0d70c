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
      if (const auto shape = ShapeOf(lexeme.sense); shape.has_value()) {
        // "a straight strip of grassland": a strip is long anyway.
        const bool line =
            shape == ClaimShape::kElongated &&
            (said->shape == ClaimShape::kStraight || said->shape == ClaimShape::kWinding);
        if (!line) said->shape = shape;
        break;
      }
      switch (lexeme.sense) {
        case Sense::kScattered:
          said->texture = Texture::kScattered;
          break;
        case Sense::kClustered:
          said->texture = Texture::kClustered;
          break;
        case Sense::kSparse:
        case Sense::kLittle:
          said->little = true;
          break;
        case Sense::kMuch:
          said->much = true;
          break;
        case Sense::kFew:
          said->few = true;
          break;
        case Sense::kSeveral:
          said->group = true;
          break;
        case Sense::kMany:
          said->count = CountMatch{4, CountMatch::kUnbounded, 1};
          break;
        case Sense::kSingle:
          said->count = CountMatch{1, 1, 1};
          break;
        case Sense::kMostly:
          said->mostly = true;
          break;
        case Sense::kParallelEach:
          said->parallel = true;
          break;
        case Sense::kHorizontal:
          said->axis = AxisMatch{{-1, 0}, {1, 0}, 1};
          break;
        case Sense::kVertical:
          said->axis = AxisMatch{{0, -1}, {0, 1}, 1};
          break;
        case Sense::kAbsent:
          said->none = true;
          break;
        case Sense::kAtMost:
          said->at_most = true;
          break;
        case Sense::kDense:
        case Sense::kSquare:
          break;
        default:
          return false;
      }
      break;
    default:
      return false;
  }
  said->any = true;
  return true;
}

}  // namespace latticeworld
