#ifndef LATTICEWORLD_TESTS_TERRAIN_TEST_LAYOUTS_H_
#define LATTICEWORLD_TESTS_TERRAIN_TEST_LAYOUTS_H_

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld::testing_layouts {

inline SymbolicLayout Filled(Vocabulary vocabulary, char letter) {
  return {vocabulary, Grid<char>(kLayoutSize, kLayoutSize, letter)};
}

inline void PaintDisc(char letter, double row, double col, double radius, SymbolicLayout* layout) {
  for (int r = 0; r < kLayoutSize; ++r) {
    for (int c = 0; c < kLayoutSize; ++c) {
      if (std::hypot(r - row, c - col) <= radius) layout->cells(r, c) = letter;
    }
  }
}

// Blobs of every class of the vocabulary on a ground of its first, by the seed.
inline SymbolicLayout Blobs(Vocabulary vocabulary, std::uint64_t seed) {
  RandomStream random(seed, "test_layouts");
  const std::string letters = vocabulary == Vocabulary::kSuburb ? "GAFBDW" : "BFRSW";
  SymbolicLayout layout = Filled(vocabulary, letters[0]);
  for (int i = 0; i < 12; ++i) {
    PaintDisc(letters[1 + i % (letters.size() - 1)], random.Uniform(0, 31), random.Uniform(0, 31),
              random.Uniform(2.0, 6.0), &layout);
  }
  return layout;
}

// A river from north to south, two cells wide, crossed by a road.
inline SymbolicLayout RiverAndRoad() {
  SymbolicLayout layout = Filled(Vocabulary::kSuburb, 'G');
  for (int r = 0; r < kLayoutSize; ++r) {
    const int c = 15 + static_cast<int>(std::lround(4.0 * std::sin(r / 5.0)));
    for (int k = 0; k < 3; ++k) layout.cells(r, c + k) = 'W';
  }
  for (int c = 0; c < kLayoutSize; ++c) layout.cells(20, c) = 'R';
  return layout;
}

inline SymbolicLayout Checker(Vocabulary vocabulary, char a, char b) {
  SymbolicLayout layout = Filled(vocabulary, a);
  for (int r = 0; r < kLayoutSize; ++r) {
    for (int c = 0; c < kLayoutSize; ++c) {
      if ((r / 2 + c / 2) % 2 != 0) layout.cells(r, c) = b;
    }
  }
  return layout;
}

inline SymbolicLayout AnyLetters(Vocabulary vocabulary, std::uint64_t seed) {
  RandomStream random(seed, "test_layouts/any");
  const std::string letters = vocabulary == Vocabulary::kSuburb ? "ABDFGRW" : "BFRSW";
  SymbolicLayout layout = Filled(vocabulary, letters[0]);
  for (char& cell : layout.cells) {
    cell = letters[random.UniformInt(0, static_cast<int>(letters.size()) - 1)];
  }
  return layout;
}

inline std::vector<SymbolicLayout> Many() {
  std::vector<SymbolicLayout> layouts = {
      RiverAndRoad(),
      Checker(Vocabulary::kSuburb, 'G', 'W'),
      Checker(Vocabulary::kWild, 'S', 'W'),
      Filled(Vocabulary::kWild, 'W'),
      Filled(Vocabulary::kWild, 'S'),
      Filled(Vocabulary::kSuburb, 'R'),
      AnyLetters(Vocabulary::kSuburb, 1),
      AnyLetters(Vocabulary::kWild, 2),
  };
  for (int seed = 1; seed <= 6; ++seed) {
    layouts.push_back(Blobs(Vocabulary::kSuburb, seed));
    layouts.push_back(Blobs(Vocabulary::kWild, seed));
  }
  return layouts;
}

}  // namespace latticeworld::testing_layouts

#endif  // LATTICEWORLD_TESTS_TERRAIN_TEST_LAYOUTS_H_
