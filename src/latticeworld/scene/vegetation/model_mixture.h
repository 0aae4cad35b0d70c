#ifndef LATTICEWORLD_SCENE_VEGETATION_MODEL_MIXTURE_H_
#define LATTICEWORLD_SCENE_VEGETATION_MODEL_MIXTURE_H_

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/layout/vocabulary.h"
#include "latticeworld/scene/point_random.h"
#include "latticeworld/scene/site.h"
#include "latticeworld/scene/vegetation/patch_noise.h"

namespace latticeworld {

// How well a value suits: 1 within the preference, falling to 0 over its fade.
double SuitabilityOf(const Preference& preference, double value);

// Which model of a kind stands at a place, and which seasonal variant and material it shows.
//
// The environment's fine attribute names the dominant models: those that wear its variant where not
// all models of the kind do (the oaks of "summer oak"), else those that can be of its material.
// They make up most of every stand; the others stand among them where their habitats suit better,
// and each stands in patches, the clearer the more it clumps. What a model cannot wear it replaces
// by what the coarse attributes allow; a few individuals show another allowed value.
//
// Cold and steepness are limits: above its altitude and slope a model never stands. Low ground,
// wetness, aspect and shade decide between models only, but for those whose habitat is the water's
// edge, which stand nowhere else.
class ModelMixture {
 public:
  struct Choice {
    std::uint8_t model = 0;
    std::uint8_t season_variant = 0;
    std::uint8_t material = 0;
    double vigour = 1.0;  // (0, 1]: how far below its limit of altitude the model stands
  };

  ModelMixture(const Catalogue& catalogue, const EnvironmentConfig& environment, AssetKind kind,
               Vocabulary vocabulary, std::uint64_t seed);

  // Keeps on a letter only those models that `keep` says, unless that were none.
  void Keep(char letter, const std::function<bool(const AssetModel&)>& keep);

  // The choice at a place of that letter; canopy: share of the sky that trees hide, [0, 1].
  // nullopt: no model stands there.
  std::optional<Choice> At(WorldPoint point, const Site& site, double canopy, char letter,
                           PointRandom* random) const;
  // The same of the models whose habitat is the water's edge.
  std::optional<Choice> OfShoreAt(WorldPoint point, const Site& site, double canopy, char letter,
                                  PointRandom* random) const;
  bool has_shore_models() const;
  // The same for a model that is given.
  Choice Dress(std::uint8_t model, PointRandom* random) const;

  // How much the kind stands in groups: Habitat::clumping of the dominant models and, at half
  // weight, of the others.
  double clumping() const { return clumping_; }

 private:
  struct Values {                      // what one model can show of variants or materials
    std::uint8_t usual = 0;            // the environment's, or the first allowed
    std::vector<std::uint8_t> others;  // allowed too
  };
  struct Entry {
    std::uint8_t model;
    const AssetModel* data;
    bool dominant;
    bool at_shore;          // stands at the water's edge only
    std::uint32_t letters;  // one bit a letter
    Values variants, materials;
    PatchNoise patches;
  };

  enum Group { kDominant, kOther, kShore };
  static constexpr int kGroups = 3;
  // What stands for what at one place.
  struct Weights {
    std::array<float, 256> of_entry;  // a catalogue has 255 models at most
    std::array<double, kGroups> sum{}, best{};
    double limit = 0.0;  // the largest of cold and steepness, but for the shore
  };

  static Group GroupOf(const Entry& entry);
  void Weigh(WorldPoint point, const Site& site, double canopy, char letter,
             Weights* weights) const;
  Choice Draw(const Weights& weights, Group group, const Site& site, PointRandom* random) const;
  const Entry* EntryOf(std::uint8_t model) const;
  Choice MakeChoice(const Entry& entry, PointRandom* random) const;
  static std::uint8_t Show(const Values& values, PointRandom* random);

  std::vector<Entry> entries_;  // of the kind's models, in their order
  PatchNoise dominance_;
  double clumping_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_VEGETATION_MODEL_MIXTURE_H_
