#include "latticeworld/common/strict_json.h"

#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxViolations = 500;

// Follows the parser through a document, notes what the parsed value no longer shows (keys that
// stand twice in one object) and leaves out what lies beyond the limits.
class ParseObserver {
 public:
  ParseObserver(const std::string& origin, const JsonLimits& limits,
                std::vector<Violation>* violations)
      : origin_(origin), limits_(limits), violations_(violations) {}

  // Whether to keep what was parsed. `depth` counts the containers that enclose the event; end
  // events do not come for what was not kept, so the path is cut to it instead of popped.
  bool Note(int depth, Json::parse_event_t event, const Json& parsed) {
    const auto level = static_cast<std::size_t>(depth);
    if (level > path_.size()) return false;  // within what was not kept
    switch (event) {
      case Json::parse_event_t::object_start:
      case Json::parse_event_t::array_start:
        path_.resize(level);
        if (!IsElementKept()) return false;
        if (depth >= limits_.max_depth) return NoteTooDeep();
        path_.push_back({event == Json::parse_event_t::array_start, 0, "", {}, {}});
        return true;
      case Json::parse_event_t::value:
        path_.resize(level);
        return IsElementKept();
      case Json::parse_event_t::key:
        path_.resize(level);
        return NoteKey(parsed.get<std::string>());
      default:
        return true;
    }
  }

 private:
  struct Container {
    bool is_array;
    std::size_t elements;            // of an array so far
    std::string key;                 // of an object's latest member
    std::set<std::string> keys;      // of an object so far
    std::set<std::string> repeated;  // those that have been reported
  };

  bool IsElementKept() {
    return path_.empty() || !path_.back().is_array ||
           ++path_.back().elements <= limits_.max_elements;
  }

  bool NoteTooDeep() {
    if (!is_too_deep_) {
      violations_->push_back({"too_deep", Pointer(),
                              "is nested deeper than " + std::to_string(limits_.max_depth), ""});
    }
    is_too_deep_ = true;
    return false;
  }

  bool NoteKey(std::string key) {
    Container& object = path_.back();
    object.key = std::move(key);
    if (!object.keys.insert(object.key).second && object.repeated.insert(object.key).second) {
      violations_->push_back({"duplicate_key", Pointer(),
                              "the key " + Quote(object.key) + " stands twice in one object",
                              Quote(object.key)});
    }
    return object.keys.size() <= limits_.max_keys;
  }

  std::string Pointer() const {
    std::string pointer = origin_;
    for (const Container& container : path_) {
      pointer += "/";
      pointer +=
          container.is_array ? std::to_string(container.elements - 1) : PointerToken(container.key);
    }
    return pointer;
  }

  const std::string& origin_;
  const JsonLimits& limits_;
  std::vector<Violation>* violations_;
  std::vector<Container> path_;  // from the outermost container inwards, at most max_depth
  bool is_too_deep_ = false;
};

}  // namespace

std::string PointerToken(std::string_view key) {
  const std::string quoted = Quote(key);  // with quotation marks around it
  std::string token;
  for (const char c : std::string_view(quoted).substr(1, quoted.size() - 2)) {
    if (c == '~') {
      token += "~0";
    } else if (c == '/') {
      token += "~1";
    } else {
      token += c;
    }
  }
  return token;
}

bool ParseStrictly(std::string_view text, const std::string& origin, const JsonLimits& limits,
                   Json* json, std::vector<Violation>* violations) {
  if (text.size() > limits.max_bytes) {
    violations->push_back({"too_long", origin,
                           "has " + std::to_string(text.size()) + " bytes; legal are at most " +
                               std::to_string(limits.max_bytes),
                           std::to_string(text.size())});
    return false;
  }
  if (const Status status = ValidateText("the text", text, limits.max_bytes); !status.ok()) {
    violations->push_back({"bad_encoding", origin, status.message(), Quote(text)});
    return false;
  }
  ParseObserver observer(origin, limits, violations);
  try {
    // nlohmann's parser is iterative: depth costs no stack.
    *json = Json::parse(text.begin(), text.end(),
                        [&](int depth, Json::parse_event_t event, Json& parsed) {
                          return observer.Note(depth, event, parsed);
                        });
    return !json->is_discarded();
  } catch (const Json::exception& exception) {  // also numbers beyond double, as 1e400
    violations->push_back(
        {"parse_error", origin, "is not JSON: " + Quote(exception.what(), 300), Quote(text)});
    return false;
  }
}

void LimitViolations(std::vector<Violation>* violations) {
  if (violations->size() <= kMaxViolations) return;
  const std::size_t further = violations->size() - kMaxViolations;
  violations->resize(kMaxViolations);
  violations->push_back(
      {"more_violations", "", "and " + std::to_string(further) + " further violations", ""});
}

}  // namespace latticeworld
