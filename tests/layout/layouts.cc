#include "layouts.h"

#include "latticeworld/common/random.h"

namespace latticeworld {

SymbolicLayout Uniform(Vocabulary vocabulary, char letter) {
  return {vocabulary, Grid<char>(kLayoutSize, kLayoutSize, letter)};
}

void Fill(SymbolicLayout* layout, CellIndex first, CellIndex last, char letter) {
  for (int row = first.row; row <= last.row; ++row) {
    for (int col = first.col; col <= last.col; ++col) layout->cells(row, col) = letter;
  }
}

SymbolicLayout Random(Vocabulary vocabulary, std::uint64_t seed) {
  RandomStream random(seed, "random layout");
  SymbolicLayout layout = Uniform(vocabulary, '?');
  const auto& classes = ClassesOf(vocabulary);
  for (char& cell : layout.cells) {
    cell = classes[static_cast<std::size_t>(
                       random.UniformInt(0, static_cast<int>(classes.size()) - 1))]
               .letter;
  }
  return layout;
}

}  // namespace latticeworld
