#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_HEARD_ATTRIBUTE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_HEARD_ATTRIBUTE_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {

// What an instruction says of one attribute. What is said last counts, so that a correction does
// ("... no, make it night"); where it takes back what was said before, a warning quotes both. Words
// that only hint at a value count as long as nothing is said outright, the first of them.
template <typename Value>
class HeardAttribute {
 public:
  void Hear(std::optional<Value> value, std::string_view words, bool weak,
            std::vector<std::string>* warnings) {
    if (!value.has_value()) return;
    if (weak) {
      if (!hint_.has_value()) hint_ = value;
      return;
    }
    if (said_.has_value() && said_ != value) {
      warnings->push_back(Quote(words_) + " and " + Quote(words) +
                          " cannot both be; the last one said counts");
    }
    said_ = value;
    words_ = std::string(words);
  }

  std::optional<Value> Chosen() const { return said_.has_value() ? said_ : hint_; }

 private:
  std::optional<Value> said_;
  std::optional<Value> hint_;
  std::string words_;  // of what was said
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_HEARD_ATTRIBUTE_H_
