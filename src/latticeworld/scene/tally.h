#ifndef LATTICEWORLD_SCENE_TALLY_H_
#define LATTICEWORLD_SCENE_TALLY_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/catalogue/asset_kind.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// Why a place that was tried is none.
enum class Refusal : std::uint8_t {
  kNone,
  kWaterOrRoad,  // or too near to them, or over the world's edge
  kTooSteep,
  kOccupied,  // by something solid
  kHabitat    // no model of the kind grows there
};
inline constexpr int kRefusalCount = 5;

// How many of each kind the densities ask for, and why places were refused.
class Tally {
 public:
  struct Kind {
    double wanted = 0.0;
    std::array<long, kRefusalCount> refused{};  // by Refusal

    void Refuse(Refusal refusal) { ++refused[static_cast<std::size_t>(refusal)]; }
  };

  Kind& Of(AssetKind kind) { return kinds_[static_cast<std::size_t>(kind)]; }
  const Kind& Of(AssetKind kind) const { return kinds_[static_cast<std::size_t>(kind)]; }

  // What was wanted and what is in `assets`, one a kind.
  std::vector<KindCount> Count(const std::vector<Asset>& assets) const;
  // A warning for each kind of which clearly fewer were placed than wanted, or none at all: how
  // many, and why.
  std::vector<std::string> Shortfalls(const std::vector<KindCount>& counts) const;

 private:
  std::array<Kind, kAssetKindCount> kinds_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_TALLY_H_
