#include "latticeworld/terrain/masked_blur.h"

#include <algorithm>
#include <cstddef>

#include "latticeworld/geomorphology/blur.h"

namespace latticeworld::internal {

MaskedBlur BlurMasked(const Grid<unsigned char>& mask, const Grid<float>& values,
                      double sigma_cells) {
  MaskedBlur result{Grid<float>(mask.rows(), mask.cols()), Grid<float>(mask.rows(), mask.cols())};
  for (std::size_t i = 0; i < mask.size(); ++i) {
    result.share.data()[i] = mask.data()[i];
    result.value.data()[i] = mask.data()[i] != 0 ? values.data()[i] : 0.0f;
  }
  GaussianBlur(sigma_cells, &result.share);
  GaussianBlur(sigma_cells, &result.value);
  constexpr float kTiny = 1e-3f;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    result.value.data()[i] /= std::max(result.share.data()[i], kTiny);
  }
  return result;
}

}  // namespace latticeworld::internal
