#include <cmath>
#include <cstdint>
#include <string>

#include "latticeworld/language/local/decoding/height_eyes.h"
#include "latticeworld/language/local/weights/gguf_file.h"
#include "latticeworld/language/local/weights/weight_reader.h"

namespace latticeworld {
namespace {

constexpr std::uint64_t kMostSide = 1024, kMostWidth = 1u << 13, kMostLayers = 128;
constexpr std::uint64_t kMostHidden = 4 * kMostWidth;

}  // namespace

Result<HeightEyes> HeightEyes::Open(const std::string& path) {
  LW_ASSIGN_OR_RETURN(const GgufFile file, GgufFile::Open(path));
  Result<HeightEyes> eyes = Read(file);
  if (!eyes.ok()) return eyes.status().WithContext("'" + path + "'");
  return eyes;
}

Result<HeightEyes> HeightEyes::Read(const GgufFile& file) {
  LW_ASSIGN_OR_RETURN(const std::string architecture, file.Text("general.architecture"));
  if (architecture != "latticeworld-eyes")
    return DataLoss("a model of the architecture '" + architecture +
                    "'; what sees heights is 'latticeworld-eyes'");
  // Sizes are read first, and must fit each other.
  HeightEyes eyes;
  LW_ASSIGN_OR_RETURN(eyes.side_, file.Integer("eyes.side", 2, kMostSide));
  LW_ASSIGN_OR_RETURN(eyes.patch_, file.Integer("eyes.patch", 1, eyes.side_));
  LW_ASSIGN_OR_RETURN(eyes.width_, file.Integer("eyes.width", 1, kMostWidth));
  LW_ASSIGN_OR_RETURN(eyes.heads_, file.Integer("eyes.heads", 1, eyes.width_));
  LW_ASSIGN_OR_RETURN(const std::size_t hidden, file.Integer("eyes.hidden", 1, kMostHidden));
  LW_ASSIGN_OR_RETURN(const std::size_t layers, file.Integer("eyes.layers", 1, kMostLayers));
  LW_ASSIGN_OR_RETURN(const std::size_t embedding, file.Integer("eyes.embedding", 1, kMostWidth));
  eyes.grid_ = eyes.side_ / eyes.patch_;
  if (eyes.side_ % eyes.patch_ != 0 || eyes.grid_ % 2 != 0 || eyes.width_ % eyes.heads_ != 0)
    return DataLoss(std::to_string(eyes.side_) + " samples in patches of " +
                    std::to_string(eyes.patch_) + ", " + std::to_string(eyes.width_) +
                    " values shared by " + std::to_string(eyes.heads_) +
                    " heads; legal are an even number of whole patches and equal shares");
  const std::size_t width = eyes.width_;
  // Weights come in the order in which they are used; the reader keeps the first error.
  WeightReader reader(&file);
  const auto linear = [&reader](const std::string& name, std::size_t rows, std::size_t columns) {
    return Linear{reader.Matrix(name + ".weight", rows, columns),
                  reader.Vector(name + ".bias", rows)};
  };
  const auto norm = [&reader, width](const std::string& name) {
    return Norm{reader.Vector(name + ".weight", width), reader.Vector(name + ".bias", width)};
  };
  eyes.patches_ = linear("eyes.patches", width, eyes.patch_ * eyes.patch_);
  eyes.whole_ = reader.Vector("eyes.whole.weight", width);
  const std::size_t places = 1 + eyes.grid_ * eyes.grid_;
  const WeightMatrix offsets = reader.Matrix("eyes.places.weight", places, width);
  eyes.places_.resize(offsets.rows() * offsets.columns());
  for (std::size_t i = 0; i < offsets.rows(); ++i) offsets.Row(i, eyes.places_.data() + i * width);
  for (std::size_t i = 0; i < layers && reader.status().ok(); ++i) {
    const std::string block = "blk." + std::to_string(i) + ".";
    eyes.layers_.push_back({norm(block + "first_norm"), norm(block + "second_norm"),
                            linear(block + "queries_keys_values", 3 * width, width),
                            linear(block + "attended", width, width),
                            linear(block + "up", hidden, width),
                            linear(block + "down", width, hidden)});
  }
  eyes.projection_norm_ = norm("projection.norm");
  eyes.near_ = linear("projection.near", embedding, 9 * width);
  eyes.each_ = linear("projection.each", embedding, embedding);
  LW_RETURN_IF_ERROR(reader.status());
  LW_RETURN_IF_ERROR(reader.CheckAllRead());
  return eyes;
}

}  // namespace latticeworld
