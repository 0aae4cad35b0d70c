#ifndef LATTICEWORLD_CAMPAIGN_YAML_READER_H_
#define LATTICEWORLD_CAMPAIGN_YAML_READER_H_

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/common/request_fields.h"
#include "latticeworld/common/status.h"

namespace latticeworld {

// A place in a YAML file as messages name it: "line 12: /worlds/0/size_m".
std::string YamlPlace(const YAML::Node& node, const std::string& path);

// Adds a violation; given: what stands there.
void AddYamlViolation(const YAML::Node& node, const std::string& path, const std::string& code,
                      const std::string& legal, std::vector<Violation>* violations);

// Reads the keys of one mapping and collects what is wrong with them. Each function leaves *out as
// it was where the key is not there or its value is unusable. Keys that nobody asked for are
// violations of Finish().
class YamlMapping {
 public:
  // node: anything; what is no mapping is a violation, and has no keys.
  YamlMapping(const YAML::Node& node, std::string path, std::vector<Violation>* violations);

  bool Has(const std::string& key) const;
  // An invalid node where it is not there. The key counts as asked for.
  YAML::Node Get(const std::string& key);
  // Adds missing_key where it is not there.
  void Require(const std::string& key);

  // A finite number; which of them are legal is for somebody else to say.
  void Number(const std::string& key, double* out);
  void Number(const std::string& key, std::optional<double>* out);
  void Number(const std::string& key, const Range& legal, std::string_view unit, double* out);
  // The same of whole numbers.
  void Whole(const std::string& key, int* out);
  void Whole(const std::string& key, int low, int high, int* out);
  // true or false.
  void Switch(const std::string& key, bool* out);
  void Seed(const std::string& key, std::uint64_t* out);
  // A text of at least least_bytes and at most 20000 bytes.
  void Text(const std::string& key, std::size_t least_bytes, std::string* out);
  // One of `legal`.
  void Choice(const std::string& key, const std::vector<std::string>& legal, std::string* out);
  // Letters, digits, "-" and "_", at most 40.
  void Name(const std::string& key, std::string* out);

  std::string PathOf(const std::string& key) const { return path_ + "/" + key; }
  std::vector<Violation>* violations() { return violations_; }

  // What the owner of the values that were read has against them, at the places of their keys.
  // keys: for the owner's names. Nothing of a key that is told as unusable already.
  void AddIllegal(const FieldNames& keys, std::vector<Violation> illegal);

  void Finish();

 private:
  YAML::Node node_;
  std::string path_;
  std::vector<Violation>* violations_;
  std::set<std::string> asked_;
};

// What a scalar says; false: it is no scalar or says something else.
bool ReadYamlNumber(const YAML::Node& node, double* out);
bool ReadYamlUnsigned(const YAML::Node& node, std::uint64_t* out);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_YAML_READER_H_
