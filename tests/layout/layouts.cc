#include "layout/layouts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

char AnyLetter(Vocabulary vocabulary, RandomStream* random) {
  const auto& classes = ClassesOf(vocabulary);
  return classes[static_cast<std::size_t>(
                     random->UniformInt(0, static_cast<int>(classes.size()) - 1))]
      .letter;
}

CellIndex AnyCell(RandomStream* random) {
  const int row = random->UniformInt(0, kLayoutSize - 1);
  const int col = random->UniformInt(0, kLayoutSize - 1);
  return {row, col};
}

}  // namespace

SymbolicLayout Uniform(Vocabulary vocabulary, char letter) {
  return {vocabulary, Grid<char>(kLayoutSize, kLayoutSize, letter)};
}

void Fill(SymbolicLayout* layout, CellIndex first, CellIndex last, char letter) {
  for (int row = first.row; row <= last.row; ++row) {
    for (int col = first.col; col <= last.col; ++col) layout->cells(row, col) = letter;
  }
}

void Disc(SymbolicLayout* layout, CellIndex center, double radius, char letter) {
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (std::hypot(row - center.row, col - center.col) <= radius) {
        layout->cells(row, col) = letter;
      }
    }
  }
}

void Line(SymbolicLayout* layout, const std::vector<CellIndex>& points, char letter) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const CellIndex a = points[i - 1], b = points[i];
    const int steps = std::max({std::abs(b.row - a.row), std::abs(b.col - a.col), 1});
    for (int step = 0; step <= steps; ++step) {
      const double along = static_cast<double>(step) / steps;
      layout->cells(static_cast<int>(std::lround(a.row + along * (b.row - a.row))),
                    static_cast<int>(std::lround(a.col + along * (b.col - a.col)))) = letter;
    }
  }
}

SymbolicLayout Random(Vocabulary vocabulary, std::uint64_t seed) {
  RandomStream random(seed, "random layout");
  SymbolicLayout layout = Uniform(vocabulary, '?');
  for (char& cell : layout.cells) cell = AnyLetter(vocabulary, &random);
  return layout;
}

SymbolicLayout Patchy(Vocabulary vocabulary, std::uint64_t seed) {
  RandomStream random(seed, "patchy layout");
  std::vector<std::pair<CellIndex, char>> points;
  const int patches = random.UniformInt(2, 20);
  for (int i = 0; i < patches; ++i) {
    const CellIndex cell = AnyCell(&random);
    points.emplace_back(cell, AnyLetter(vocabulary, &random));
  }
  SymbolicLayout layout = Uniform(vocabulary, '?');
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      double nearest = 1e9;
      for (const auto& [point, letter] : points) {
        const double distance = std::hypot(point.row - row, point.col - col);
        if (distance >= nearest) continue;
        nearest = distance;
        layout.cells(row, col) = letter;
      }
    }
  }
  const int lines = random.UniformInt(0, 4);
  for (int i = 0; i < lines; ++i) {
    const CellIndex a = AnyCell(&random), b = AnyCell(&random), c = AnyCell(&random);
    Line(&layout, {a, b, c}, AnyLetter(vocabulary, &random));
  }
  const int strays = random.UniformInt(0, 8);
  for (int i = 0; i < strays; ++i) layout.cells[AnyCell(&random)] = AnyLetter(vocabulary, &random);
  return layout;
}

}  // namespace latticeworld
