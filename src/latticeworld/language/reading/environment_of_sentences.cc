#include "latticeworld/language/reading/environment_of_sentences.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"
#include "latticeworld/language/place_zones.h"
#include "latticeworld/language/reading/sentence_places.h"
#include "latticeworld/language/reading/things/sentence_assets.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {
namespace {

constexpr double kPercentRoom = 0.08;  // that "30 %" leaves to either side
constexpr Range kDense{0.6, 1.0};
constexpr Range kSparse{0.02, 0.35};
// What a bare plural stands for.
constexpr int kSomeLeast = 2;
constexpr int kSome = 3;
constexpr int kSomeMost = 12;

// A range of a sentence: what is meant, and what a reader takes for it.
struct Meant {
  double value = 0.0;
  double least = 0.0;
  double most = 0.0;
  bool beyond = false;  // more was said than is legal, and the nearest that is was taken
};

// room: what a single number leaves to either side.
Meant MeantBy(const Phrase& range, double room, const Range& legal) {
  const std::vector<const Phrase*> numbers = range.FindAll("n");
  const double first = std::strtod(numbers.front()->text.c_str(), nullptr);
  const double last = std::strtod(numbers.back()->text.c_str(), nullptr);
  Meant meant;
  meant.least = std::min(first, last);
  meant.most = std::max(first, last);
  meant.value = (meant.least + meant.most) / 2.0;
  meant.beyond = meant.least < legal.low || meant.most > legal.high;
  if (StartsWith(range.text, "at least")) {
    meant.most = legal.high;
    meant.value = meant.least + room;
  } else if (StartsWith(range.text, "at most")) {
    meant.least = legal.low;
    meant.value = meant.most - room;
  } else if (numbers.size() == 1) {
    meant.least -= room;
    meant.most += room;
  }
  meant.least = std::clamp(meant.least, legal.low, legal.high);
  meant.most = std::clamp(meant.most, legal.low, legal.high);
  meant.value = std::clamp(meant.value, meant.least, meant.most);
  return meant;
}

// The land that a feature's noun is: its letters in either vocabulary.
struct FeatureLand {
  std::string_view name;
  std::string_view suburb;
  std::string_view wild;
  std::string_view nouns;  // parted by blanks
};
constexpr FeatureLand kFeatureLands[] = {
    {"water", "W", "W", " lake pond river stream sea water shore "},
    {"bridge", "R&W", "", " bridge "},
    {"forest", "F", "F", " forest clearing "},
    {"copse", "F", "F", " grove "},
    {"village", "B", "", " village house "},
    {"field", "A", "B", " field farm "},
    {"grass", "G", "B", " grassland "},
    {"road", "R", "", " road crossroads "},
    {"barren", "D", "R", " sand "},
    {"rock", "D", "R", " rock valley "},
    {"snow", "", "S", " snow "},
    {"mountain", "", "SR", " hill mountain "},
};

FeaturePlace FeatureOf(std::string_view noun) {
  const std::string singular = " " + SingularNoun("feature", noun) + " ";
  FeaturePlace place;
  for (const FeatureLand& land : kFeatureLands) {
    if (land.nouns.find(singular) == std::string_view::npos) continue;
    place.name = land.name;
    place.suburb = land.suburb;
    place.wild = land.wild;
    place.near = singular == " shore ";
  }
  return place;
}

std::vector<AgentCategory> CategoriesOf(const Phrase& whom) {
  std::vector<AgentCategory> categories;
  const auto add = [&](AgentCategory category) {
    if (std::find(categories.begin(), categories.end(), category) == categories.end()) {
      categories.push_back(category);
    }
  };
  for (const Phrase* one : whom.FindAll("one")) {
    const std::string name = SingularNoun("who", one->text);
    if (const auto category = FromName<AgentCategory>(name); category.has_value()) {
      add(*category);
    } else if (name == "animal") {
      for (const AgentCategory animal : {AgentCategory::kSheep, AgentCategory::kHorse,
                                         AgentCategory::kEagle, AgentCategory::kWhale}) {
        add(animal);
      }
    } else if (name == "robot") {
      for (const AgentCategory robot : {AgentCategory::kWheeledRobot, AgentCategory::kHumanoidRobot,
                                        AgentCategory::kRoboticDog, AgentCategory::kAerialRobot}) {
        add(robot);
      }
    } else {
      for (const auto& entry : EnumNames(AgentCategory{})) add(entry.value);
    }
  }
  return categories;
}

struct Quantity {
  int least = kSomeLeast;
  int meant = kSome;
  int most = kSomeMost;
  bool counted = false;
};

Quantity QuantityOf(const Phrase& count) {
  const std::vector<const Phrase*> numbers = count.FindAll("n");
  if (numbers.empty()) return {};
  constexpr double kLargest = 1000000.0;
  const auto number = [&](const Phrase* phrase) {
    const double value = std::strtod(phrase->text.c_str(), nullptr);
    return static_cast<int>(std::lround(std::clamp(value, 1.0, kLargest)));
  };
  Quantity quantity;
  quantity.counted = true;
  quantity.least = std::min(number(numbers.front()), number(numbers.back()));
  quantity.most = std::max(number(numbers.front()), number(numbers.back()));
  quantity.meant = (quantity.least + quantity.most) / 2;
  if (StartsWith(count.text, "at least")) quantity.most = std::max(kMaxAgents, quantity.least);
  if (StartsWith(count.text, "at least")) quantity.meant = quantity.least;
  if (StartsWith(count.text, "at most")) quantity.least = 1;
  return quantity;
}

// Says sentence after sentence to what is heard.
class EnvironmentTeller {
 public:
  explicit EnvironmentTeller(const Catalogue& catalogue) : catalogue_(catalogue) {}

  void Say(const Sentence& sentence, const std::string& words) {
    sentence_ = &sentence;
    words_ = words;
    const std::string& form = sentence.form->name;
    if (SayCoarse()) return;
    if (form == "variant") return SayVariant();
    if (form == "density") return SayDensity();
    if (form == "nobody") return SayNobody();
    if (form == "total") return SayTotal();
    if (StartsWith(form, "group")) return SayGroup();
    SayParameter();
  }

  HeardEnvironment Finish(std::vector<std::string> not_understood) {
    heard_.not_understood = std::move(not_understood);
    return std::move(heard_);
  }

 private:
  const Phrase* Slot(std::string_view name) const { return sentence_->whole.Find(name); }
  bool Is(std::string_view form) const { return sentence_->form->name == form; }

  bool SayCoarse() {
    constexpr std::pair<std::string_view, CoarseKey> kForms[] = {
        {"season", CoarseKey::kSeason},       {"weather", CoarseKey::kWeather},
        {"time", CoarseKey::kTimeOfDay},      {"style", CoarseKey::kArtisticStyle},
        {"terrain", CoarseKey::kTerrainType},
    };
    for (const auto& [form, key] : kForms) {
      if (!Is(form)) continue;
      HeardCoarse& heard = heard_.coarse_of(key);
      std::vector<std::string> values;
      for (const Phrase* value : Slot(std::string(form) + "s")->FindAll(form)) {
        values.push_back(value->text);
      }
      if (sentence_->Says("not")) {
        heard.ruled_out = std::move(values);
        heard.ruled_out_words = words_;
        return true;
      }
      if (!heard.value.empty() && heard.value != values.front()) {
        heard_.warnings.push_back(Quote(heard.words) + " and " + Quote(words_) +
                                  " cannot both be; the last one said counts");
      }
      heard.value = values.front();
      heard.also.assign(values.begin() + 1, values.end());
      heard.words = words_;
      return true;
    }
    return false;
  }

  // The values of one key of an asset type that a word may mean: "pine" are those of all seasons.
  std::vector<std::string> ValuesOf(AssetType asset, VariantKey key,
                                    const std::string& word) const {
    std::vector<std::string> names;
    if (key == VariantKey::kSeasonVariant) {
      for (const SeasonVariant& variant : catalogue_.season_variants(asset)) {
        names.push_back(variant.name);
      }
    } else {
      for (const Material& material : catalogue_.materials(asset)) names.push_back(material.name);
    }
    std::vector<std::string> meant;
    for (const std::string& name : names) {
      const bool bare = word == "bare" && name.find(" bare ") != std::string::npos;
      if (name == word || EndsWith(name, " " + word) || bare) meant.push_back(name);
    }
    if (!sentence_->Says("not")) return meant;
    std::vector<std::string> others;
    for (const std::string& name : names) {
      if (std::find(meant.begin(), meant.end(), name) == meant.end()) others.push_back(name);
    }
    return meant.empty() ? meant : others;
  }

  void SayVariant() {
    const AssetType asset = AssetOf(Slot("asset")->text);
    for (const VariantKey key : {VariantKey::kSeasonVariant, VariantKey::kMaterial}) {
      FineWish wish;
      wish.claim.kind = EnvironmentClaimKind::kVariant;
      wish.claim.asset = asset;
      wish.claim.variant_key = key;
      wish.claim.words = words_;
      for (const Phrase* quality : Slot("values")->FindAll("quality")) {
        for (std::string& value : ValuesOf(asset, key, quality->text)) {
          wish.claim.values.push_back(std::move(value));
        }
      }
      if (!wish.claim.values.empty()) {
        heard_.fine.push_back(std::move(wish));
        return;
      }
    }
    heard_.warnings.push_back("nothing of " + Quote(Slot("asset")->text) + " can be " +
                              Quote(Slot("values")->text));
  }

  void WarnOfRange(const Meant& meant, const Range& legal) {
    if (!meant.beyond) return;
    heard_.warnings.push_back(Quote(words_) + " is out of range: " + FormatDouble(legal.low) +
                              " to " + FormatDouble(legal.high) +
                              " is legal, and the nearest of it is taken");
  }

  void SayDensity() {
    FineWish wish;
    wish.claim.kind = EnvironmentClaimKind::kDensity;
    wish.claim.asset = AssetOf(Slot("asset")->text);
    wish.claim.words = words_;
    const Phrase& amount = *Slot("amount");
    if (const Phrase* percent = amount.Find("percent"); percent != nullptr) {
      const Range legal = {0.0, 100.0};
      const Meant meant = MeantBy(*percent, 100.0 * kPercentRoom, legal);
      WarnOfRange(meant, legal);
      wish.value = meant.value / 100.0;
      wish.claim.least = meant.least / 100.0;
      wish.claim.most = meant.most / 100.0;
    } else {
      const Range range = amount.text == "dense"    ? kDense
                          : amount.text == "sparse" ? kSparse
                                                    : Range{0.0, 0.0};
      wish.claim.least = range.low;
      wish.claim.most = range.high;
      wish.value = (range.low + range.high) / 2.0;
    }
    heard_.fine.push_back(std::move(wish));
  }

  void SayParameter() {
    struct Parameter {
      std::string_view form;
      AssetType asset;
      ParameterKey key;
      double room;
    };
    constexpr Parameter kParameters[] = {
        {"wind", AssetType::kDesert, ParameterKey::kWind, 1.0},
        {"level", AssetType::kLake, ParameterKey::kHeight, 0.1},
        {"scale", AssetType::kArchitecture, ParameterKey::kScale, 0.1},
        {"turned", AssetType::kArchitecture, ParameterKey::kRotationYaw, 15.0},
        {"pitch", AssetType::kSnowMountain, ParameterKey::kSlope, 5.0},
    };
    for (const Parameter& parameter : kParameters) {
      if (!Is(parameter.form)) continue;
      const Range legal = RangeOf(parameter.key);
      const Meant meant = MeantBy(*Slot("range"), parameter.room, legal);
      WarnOfRange(meant, legal);
      FineWish wish;
      wish.claim.kind = EnvironmentClaimKind::kParameter;
      wish.claim.asset = parameter.asset;
      wish.claim.parameter_key = parameter.key;
      wish.claim.least = meant.least;
      wish.claim.most = meant.most;
      wish.claim.words = words_;
      wish.value = meant.value;
      heard_.fine.push_back(std::move(wish));
    }
  }

  void SayNobody() {
    EnvironmentClaim claim;
    claim.kind = EnvironmentClaimKind::kNoAgents;
    claim.categories = CategoriesOf(*Slot("whom"));
    if (claim.categories.size() == EnumNames(AgentCategory{}).size()) claim.categories.clear();
    claim.words = words_;
    heard_.absences.push_back(std::move(claim));
  }

  void SayTotal() {
    EnvironmentClaim claim;
    claim.words = words_;
    const Quantity quantity = QuantityOf(*Slot("count"));
    claim.least_quantity = std::min(quantity.least, kMaxAgents);
    claim.most_quantity = std::min(quantity.most, kMaxAgents);
    claim.categories = CategoriesOf(*Slot("whom"));
    const bool all = claim.categories.size() == EnumNames(AgentCategory{}).size();
    claim.kind = all ? EnvironmentClaimKind::kTotalAgents : EnvironmentClaimKind::kAgents;
    if (all) claim.categories.clear();
    heard_.absences.push_back(std::move(claim));
  }

  void SayGroup() {
    AgentWish wish;
    wish.words = words_;
    wish.name = Slot("whom")->text;
    wish.categories = CategoriesOf(*Slot("whom"));
    const Quantity quantity = QuantityOf(*Slot("count"));
    wish.least = quantity.least;
    wish.quantity = quantity.meant;
    wish.most = quantity.most;
    wish.counted = quantity.counted;
    if (const Phrase* states = Slot("states"); states != nullptr) {
      const std::vector<const Phrase*> all = states->FindAll("state");
      wish.state = FromName<AgentState>(all.front()->text);  // any of them will do
    }
    AddPlace(&wish);
    heard_.agents.push_back(std::move(wish));
  }

  void AddPlace(AgentWish* wish) {
    if (const Phrase* place = Slot("place"); place != nullptr) {
      for (const Zone& zone : ZonesOf(*place)) {
        wish->places.push_back(PlaceOfBoxes(zone.name, zone.boxes));
      }
    }
    const Phrase* noun = Slot("features") != nullptr ? Slot("features") : Slot("feature");
    if (noun == nullptr) return;
    FeaturePlace feature = FeatureOf(noun->text);
    if (const Phrase* heading = Slot("heading"); heading != nullptr) {
      feature.near = true;
      feature.on = HeadingOfName(heading->text);
    } else {
      const std::string& near = Slot("near")->text;
      if (near == "away from") {
        heard_.warnings.push_back("heard in part: " + Quote(words_) +
                                  ": nobody is kept away from land");
        return;
      }
      feature.near = feature.near || near == "by" || (near == "at" && feature.name != "bridge");
      if (const Phrase* part = Slot("part"); part != nullptr)
        feature.on = HeadingOfPart(part->text);
    }
    wish->feature = std::move(feature);
  }

  static Heading HeadingOfPart(std::string_view part) {
    // "northern" is "north", "north-western" "north-west".
    return HeadingOfName(part.substr(0, part.size() - std::string_view("ern").size()));
  }

  const Catalogue& catalogue_;
  HeardEnvironment heard_;
  const Sentence* sentence_ = nullptr;
  std::string words_;
};

}  // namespace

HeardEnvironment EnvironmentOfSentences(const std::vector<std::string>& sentences,
                                        const Catalogue& catalogue) {
  EnvironmentTeller teller(catalogue);
  std::vector<std::string> not_understood;
  for (const std::string& words : sentences) {
    const std::optional<Sentence> sentence = ReadSentence(words, SentenceKind::kEnvironment);
    if (sentence.has_value()) {
      teller.Say(*sentence, words);
    } else {
      not_understood.push_back(words);
    }
  }
  return teller.Finish(std::move(not_understood));
}

}  // namespace latticeworld
