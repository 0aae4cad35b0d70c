#include "latticeworld/layout/claims/claims_json.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/layout/claims/claim_fields.h"
#include "latticeworld/layout/claims/claim_headings.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;
using internal::BoundUnit;
using internal::ClaimField;
using internal::ClaimFields;

constexpr std::size_t kMaxJsonBytes = 1 << 20;
constexpr std::size_t kMaxClaims = 1000;
constexpr int kMaxDepth = 8;                 // a zone's boxes lie at the fifth level
constexpr std::size_t kMaxKeys = 64;         // of one object; the largest legal one has eleven
constexpr std::size_t kMaxBoxes = 64;        // of one zone
constexpr std::size_t kMaxViolations = 200;  // what a person or a program can still use

std::string PointerToken(std::string_view key) {
  std::string token;
  for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

class ClaimReader {
 public:
  ClaimReader(const Json& json, std::string pointer, Vocabulary vocabulary,
              std::vector<Violation>* violations)
      : json_(json),
        pointer_(std::move(pointer)),
        vocabulary_(vocabulary),
        violations_(violations) {}

  Claim Read() {
    if (!json_.is_object()) {
      Wrong("", "an object", json_);
      return claim_;
    }
    if (!ReadKind()) return claim_;
    fields_ = internal::FieldsOf(claim_.kind);
    ReadLetter(ClaimField::kSubject, "subject", &claim_.subject);
    ReadLetter(ClaimField::kObject, "object", &claim_.object);
    ReadLetter(ClaimField::kSecondObject, "second_object", &claim_.second_object);
    ReadSequence();
    ReadZone(ClaimField::kZone, "zone", &claim_.zone);
    ReadZone(ClaimField::kObjectZone, "object_zone", &claim_.object_zone);
    ReadZone(ClaimField::kFrom, "from", &claim_.from);
    ReadZone(ClaimField::kTo, "to", &claim_.to);
    ReadHeading();
    ReadShape();
    ReadBound(ClaimField::kLeast, "least", &claim_.least);
    ReadBound(ClaimField::kMost, "most", &claim_.most);
    ReadWords();
    NoteUnknownKeys();
    NoteContradictions();
    return claim_;
  }

 private:
  void Add(std::string code, const std::string& pointer, std::string message, std::string given) {
    violations_->push_back(
        {std::move(code), pointer_ + pointer, std::move(message), std::move(given)});
  }
  static std::string Shown(const Json& json) {
    return Quote(json.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  void Wrong(const std::string& pointer, const std::string& wanted, const Json& given) {
    Add("wrong_type", pointer, "must be " + wanted + ", not " + Shown(given), Shown(given));
  }

  bool ReadKind() {
    const auto found = json_.find("kind");
    if (found == json_.end()) {
      Add("missing_key", "/kind", "is missing; it is one of " + LegalNames<ClaimKind>(), "");
      return false;
    }
    if (!found->is_string()) {
      Wrong("/kind", "a string", *found);
      return false;
    }
    const auto kind = FromName<ClaimKind>(found->get<std::string>());
    if (!kind) {
      Add("unknown_kind", "/kind",
          Shown(*found) + " is no kind of claim; one of " + LegalNames<ClaimKind>() + " is",
          Shown(*found));
      return false;
    }
    claim_.kind = *kind;
    return true;
  }

  // The value of a key that this kind uses; notes one that it needs and lacks. A key that it does
  // not use is left to NoteUnknownKeys.
  const Json* Find(ClaimField field, const char* key) {
    if (!fields_.Uses(field)) return nullptr;
    known_.insert(key);
    const auto found = json_.find(key);
    if (found != json_.end()) return &*found;
    if ((fields_.needed & field) != 0) {
      Add("missing_key", std::string("/") + key,
          "is missing; a claim of kind " + std::string(NameOf(claim_.kind)) + " needs it", "");
    }
    return nullptr;
  }

  bool IsLegal(char letter) const { return FindClass(vocabulary_, letter) != nullptr; }

  void ReadLetter(ClaimField field, const char* key, char* letter) {
    const Json* json = Find(field, key);
    if (json == nullptr) return;
    const std::string pointer = std::string("/") + key;
    if (!json->is_string()) return Wrong(pointer, "a letter", *json);
    const auto text = json->get<std::string>();
    if (text.size() != 1 || !IsLegal(text[0])) {
      return Add("foreign_letter", pointer,
                 Shown(*json) + " is not one of " + std::string(LegalLetters(vocabulary_)),
                 Shown(*json));
    }
    *letter = text[0];
  }

  void ReadSequence() {
    const Json* json = Find(ClaimField::kSequence, "sequence");
    if (json == nullptr) return;
    if (!json->is_string()) return Wrong("/sequence", "letters", *json);
    const auto text = json->get<std::string>();
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (!IsLegal(text[i])) {
        return Add(
            "foreign_letter", "/sequence",
            Shown(*json) + " holds other letters than " + std::string(LegalLetters(vocabulary_)),
            Shown(*json));
      }
      if (text.find(text[i], i + 1) != std::string::npos) {
        return Add("repeated_letter", "/sequence", Shown(*json) + " says a letter twice",
                   Shown(*json));
      }
    }
    const bool order = claim_.kind == ClaimKind::kOrder;
    if (text.size() < (order ? 2u : 1u)) {
      return Add("too_short", "/sequence",
                 std::string("must have ") + (order ? "two letters" : "one letter") + " or more",
                 Shown(*json));
    }
    claim_.sequence = text;
  }

  void ReadZone(ClaimField field, const char* key, Zone* zone) {
    const Json* json = Find(field, key);
    if (json == nullptr) return;
    const std::string pointer = std::string("/") + key;
    if (json->is_string()) {
      if (const auto found = FindZone(json->get<std::string>())) {
        *zone = *found;
        return;
      }
      std::string names;
      for (const std::string_view name : ZoneNames()) {
        names += (names.empty() ? "" : ", ") + std::string(name);
      }
      return Add("unknown_zone", pointer, Shown(*json) + " is not one of " + names, Shown(*json));
    }
    if (!json->is_object()) return Wrong(pointer, "a zone's name, or its name and boxes", *json);
    ReadBoxes(*json, pointer, zone);
  }

  void ReadBoxes(const Json& json, const std::string& pointer, Zone* zone) {
    // A zone has a name and boxes, and nothing else.
    for (const auto& item : json.items()) {
      if (item.key() == "name" || item.key() == "boxes") continue;
      Add("unknown_key", pointer + "/" + PointerToken(item.key()),
          "is unknown; a zone has name and boxes", Quote(item.key()));
    }
    if (!json.contains("name") || !json["name"].is_string()) {
      Add("missing_key", pointer + "/name", "must be the zone's name", "");
    } else {
      zone->name = json["name"].get<std::string>();
    }
    if (!json.contains("boxes") || !json["boxes"].is_array() || json["boxes"].empty() ||
        json["boxes"].size() > kMaxBoxes) {
      return Add("missing_key", pointer + "/boxes",
                 "must be an array of 1 to " + std::to_string(kMaxBoxes) +
                     " boxes [u_min, u_max, v_min, v_max]",
                 "");
    }
    // Each box that is wrong is told by itself.
    const Json& boxes = json["boxes"];
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Json& box = boxes[i];
      const std::string where = pointer + "/boxes/" + std::to_string(i);
      const bool numbers = box.is_array() && box.size() == 4 &&
                           std::all_of(box.begin(), box.end(),
                                       [](const Json& number) { return number.is_number(); });
      if (!numbers) {
        Wrong(where, "four numbers u_min, u_max, v_min, v_max", box);
        continue;
      }
      const UnitBox unit{box[0].get<double>(), box[1].get<double>(), box[2].get<double>(),
                         box[3].get<double>()};
      const bool legal = unit.u_min >= 0.0 && unit.u_min < unit.u_max && unit.u_max <= 1.0 &&
                         unit.v_min >= 0.0 && unit.v_min < unit.v_max && unit.v_max <= 1.0;
      if (!legal) {
        Add("out_of_range", where,
            Shown(box) + " is not u_min < u_max, v_min < v_max, each from 0 to 1", Shown(box));
        continue;
      }
      zone->boxes.push_back(unit);
    }
    // Together they must hold a cell.
    if (!zone->boxes.empty() && MaskOf(*zone).empty()) {
      Add("out_of_range", pointer + "/boxes", "hold the centre of no cell", Shown(boxes));
    }
  }

  void ReadHeading() {
    const Json* json = Find(ClaimField::kHeading, "heading");
    if (json == nullptr) return;
    if (!json->is_string()) return Wrong("/heading", "a heading's name", *json);
    const auto name = json->get<std::string>();
    std::string names;
    for (const internal::NamedHeading& named : internal::kHeadings) {
      if (named.name == name) {
        claim_.heading = named.heading;
        return;
      }
      names += (names.empty() ? "" : ", ") + std::string(named.name);
    }
    Add("unknown_heading", "/heading", Shown(*json) + " is not one of " + names, Shown(*json));
  }

  void ReadShape() {
    const Json* json = Find(ClaimField::kShapeName, "shape");
    if (json == nullptr) return;
    if (!json->is_string()) return Wrong("/shape", "a shape's name", *json);
    const auto shape = FromName<ClaimShape>(json->get<std::string>());
    if (!shape) {
      return Add("unknown_shape", "/shape",
                 Shown(*json) + " is not one of " + LegalNames<ClaimShape>(), Shown(*json));
    }
    claim_.shape = *shape;
  }

  void ReadBound(ClaimField field, const char* key, double* bound) {
    const Json* json = Find(field, key);
    if (json == nullptr) return;
    const std::string pointer = std::string("/") + key;
    if (!json->is_number()) return Wrong(pointer, "a number", *json);
    const double value = json->get<double>();
    const bool share = fields_.unit == BoundUnit::kShare;
    const double highest = share                                ? 1.0
                           : fields_.unit == BoundUnit::kPieces ? kLayoutSize * kLayoutSize
                                                                : kLayoutSize;
    if (!(value >= 0.0 && value <= highest) || (!share && value != std::floor(value))) {
      return Add("out_of_range", pointer,
                 Shown(*json) + " is not a " + (share ? "share" : "whole number") + " from 0 to " +
                     FormatDouble(highest),
                 Shown(*json));
    }
    *bound = value;
  }

  void ReadWords() {
    known_.insert("words");
    const auto found = json_.find("words");
    if (found == json_.end()) return;
    if (!found->is_string()) return Wrong("/words", "a string", *found);
    claim_.words = found->get<std::string>();
  }

  void NoteUnknownKeys() {
    known_.insert("kind");
    std::string legal;
    for (const std::string& key : known_) legal += (legal.empty() ? "" : ", ") + key;
    for (const auto& item : json_.items()) {
      if (known_.count(item.key()) > 0) continue;
      Add("unknown_key", "/" + PointerToken(item.key()),
          Quote(item.key()) + " is no key of a claim of kind " + std::string(NameOf(claim_.kind)) +
              "; its keys are " + legal,
          Quote(item.key()));
    }
  }

  // What each key allows and all of them together do not.
  void NoteContradictions() {
    const auto unsaid = [](double bound) { return bound == Claim::kUnsaid; };
    const double least = unsaid(claim_.least) ? 0.0 : claim_.least;
    if (!unsaid(claim_.most) && least > claim_.most) {
      Add("out_of_range", "/most",
          FormatDouble(claim_.most) + " is less than least, " + FormatDouble(least),
          FormatDouble(claim_.most));
    }
    if (claim_.kind == ClaimKind::kAmount && !json_.contains("least") && !json_.contains("most")) {
      Add("missing_key", "/least", "least or most is needed by a claim of kind amount", "");
    }
    if (claim_.kind == ClaimKind::kAlong && !json_.contains("object") && !json_.contains("zone")) {
      Add("missing_key", "/object", "object or zone is needed by a claim of kind along", "");
    }
    if (claim_.kind == ClaimKind::kCourse && !json_.contains("from") && !json_.contains("to")) {
      Add("missing_key", "/from", "from or to is needed by a claim of kind course", "");
    }
    if (claim_.kind == ClaimKind::kRest &&
        claim_.sequence.find(claim_.subject) != std::string::npos) {
      Add("repeated_letter", "/sequence",
          Quote(claim_.sequence) + " holds the subject, which is to be the rest",
          Quote(claim_.sequence));
    }
  }

  const Json& json_;
  const std::string pointer_;
  const Vocabulary vocabulary_;
  std::vector<Violation>* const violations_;
  Claim claim_;
  ClaimFields fields_;
  std::set<std::string> known_;
};

// Whether the text is nested as no claims are, or says a key twice, which the parsed value no
// longer shows. Read event by event, so that neither depth nor keys cost more than their bounds.
class ShapeObserver {
 public:
  bool Note(int depth, Json::parse_event_t event, const Json& parsed) {
    const auto level = static_cast<std::size_t>(depth);
    if (event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start) {
      too_deep_ = too_deep_ || depth >= kMaxDepth;
      keys_.resize(level);
      keys_.emplace_back();
      return !too_deep_;
    }
    if (event == Json::parse_event_t::key) {
      keys_.resize(level);
      std::set<std::string>& keys = keys_.back();
      const auto key = parsed.get<std::string>();
      if (keys.size() >= kMaxKeys) {
        too_many_ = true;
      } else if (!keys.insert(key).second) {
        repeated_.push_back(key);
      }
      return !too_many_;
    }
    return !too_deep_ && !too_many_;
  }

  void AddTo(std::vector<Violation>* violations) const {
    if (too_deep_) {
      violations->push_back(
          {"too_deep", "", "is nested deeper than " + std::to_string(kMaxDepth) + " levels", ""});
    }
    if (too_many_) {
      violations->push_back({"too_many_keys", "",
                             "has an object of more than " + std::to_string(kMaxKeys) + " keys",
                             ""});
    }
    for (const std::string& key : repeated_) {
      violations->push_back(
          {"repeated_key", "", "says the key " + Quote(key) + " twice in one object", Quote(key)});
    }
  }

 private:
  bool too_deep_ = false;
  bool too_many_ = false;
  std::vector<std::string> repeated_;
  std::vector<std::set<std::string>> keys_;  // of each open container
};

Result<Json> Parse(std::string_view text) {
  if (text.size() > kMaxJsonBytes) {
    return InvalidArgument("claims have " + std::to_string(text.size()) + " bytes; at most " +
                           std::to_string(kMaxJsonBytes) + " are read");
  }
  ShapeObserver observer;
  Json json;
  try {
    json = Json::parse(text.begin(), text.end(),
                       [&](int depth, Json::parse_event_t event, const Json& parsed) {
                         return observer.Note(depth, event, parsed);
                       });
  } catch (const Json::exception& error) {
    return InvalidArgument("claims are not JSON: " + Quote(error.what(), 200));
  }
  std::vector<Violation> violations;
  observer.AddTo(&violations);
  if (!violations.empty()) return Status::FromViolations("claims", std::move(violations));
  return json;
}

Json EncodeZone(const Zone& zone) {
  if (zone.is_anywhere()) return "anywhere";
  if (FindZone(zone.name) == zone) return zone.name;
  Json boxes = Json::array();
  for (const UnitBox& box : zone.boxes) {
    boxes.push_back(Json::array({box.u_min, box.u_max, box.v_min, box.v_max}));
  }
  return {{"name", zone.name}, {"boxes", std::move(boxes)}};
}

Json Encode(const Claim& claim) {
  const ClaimFields fields = internal::FieldsOf(claim.kind);
  Json json = {{"kind", NameOf(claim.kind)}};
  const auto letter = [&](ClaimField field, const char* key, char value) {
    if (fields.Uses(field) && value != '\0') json[key] = std::string(1, value);
  };
  const auto zone = [&](ClaimField field, const char* key, const Zone& value) {
    const bool needed = (fields.needed & field) != 0;
    if (fields.Uses(field) && (needed || !value.is_anywhere())) json[key] = EncodeZone(value);
  };
  const auto bound = [&](ClaimField field, const char* key, double value) {
    if (!fields.Uses(field) || value == Claim::kUnsaid) return;
    if (fields.unit == BoundUnit::kShare) {
      json[key] = value;
    } else {
      json[key] = static_cast<std::int64_t>(value);
    }
  };
  letter(ClaimField::kSubject, "subject", claim.subject);
  letter(ClaimField::kObject, "object", claim.object);
  letter(ClaimField::kSecondObject, "second_object", claim.second_object);
  if (fields.Uses(ClaimField::kSequence)) json["sequence"] = claim.sequence;
  zone(ClaimField::kZone, "zone", claim.zone);
  zone(ClaimField::kObjectZone, "object_zone", claim.object_zone);
  zone(ClaimField::kFrom, "from", claim.from);
  zone(ClaimField::kTo, "to", claim.to);
  if (fields.Uses(ClaimField::kHeading)) json["heading"] = internal::NameOf(claim.heading);
  if (fields.Uses(ClaimField::kShapeName)) json["shape"] = NameOf(claim.shape);
  bound(ClaimField::kLeast, "least", claim.least);
  bound(ClaimField::kMost, "most", claim.most);
  if (!claim.words.empty()) json["words"] = claim.words;
  return json;
}

}  // namespace

Result<std::vector<Claim>> DecodeClaims(std::string_view text, Vocabulary vocabulary) {
  auto json = Parse(text);
  if (!json.ok()) return json.status();
  if (!json->is_array()) return InvalidArgument("claims are not an array");
  if (json->size() > kMaxClaims) {
    return InvalidArgument("claims are " + std::to_string(json->size()) + "; at most " +
                           std::to_string(kMaxClaims) + " are read");
  }
  std::vector<Claim> claims;
  std::vector<Violation> violations;
  for (std::size_t i = 0; i < json->size() && violations.size() < kMaxViolations; ++i) {
    claims.push_back(
        ClaimReader((*json)[i], "/" + std::to_string(i), vocabulary, &violations).Read());
  }
  if (!violations.empty()) return Status::FromViolations("claims", std::move(violations));
  return claims;
}

std::string EncodeClaims(const std::vector<Claim>& claims) {
  std::string text = "[";
  for (std::size_t i = 0; i < claims.size(); ++i) {
    text += i == 0 ? "\n  " : ",\n  ";
    text += Encode(claims[i]).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text + (claims.empty() ? "]\n" : "\n]\n");
}

}  // namespace latticeworld
