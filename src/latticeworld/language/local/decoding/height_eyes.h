#ifndef LATTICEWORLD_LANGUAGE_LOCAL_DECODING_HEIGHT_EYES_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_DECODING_HEIGHT_EYES_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/language/local/weights/weight_matrix.h"

namespace latticeworld {

class GgufFile;

// What shows a language model the heights of the land: a vision transformer (Dosovitskiy et al.
// 2021) whose features of patches, four of them to one place, a small convolutional network turns
// into embeddings that stand where words' do (after Liu et al. 2023, "Visual instruction tuning").
// training/ makes its files; docs/training.md says how.
class HeightEyes {
 public:
  // Errors: those of GgufFile::Open and ReadHeightEyes, naming the file.
  static Result<HeightEyes> Open(const std::string& path);
  // Errors: DATA_LOSS naming what is missing, of another shape, or no eyes.
  static Result<HeightEyes> Read(const GgufFile& file);

  // Embeddings that a picture becomes, and the width of each: that of the language model's.
  std::size_t places() const { return grid_ / 2 * (grid_ / 2); }
  std::size_t embedding() const { return each_.weights.rows(); }

  // (places x embedding), row by row from the north. picture: a grey PNG of 8 or 16 bits, at least
  // 33 pixels a side, row 0 north; of its heights only the shape counts, not their scale. Errors:
  // INVALID_ARGUMENT (no such picture).
  Result<std::vector<float>> See(std::string_view picture) const;
  // The same of heights in any unit.
  std::vector<float> See(const Grid<float>& heights) const;

 private:
  struct Linear {
    WeightMatrix weights;
    std::vector<float> bias;
    // out (count x rows) of in (count x columns).
    std::vector<float> operator()(const std::vector<float>& in, std::size_t count) const;
  };
  struct Norm {
    std::vector<float> gains, bias;
    std::vector<float> operator()(const std::vector<float>& in) const;
  };
  struct Layer {
    Norm first_norm, second_norm;
    Linear queries_keys_values, attended, up, down;
  };

  HeightEyes() = default;
  // Embeds the whole and each patch: (1 + grid^2) x width, row-major.
  std::vector<float> Patches(const Grid<float>& heights) const;
  void Attend(const Layer& layer, std::vector<float>* places) const;
  void FeedForward(const Layer& layer, std::vector<float>* places) const;
  std::vector<float> Project(const std::vector<float>& features) const;

  std::size_t side_ = 0;   // samples a side
  std::size_t patch_ = 0;  // of them a side of a patch
  std::size_t grid_ = 0;   // patches a side; even
  std::size_t width_ = 0;
  std::size_t heads_ = 0;
  Linear patches_;
  std::vector<float> whole_;   // width: what stands for the picture as a whole
  std::vector<float> places_;  // (1 + grid^2) x width
  std::vector<Layer> layers_;
  Norm projection_norm_;
  Linear near_;  // of 3 x 3 patches around each second one
  Linear each_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_DECODING_HEIGHT_EYES_H_
