#include "latticeworld/environment/environment_claims_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/ranges.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

// Reads the keys of one claim, noting what is missing, unknown or of the wrong type.
class ClaimReader {
 public:
  ClaimReader(const Json& json, std::string pointer, std::vector<Violation>* violations)
      : json_(json), pointer_(std::move(pointer)), violations_(violations) {}

  EnvironmentClaim Read() {
    EnvironmentClaim claim;
    if (!json_.is_object()) {
      Wrong("", "an object", json_);
      return claim;
    }
    const std::size_t before = violations_->size();
    ReadName("kind", &claim.kind);
    if (violations_->size() > before) return claim;
    ReadFields(&claim);
    if (json_.count("words") > 0) ReadText("words", &claim.words);
    NoteUnknownKeys();
    if (violations_->size() > before) return claim;
    for (Violation& violation : Validate(claim)) {
      violation.pointer = pointer_ + violation.pointer;
      violations_->push_back(std::move(violation));
    }
    return claim;
  }

 private:
  void ReadFields(EnvironmentClaim* claim) {
    switch (claim->kind) {
      case EnvironmentClaimKind::kCoarse:
        ReadName("attribute", &claim->coarse_key);
        ReadTexts("values", &claim->values);
        break;
      case EnvironmentClaimKind::kDensity:
        ReadName("asset", &claim->asset);
        ReadBounds(kDensityRange, claim);
        break;
      case EnvironmentClaimKind::kVariant:
        ReadName("asset", &claim->asset);
        ReadName("key", &claim->variant_key);
        ReadTexts("values", &claim->values);
        break;
      case EnvironmentClaimKind::kParameter:
        ReadName("asset", &claim->asset);
        ReadName("key", &claim->parameter_key);
        ReadBounds(RangeOf(claim->parameter_key), claim);
        break;
      case EnvironmentClaimKind::kAgents:
        ReadCategories(&claim->categories);
        ReadQuantities(1, claim);
        if (json_.count("states") > 0) ReadNames("states", &claim->states);
        if (json_.count("positions") > 0) ReadNames("positions", &claim->positions);
        break;
      case EnvironmentClaimKind::kNoAgents:
        ReadCategories(&claim->categories);
        break;
      case EnvironmentClaimKind::kTotalAgents:
        ReadQuantities(0, claim);
        break;
    }
  }

  const Json* Find(const std::string& key) {
    known_.insert(key);
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
  }

  const Json* Demand(const std::string& key) {
    const Json* json = Find(key);
    if (json == nullptr) Add("missing_key", "/" + key, "is missing", "");
    return json;
  }

  void Add(std::string code, const std::string& pointer, std::string message, std::string given) {
    violations_->push_back(
        {std::move(code), pointer_ + pointer, std::move(message), std::move(given)});
  }

  void Wrong(const std::string& pointer, const std::string& wanted, const Json& given) {
    Add("wrong_type", pointer, "must be " + wanted + ", not " + std::string(given.type_name()),
        Quote(given.dump()));
  }

  void ReadText(const std::string& key, std::string* text) {
    const Json* json = Demand(key);
    if (json == nullptr) return;
    if (!json->is_string()) return Wrong("/" + key, "a string", *json);
    *text = json->get<std::string>();
  }

  template <typename Enum>
  void ReadOneName(const Json& json, const std::string& pointer, Enum* value) {
    if (!json.is_string()) return Wrong(pointer, "a string", json);
    const auto name = json.get<std::string>();
    if (const auto found = FromName<Enum>(name)) {
      *value = *found;
    } else {
      Add("unknown_value", pointer, Quote(name) + " is not one of " + LegalNames<Enum>(),
          Quote(name));
    }
  }

  template <typename Enum>
  void ReadName(const std::string& key, Enum* value) {
    if (const Json* json = Demand(key)) ReadOneName(*json, "/" + key, value);
  }

  template <typename Enum>
  void ReadNames(const std::string& key, std::vector<Enum>* values) {
    const Json* json = Demand(key);
    if (json == nullptr) return;
    if (!json->is_array()) return Wrong("/" + key, "an array of names", *json);
    for (std::size_t i = 0; i < json->size(); ++i) {
      values->emplace_back();
      ReadOneName((*json)[i], "/" + key + "/" + std::to_string(i), &values->back());
    }
  }

  void ReadTexts(const std::string& key, std::vector<std::string>* texts) {
    const Json* json = Demand(key);
    if (json == nullptr) return;
    if (!json->is_array()) return Wrong("/" + key, "an array of strings", *json);
    for (std::size_t i = 0; i < json->size(); ++i) {
      const Json& one = (*json)[i];
      if (one.is_string()) {
        texts->push_back(one.get<std::string>());
      } else {
        Wrong("/" + key + "/" + std::to_string(i), "a string", one);
      }
    }
  }

  void ReadCategories(std::vector<AgentCategory>* categories) {
    const Json* json = Demand("category");
    if (json == nullptr || (json->is_string() && json->get<std::string>().empty())) return;
    if (json->is_array()) return ReadNames("category", categories);
    categories->emplace_back();
    ReadOneName(*json, "/category", &categories->back());
  }

  // Returns whether at least one of a pair of bounds is there, and adds a violation if none is.
  bool HasBound(const std::string& least, const std::string& most) {
    if (Find(least) != nullptr || Find(most) != nullptr) return true;
    Add("missing_key", "/" + least, "is missing, and " + most + " too: one is needed", "");
    return false;
  }

  void ReadNumber(const std::string& key, double* value) {
    const Json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_number()) return Wrong("/" + key, "a number", *json);
    *value = json->get<double>();
  }

  void ReadBounds(const Range& legal, EnvironmentClaim* claim) {
    claim->least = legal.low;
    claim->most = legal.high;
    if (!HasBound("least", "most")) return;
    ReadNumber("least", &claim->least);
    ReadNumber("most", &claim->most);
  }

  void ReadWhole(const std::string& key, int* value) {
    const Json* json = Find(key);
    if (json == nullptr) return;
    if (!json->is_number_integer()) return Wrong("/" + key, "a whole number", *json);
    *value = static_cast<int>(std::clamp(json->get<double>(), -1e9, 1e9));
  }

  void ReadQuantities(int lowest, EnvironmentClaim* claim) {
    claim->least_quantity = lowest;
    claim->most_quantity = kMaxAgents;
    if (!HasBound("least_quantity", "most_quantity")) return;
    ReadWhole("least_quantity", &claim->least_quantity);
    ReadWhole("most_quantity", &claim->most_quantity);
  }

  void NoteUnknownKeys() {
    const std::vector<std::string> legal(known_.begin(), known_.end());
    for (const auto& [key, value] : json_.items()) {
      if (known_.count(key) > 0 || key == "words") continue;
      Add("unknown_key", "/" + Quote(key), "is not one of " + Join(legal, ", ") + ", words",
          Quote(value.dump()));
    }
  }

  const Json& json_;
  std::string pointer_;
  std::vector<Violation>* violations_;
  std::set<std::string> known_;
};

Result<Json> ParseText(std::string_view text) {
  JsonLimits limits;  // an array of objects whose values may be arrays
  limits.max_depth = 4;
  Json json;
  std::vector<Violation> violations;
  const bool parsed = ParseStrictly(text, "", limits, &json, &violations);
  if (!violations.empty() || !parsed) {
    return Status::FromViolations("claims", std::move(violations));
  }
  return json;
}

}  // namespace

Result<std::vector<EnvironmentClaim>> ParseEnvironmentClaims(std::string_view text) {
  LW_ASSIGN_OR_RETURN(const Json json, ParseText(text));
  if (!json.is_array()) {
    return Status(StatusCode::kInvalidArgument, "environment claims must be an array",
                  {{"wrong_type", "", "must be an array, not " + std::string(json.type_name()),
                    Quote(json.dump())}});
  }
  std::vector<Violation> violations;
  std::vector<EnvironmentClaim> claims;
  for (std::size_t i = 0; i < json.size(); ++i) {
    claims.push_back(ClaimReader(json[i], "/" + std::to_string(i), &violations).Read());
  }
  if (!violations.empty()) {
    return Status::FromViolations("illegal environment claims", std::move(violations));
  }
  return claims;
}

}  // namespace latticeworld
