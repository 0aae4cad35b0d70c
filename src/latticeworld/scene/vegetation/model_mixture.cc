#include "latticeworld/scene/vegetation/model_mixture.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "latticeworld/common/check.h"
#include "latticeworld/common/random.h"
#include "latticeworld/environment/rules.h"

namespace latticeworld {
namespace {

constexpr double kDominantShare = 0.75;     // of a stand where all suit alike
constexpr double kDominanceContrast = 1.2;  // of the patches of dominant and other models
constexpr double kPatch_m = 45.0;           // width of a patch of one model
constexpr double kDominance_m = 80.0;
constexpr double kOtherShown = 0.1;       // of the individuals show another variant or material
constexpr double kLeastOfDominant = 0.5;  // suitability: the environment has asked for it
constexpr double kAtShoreShare = 0.8;     // of what stands at the water's edge belongs there only
constexpr double kWettestLand = 0.75;     // away from water (SiteMap)
constexpr std::uint32_t kEveryLetter = 0xffffffffu;

double Below(const Preference& preference, double value) {
  return value >= preference.low ? 1.0
                                 : std::max(0.0, 1.0 - (preference.low - value) / preference.fade);
}

double Above(const Preference& preference, double value) {
  return value <= preference.high
             ? 1.0
             : std::max(0.0, 1.0 - (value - preference.high) / preference.fade);
}

// How little shade hinders it.
double LightFor(double shade_tolerance, double canopy) {
  return 1.0 - canopy * (1.0 - shade_tolerance);
}

std::uint32_t BitOf(char letter) { return 1u << (static_cast<unsigned>(letter) & 31u); }

std::uint32_t BitsOf(std::string_view letters) {
  if (letters.empty()) return kEveryLetter;
  std::uint32_t bits = 0;
  for (const char letter : letters) bits |= BitOf(letter);
  return bits;
}

}  // namespace

double SuitabilityOf(const Preference& preference, double value) {
  return Below(preference, value) * Above(preference, value);
}

ModelMixture::ModelMixture(const Catalogue& catalogue, const EnvironmentConfig& environment,
                           AssetKind kind, Vocabulary vocabulary, std::uint64_t seed)
    : dominance_(StreamSeed(seed, "dominance"), kDominance_m) {
  const AssetType type = TypeOf(kind);
  const FineAttribute& fine = environment.fine_of(type);
  const FineBounds bounds = BoundsOf(environment.coarse, type, catalogue);
  const std::vector<std::string_view>& variant_names = catalogue.ValuesOf(type).season_variants;
  const std::vector<std::string_view>& material_names = catalogue.ValuesOf(type).materials;

  // What the environment names first; Validate has refused names that the type does not know.
  const auto values_of = [](const std::vector<std::string_view>& names, std::string_view named,
                            const std::vector<ValueBound>& legal, auto&& can, bool* has_named) {
    Values values;
    std::optional<std::uint8_t> usual, possible;
    *has_named = false;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!can(i)) continue;
      const auto value = static_cast<std::uint8_t>(i);
      if (names[i] == named) {
        usual = value;
        *has_named = true;
      } else if (legal[i].legal()) {
        values.others.push_back(value);
      } else if (!possible) {
        possible = value;
      }
    }
    if (!usual && !values.others.empty()) {
      usual = values.others.front();
      values.others.erase(values.others.begin());
    }
    values.usual = usual.value_or(possible.value_or(0));
    return values;
  };

  std::vector<bool> wears, is_of;
  for (const std::uint8_t model : catalogue.models_of(kind)) {
    bool has_variant = false, has_material = false;
    const Values variants = values_of(
        variant_names, fine.season_variant, bounds.season_variants,
        [&](std::size_t i) { return catalogue.CanWear(model, i); }, &has_variant);
    const Values materials = values_of(
        material_names, fine.material, bounds.materials,
        [&](std::size_t i) { return catalogue.CanBeOf(model, i); }, &has_material);
    wears.push_back(has_variant);
    is_of.push_back(has_material);
    const AssetModel& data = catalogue.models()[model];
    entries_.push_back(
        {model, &data, true, Below(data.habitat.wetness, kWettestLand) <= 0.0,
         BitsOf(vocabulary == Vocabulary::kSuburb ? data.letters_suburb : data.letters_wild),
         variants, materials, PatchNoise(StreamSeed(seed, "patches/" + data.name), kPatch_m)});
  }
  const auto some_but_not_all = [](const std::vector<bool>& flags) {
    return std::count(flags.begin(), flags.end(), true) %
               static_cast<std::ptrdiff_t>(flags.size()) !=
           0;
  };
  const std::vector<bool>* said = some_but_not_all(wears)   ? &wears
                                  : some_but_not_all(is_of) ? &is_of
                                                            : nullptr;
  double weight = 0.0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    entry.dominant = said == nullptr || (*said)[i];
    const double share = entry.data->share * (entry.dominant ? 1.0 : 0.5);
    clumping_ += share * entry.data->habitat.clumping;
    weight += share;
  }
  clumping_ /= weight;
}

void ModelMixture::Keep(char letter, const std::function<bool(const AssetModel&)>& keep) {
  const std::uint32_t bit = BitOf(letter);
  const auto stays = [&](const Entry& entry) {
    return (entry.letters & bit) != 0 && keep(*entry.data);
  };
  if (std::none_of(entries_.begin(), entries_.end(), stays)) return;
  for (Entry& entry : entries_) {
    if (!stays(entry)) entry.letters &= ~bit;
  }
}

const ModelMixture::Entry* ModelMixture::EntryOf(std::uint8_t model) const {
  for (const Entry& entry : entries_) {
    if (entry.model == model) return &entry;
  }
  return nullptr;
}

std::uint8_t ModelMixture::Show(const Values& values, PointRandom* random) {
  const double draw = random->Uniform();
  if (values.others.empty() || draw >= kOtherShown) return values.usual;
  return values.others[static_cast<std::size_t>(draw / kOtherShown * values.others.size())];
}

ModelMixture::Choice ModelMixture::MakeChoice(const Entry& entry, PointRandom* random) const {
  Choice choice;
  choice.model = entry.model;
  choice.season_variant = Show(entry.variants, random);
  choice.material = Show(entry.materials, random);
  return choice;
}

ModelMixture::Group ModelMixture::GroupOf(const Entry& entry) {
  return entry.at_shore ? kShore : entry.dominant ? kDominant : kOther;
}

bool ModelMixture::has_shore_models() const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [](const Entry& entry) { return entry.at_shore; });
}

void ModelMixture::Weigh(WorldPoint point, const Site& site, double canopy, char letter,
                         Weights* weights) const {
  const std::uint32_t bit = BitOf(letter);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    weights->of_entry[i] = 0.0f;
    if ((entry.letters & bit) == 0) continue;
    const Habitat& habitat = entry.data->habitat;
    const double limit =
        Above(habitat.altitude, site.altitude) * Above(habitat.slope_deg, site.slope_deg);
    double suitability = Below(habitat.altitude, site.altitude) *
                         Below(habitat.slope_deg, site.slope_deg) *
                         SuitabilityOf(habitat.wetness, site.wetness) *
                         SuitabilityOf(habitat.northness, site.northness) *
                         LightFor(habitat.shade_tolerance, canopy);
    const Group group = GroupOf(entry);
    if (group == kDominant) {
      suitability = kLeastOfDominant + (1.0 - kLeastOfDominant) * suitability;
    }
    suitability *= limit;
    if (suitability <= 0.0) continue;
    if (group != kShore) weights->limit = std::max(weights->limit, limit);
    // With more clumping, models go from evenly mixed to groups of one model.
    const double contrast = 1.0 + 5.0 * habitat.clumping;
    const double patch = std::exp(contrast * (entry.patches.At(point) - 0.5));
    weights->of_entry[i] = static_cast<float>(entry.data->share * suitability * patch);
    weights->sum[group] += weights->of_entry[i];
    weights->best[group] = std::max(weights->best[group], suitability);
  }
}

ModelMixture::Choice ModelMixture::Draw(const Weights& weights, Group group, const Site& site,
                                        PointRandom* random) const {
  double draw = random->Uniform() * weights.sum[group];
  const Entry* chosen = nullptr;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (weights.of_entry[i] <= 0.0f || GroupOf(entries_[i]) != group) continue;
    chosen = &entries_[i];
    draw -= weights.of_entry[i];
    if (draw < 0.0) break;
  }
  LW_CHECK(chosen != nullptr, "only groups that can stand there are drawn from");
  Choice choice = MakeChoice(*chosen, random);
  choice.vigour = Above(chosen->data->habitat.altitude, site.altitude);
  return choice;
}

std::optional<ModelMixture::Choice> ModelMixture::At(WorldPoint point, const Site& site,
                                                     double canopy, char letter,
                                                     PointRandom* random) const {
  Weights weights;
  Weigh(point, site, canopy, letter, &weights);
  if (weights.best[kShore] > 0.0 && random->Chance(kAtShoreShare * weights.best[kShore])) {
    return Draw(weights, kShore, site, random);
  }
  if (!random->Chance(weights.limit)) return std::nullopt;
  const double share =
      std::clamp(kDominantShare + kDominanceContrast * (0.5 - dominance_.At(point)), 0.0, 1.0);
  const double dominant = share * weights.best[kDominant];
  const double other = (1.0 - share) * weights.best[kOther];
  if (dominant + other > 0.0) {
    const bool is_dominant = random->Chance(dominant / (dominant + other));
    return Draw(weights, is_dominant ? kDominant : kOther, site, random);
  }
  // The patch is of the group that has nothing here.
  if (weights.best[kDominant] > 0.0) return Draw(weights, kDominant, site, random);
  if (weights.best[kOther] > 0.0) return Draw(weights, kOther, site, random);
  return std::nullopt;
}

std::optional<ModelMixture::Choice> ModelMixture::OfShoreAt(WorldPoint point, const Site& site,
                                                            double canopy, char letter,
                                                            PointRandom* random) const {
  Weights weights;
  Weigh(point, site, canopy, letter, &weights);
  if (!random->Chance(weights.best[kShore])) return std::nullopt;
  return Draw(weights, kShore, site, random);
}

ModelMixture::Choice ModelMixture::Dress(std::uint8_t model, PointRandom* random) const {
  const Entry* entry = EntryOf(model);
  LW_CHECK(entry != nullptr, "a mixture dresses the models of its own kind");
  return MakeChoice(*entry, random);
}

}  // namespace latticeworld
