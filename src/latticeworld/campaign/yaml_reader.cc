#include "latticeworld/campaign/yaml_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <limits>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMostTextBytes = 20000;
constexpr std::size_t kMostNameBytes = 40;

std::string GivenOf(const YAML::Node& node) {
  if (!node.IsDefined() || node.IsNull()) return "nothing";
  if (node.IsScalar()) return Quote(node.Scalar());
  if (node.IsSequence()) return "a list of " + std::to_string(node.size());
  return "a mapping of " + std::to_string(node.size());
}

bool IsNameLetter(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '-' || letter == '_';
}

}  // namespace

std::string YamlPlace(const YAML::Node& node, const std::string& path) {
  const YAML::Mark mark = node.IsDefined() ? node.Mark() : YAML::Mark::null_mark();
  const std::string where = path.empty() ? "/" : path;
  return mark.is_null() ? where : "line " + std::to_string(mark.line + 1) + ": " + where;
}

void AddYamlViolation(const YAML::Node& node, const std::string& path, const std::string& code,
                      const std::string& legal, std::vector<Violation>* violations) {
  const std::string given = GivenOf(node);
  violations->push_back({code, YamlPlace(node, path), "is " + given + "; " + legal, given});
}

bool ReadYamlNumber(const YAML::Node& node, double* out) {
  if (!node.IsDefined() || !node.IsScalar() || node.Scalar().empty()) return false;
  const std::string& text = node.Scalar();
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size() || !std::isfinite(value)) return false;
  *out = value;
  return true;
}

bool ReadYamlUnsigned(const YAML::Node& node, std::uint64_t* out) {
  if (!node.IsDefined() || !node.IsScalar()) return false;
  const std::string& text = node.Scalar();
  const bool digits = std::all_of(text.begin(), text.end(),
                                  [](char letter) { return letter >= '0' && letter <= '9'; });
  // 2^64 has twenty digits.
  if (text.empty() || text.size() > 19 || !digits) return false;
  *out = std::strtoull(text.c_str(), nullptr, 10);
  return true;
}

YamlMapping::YamlMapping(const YAML::Node& node, std::string path,
                         std::vector<Violation>* violations)
    : node_(node.IsDefined() && node.IsMap() ? node : YAML::Node(YAML::NodeType::Map)),
      path_(std::move(path)),
      violations_(violations) {
  if (node.IsDefined() && node.IsMap()) {
    std::set<std::string> seen;
    for (const auto& entry : node_) {
      if (!entry.first.IsScalar()) {
        AddYamlViolation(entry.first, path_, "bad_key", "keys are texts", violations_);
      } else if (!seen.insert(entry.first.Scalar()).second) {
        AddYamlViolation(entry.first, path_, "duplicate_key", "a key stands once", violations_);
      }
    }
    return;
  }
  AddYamlViolation(node, path_, "wrong_type", "a mapping of keys to values is wanted", violations_);
}

bool YamlMapping::Has(const std::string& key) const {
  // The node is constant, since asking another one would make the key.
  const YAML::Node& constant = node_;
  return constant[key].IsDefined();
}

YAML::Node YamlMapping::Get(const std::string& key) {
  asked_.insert(key);
  const YAML::Node& constant = node_;
  return Has(key) ? YAML::Node(constant[key]) : YAML::Node(YAML::NodeType::Undefined);
}

void YamlMapping::Require(const std::string& key) {
  asked_.insert(key);
  if (Has(key)) return;
  violations_->push_back({"missing_key", YamlPlace(node_, PathOf(key)), "is missing", ""});
}

void YamlMapping::Number(const std::string& key, double* out) {
  const YAML::Node node = Get(key);
  if (!Has(key) || ReadYamlNumber(node, out)) return;
  AddYamlViolation(node, PathOf(key), "wrong_type", "a number is wanted", violations_);
}

void YamlMapping::Number(const std::string& key, std::optional<double>* out) {
  double value = std::nan("");
  Number(key, &value);
  if (!std::isnan(value)) *out = value;
}

void YamlMapping::Number(const std::string& key, const Range& legal, std::string_view unit,
                         double* out) {
  std::optional<double> value;
  Number(key, &value);
  if (!value) return;
  CheckRange(YamlPlace(Get(key), PathOf(key)), *value, legal, unit, violations_);
  if (legal.Contains(*value)) *out = *value;
}

void YamlMapping::Whole(const std::string& key, int* out) {
  const YAML::Node node = Get(key);
  if (!Has(key)) return;
  double value = 0.0;
  if (!ReadYamlNumber(node, &value) || value != std::trunc(value) ||
      std::abs(value) > std::numeric_limits<int>::max()) {
    AddYamlViolation(node, PathOf(key), "wrong_type", "a whole number is wanted", violations_);
    return;
  }
  *out = static_cast<int>(value);
}

void YamlMapping::Whole(const std::string& key, int low, int high, int* out) {
  const YAML::Node node = Get(key);
  if (!Has(key)) return;
  std::uint64_t value = 0;
  const bool read = ReadYamlUnsigned(node, &value);
  if (!read || value < static_cast<std::uint64_t>(low) ||
      value > static_cast<std::uint64_t>(high)) {
    AddYamlViolation(
        node, PathOf(key), "out_of_range",
        "legal are whole numbers of " + std::to_string(low) + " to " + std::to_string(high),
        violations_);
    return;
  }
  *out = static_cast<int>(value);
}

void YamlMapping::Switch(const std::string& key, bool* out) {
  const YAML::Node node = Get(key);
  if (!Has(key)) return;
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  if (text != "true" && text != "false") {
    AddYamlViolation(node, PathOf(key), "wrong_type", "true or false is wanted", violations_);
    return;
  }
  *out = text == "true";
}

void YamlMapping::Seed(const std::string& key, std::uint64_t* out) {
  const YAML::Node node = Get(key);
  if (!Has(key)) return;
  std::uint64_t value = 0;
  if (!ReadYamlUnsigned(node, &value) || value == 0) {
    AddYamlViolation(node, PathOf(key), "wrong_type", "a whole number above 0 is wanted",
                     violations_);
    return;
  }
  *out = value;
}

void YamlMapping::Text(const std::string& key, std::size_t least_bytes, std::string* out) {
  const YAML::Node node = Get(key);
  if (!Has(key)) return;
  const Status legal = node.IsScalar() ? ValidateText(key, node.Scalar(), kMostTextBytes)
                                       : InvalidArgument("a text is wanted");
  if (!legal.ok() || node.Scalar().size() < least_bytes) {
    AddYamlViolation(node, PathOf(key), "bad_text",
                     legal.ok() ? "a text that is not empty is wanted" : legal.message(),
                     violations_);
    return;
  }
  *out = node.Scalar();
}

void YamlMapping::Choice(const std::string& key, const std::vector<std::string>& legal,
                         std::string* out) {
  const YAML::Node node = Get(key);
  if (!Has(key)) return;
  if (!node.IsScalar() || std::find(legal.begin(), legal.end(), node.Scalar()) == legal.end()) {
    AddYamlViolation(node, PathOf(key), "unknown_value", "legal are " + Join(legal, ", "),
                     violations_);
    return;
  }
  *out = node.Scalar();
}

void YamlMapping::Name(const std::string& key, std::string* out) {
  const YAML::Node node = Get(key);
  if (!Has(key)) return;
  const std::string name = node.IsScalar() ? node.Scalar() : "";
  if (name.empty() || name.size() > kMostNameBytes ||
      !std::all_of(name.begin(), name.end(), IsNameLetter)) {
    AddYamlViolation(node, PathOf(key), "bad_name",
                     "legal are 1 to 40 letters, digits, '-' and '_'", violations_);
    return;
  }
  *out = name;
}

void YamlMapping::AddIllegal(const FieldNames& keys, std::vector<Violation> illegal) {
  Rename(keys, &illegal);
  const std::vector<Violation> before = *violations_;
  for (Violation& violation : illegal) {
    const YAML::Node node = Has(violation.pointer) ? Get(violation.pointer) : node_;
    violation.pointer = YamlPlace(node, PathOf(violation.pointer));
    const bool told = std::any_of(before.begin(), before.end(), [&violation](const auto& one) {
      return one.pointer == violation.pointer;
    });
    if (!told) violations_->push_back(std::move(violation));
  }
}

void YamlMapping::Finish() {
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar() || asked_.count(entry.first.Scalar()) > 0) continue;
    violations_->push_back(
        {"unknown_key", YamlPlace(entry.first, PathOf(entry.first.Scalar())),
         "is no key here; legal are " + Join({asked_.begin(), asked_.end()}, ", "),
         entry.first.Scalar()});
  }
}

}  // namespace latticeworld
