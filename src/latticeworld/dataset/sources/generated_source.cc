#include "latticeworld/dataset/sources/generated_source.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/range.h"
#include "latticeworld/dataset/sources/random_plan.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/language/grounded/synthesis/layout_synthesis.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMostGroups = 10'000'000;
constexpr int kReliefSide = 129;  // samples
constexpr double kLandSize_m = 512.0;

std::string NameOfPlace(const GeneratedSourceOptions& options, std::size_t index) {
  char number[24];
  std::snprintf(number, sizeof(number), "%07zu", index);
  return "generated-" + std::to_string(options.seed) + "-" + number;
}

// Heights [m], (129 x 129), the lowest 0: rolling land, fractal hills, or crests, tilted or not.
Grid<float> RandomLand(RandomStream* random) {
  const GridGeometry geometry = GridGeometry::FromCells(kReliefSide, kLandSize_m);
  const std::uint64_t seed = random->NextBits();
  NoiseOptions noise;
  noise.wavelength_m = kLandSize_m * random->Uniform(0.35, 1.2);
  noise.octaves = random->UniformInt(3, 6);
  noise.gain = random->Uniform(0.3, 0.55);
  Grid<float> land = random->Chance(0.35) ? RidgedNoise(geometry, noise, seed, /*threads=*/1)
                                          : FractalNoise(geometry, noise, seed, /*threads=*/1);
  // A slope of the whole land, of up to twice its hills.
  const double tilt = random->Chance(0.5) ? random->Uniform(0.3, 2.0) : 0.0;
  const double heading_rad = random->Uniform(0.0, 6.283185307179586);
  for (int r = 0; r < land.rows(); ++r) {
    for (int c = 0; c < land.cols(); ++c) {
      const double u = static_cast<double>(c) / (kReliefSide - 1) - 0.5;
      const double v = static_cast<double>(r) / (kReliefSide - 1) - 0.5;
      land(r, c) +=
          static_cast<float>(tilt * (u * std::cos(heading_rad) + v * std::sin(heading_rad)));
    }
  }
  // The relief is as likely to be from 5 to 50 m as from 50 to 500 m.
  const double relief_m = std::exp(random->Uniform(std::log(3.0), std::log(1500.0)));
  const auto [low, high] = std::minmax_element(land.begin(), land.end());
  const float offset = *low;
  const float scale = *high > offset ? static_cast<float>(relief_m) / (*high - offset) : 0.0f;
  for (float& height : land) height = (height - offset) * scale;
  return land;
}

class GeneratedSource final : public InstanceSource {
 public:
  explicit GeneratedSource(const GeneratedSourceOptions& options)
      : options_(options),
        card_{"generated", "Places laid out by LatticeWorld's own generator from random plans",
              "BSD-3-Clause", ""} {}

  const SourceCard& card() const override { return card_; }
  std::size_t group_count() const override { return options_.groups; }
  std::string GroupName(std::size_t index) const override { return NameOfPlace(options_, index); }
  Result<std::vector<Instance>> ReadGroup(std::size_t index) const override {
    LW_CHECK(index < options_.groups, "there is no such group");
    std::vector<Instance> instances;
    instances.push_back(GeneratePlace(options_, index).instance);
    return instances;
  }

 private:
  const GeneratedSourceOptions options_;
  const SourceCard card_;
};

}  // namespace

std::vector<Violation> Validate(const GeneratedSourceOptions& options) {
  std::vector<Violation> violations;
  CheckRange("groups", static_cast<double>(options.groups), {1.0, 1.0 * kMostGroups}, "",
             &violations);
  CheckRange("relief_share", options.relief_share, {0.0, 1.0}, "", &violations);
  return violations;
}

GeneratedPlace GeneratePlace(const GeneratedSourceOptions& options, std::size_t index) {
  RandomStream random(options.seed, "dataset/generated/" + std::to_string(index));
  GeneratedPlace place;
  place.instance.id = place.instance.group = NameOfPlace(options, index);
  const Vocabulary vocabulary = random.Chance(0.5) ? Vocabulary::kSuburb : Vocabulary::kWild;
  if (random.Chance(options.relief_share))
    place.instance.relief = std::make_shared<Relief>(MakeRelief(RandomLand(&random)));
  LayoutPlan plan = RandomPlan(vocabulary, &random);
  const std::vector<Claim> claims = std::exchange(plan.claims, {});
  place.instance.layout = SynthesizeLayout(plan, place.instance.relief.get(), random.NextBits());
  const LayoutMasks masks(place.instance.layout);
  for (const Claim& claim : claims) {
    if (DistanceOf(claim, masks) == 0.0) place.claims.push_back(claim);
  }
  return place;
}

Result<std::unique_ptr<InstanceSource>> MakeGeneratedSource(const GeneratedSourceOptions& options) {
  LW_RETURN_IF_ERROR(Status::FromViolations("generated source", Validate(options)));
  return std::unique_ptr<InstanceSource>(new GeneratedSource(options));
}

}  // namespace latticeworld
