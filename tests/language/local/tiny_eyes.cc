#include "language/local/tiny_eyes.h"

#include "language/local/tiny_gguf.h"

namespace latticeworld {

std::string TinyEyesGguf(const TinyEyes& eyes) {
  tiny::GgufWriter writer(eyes.seed, eyes.weight_type, eyes.without);
  writer.Entry("general.architecture", tiny::kString, tiny::Text("latticeworld-eyes"));
  writer.Number("eyes.side", eyes.side);
  writer.Number("eyes.patch", eyes.patch);
  writer.Number("eyes.width", eyes.width);
  writer.Number("eyes.heads", eyes.heads);
  writer.Number("eyes.hidden", eyes.hidden);
  writer.Number("eyes.layers", eyes.layers);
  writer.Number("eyes.embedding", eyes.embedding);
  const auto linear = [&](const std::string& name, std::size_t rows, std::size_t columns) {
    writer.Weights(name + ".weight", rows, columns, false);
    writer.Weights(name + ".bias", 1, rows, true);
  };
  const auto norm = [&](const std::string& name) {
    writer.Weights(name + ".weight", 1, eyes.width, true);
    writer.Weights(name + ".bias", 1, eyes.width, true);
  };
  const std::size_t grid = eyes.side / eyes.patch;
  linear("eyes.patches", eyes.width, eyes.patch * eyes.patch);
  writer.Weights("eyes.whole.weight", 1, eyes.width, true);
  writer.Weights("eyes.places.weight", 1 + grid * grid, eyes.width, false);
  for (std::size_t i = 0; i < eyes.layers; ++i) {
    const std::string block = "blk." + std::to_string(i) + ".";
    norm(block + "first_norm");
    norm(block + "second_norm");
    linear(block + "queries_keys_values", 3 * eyes.width, eyes.width);
    linear(block + "attended", eyes.width, eyes.width);
    linear(block + "up", eyes.hidden, eyes.width);
    linear(block + "down", eyes.width, eyes.hidden);
  }
  norm("projection.norm");
  linear("projection.near", eyes.embedding, 9 * eyes.width);
  linear("projection.each", eyes.embedding, eyes.embedding);
  return writer.File();
}

}  // namespace latticeworld
