#ifndef LATTICEWORLD_LANGUAGE_LOCAL_DECODING_ATTENTION_CACHE_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_DECODING_ATTENTION_CACHE_H_

#include <cstddef>
#include <vector>

#include "latticeworld/language/local/weights/large_memory.h"

namespace latticeworld {

// Keys and values of the places of a text, of one layer, and the looking back
// on them. Each head's lie apart, in the order in which a query meets them:
// keys in blocks of sixteen places whose first numbers stand side by side, then
// their second ones, and so on; so sixteen products of a query grow together.
class AttentionCache {
 public:
  // heads: of keys and values; width: numbers of a head's key. Both at least 1.
  AttentionCache(std::size_t heads, std::size_t width);

  std::size_t length() const { return length_; }  // places

  // keys, values: `count` places, `stride` floats apart, each heads x width.
  void Append(const float* keys, const float* values, std::size_t stride, std::size_t count);
  // Takes the memory of so many places at once, so that it is not taken again, and twice for a
  // while, as a text grows.
  void Reserve(std::size_t places);
  // Forgets what comes after the first `length` places, at most length().
  void Truncate(std::size_t length);

  // out (width) = the sum of a head's values at the first `length` places (1 to
  // length()) by the softmax of the query's (width) products with their keys
  // over the root of width (Vaswani et al. 2017). Several threads may look back
  // at once.
  void Attend(std::size_t head, const float* query, std::size_t length, float* out) const;

 private:
  struct Head {
    LargeVector<float> keys;    // (blocks of 16 places x width x 16)
    LargeVector<float> values;  // (places x padded width), 0 in the padding
  };

  std::size_t width_;
  std::size_t padded_width_;  // a multiple of 16
  std::size_t length_ = 0;
  std::vector<Head> heads_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_DECODING_ATTENTION_CACHE_H_
