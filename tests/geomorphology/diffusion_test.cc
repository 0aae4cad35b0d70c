#include "latticeworld/geomorphology/diffusion.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

constexpr float kNail = 1e5f;

Grid<float> Solve(const Grid<float>& stiffness, const Grid<float>& target, int cycles = 6,
                  int threads = 1) {
  MembraneOptions options;
  options.cycles = cycles;
  options.threads = threads;
  return SolveMembrane(stiffness, target, options, Progress()).value();
}

// The same equations, solved densely in double precision.
Grid<float> SolveDensely(const Grid<float>& stiffness, const Grid<float>& target) {
  const int rows = stiffness.rows();
  const int cols = stiffness.cols();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows * cols, rows * cols);
  Eigen::VectorXd b(rows * cols);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const int i = r * cols + c;
      a(i, i) += stiffness(r, c);
      b(i) = static_cast<double>(stiffness(r, c)) * target(r, c);
      for (const CellIndex n : {CellIndex{r - 1, c}, {r + 1, c}, {r, c - 1}, {r, c + 1}}) {
        if (!stiffness.Contains(n)) continue;
        a(i, i) += 1.0;
        a(i, n.row * cols + n.col) -= 1.0;
      }
    }
  }
  const Eigen::VectorXd h = a.ldlt().solve(b);
  Grid<float> height(rows, cols);
  for (int i = 0; i < rows * cols; ++i) height(i / cols, i % cols) = static_cast<float>(h(i));
  return height;
}

float LargestDifference(const Grid<float>& a, const Grid<float>& b) {
  float largest = 0.0f;
  for (int r = 0; r < a.rows(); ++r) {
    for (int c = 0; c < a.cols(); ++c) {
      largest = std::max(largest, std::abs(a(r, c) - b(r, c)));
    }
  }
  return largest;
}

// Weak springs everywhere, and strong ones along random walks: what a sketch looks like.
struct Springs {
  Grid<float> stiffness;
  Grid<float> target;
};
Springs RandomSprings(int rows, int cols, float weak, std::uint64_t seed) {
  RandomStream random(seed, "springs");
  Springs springs{Grid<float>(rows, cols, weak), Grid<float>(rows, cols, 0.4f)};
  for (int walk = 0; walk < 6; ++walk) {
    int r = random.UniformInt(0, rows - 1);
    int c = random.UniformInt(0, cols - 1);
    const auto target = static_cast<float>(random.Uniform());
    const float stiffness = random.Chance(0.5) ? 0.2f : kNail;
    for (int step = 0; step < rows; ++step) {
      springs.stiffness(r, c) = stiffness;
      springs.target(r, c) = target;
      r = std::clamp(r + random.UniformInt(-1, 1), 0, rows - 1);
      c = std::clamp(c + random.UniformInt(-1, 1), 0, cols - 1);
    }
  }
  return springs;
}

TEST(DiffusionTest, SolvesTheEquationsOfEverySizeAndKindOfSpring) {
  for (const auto& [rows, cols] : {std::pair{1, 1}, {1, 17}, {17, 1}, {5, 4}, {16, 16}, {23, 31}}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Springs springs = RandomSprings(rows, cols, seed == 0 ? 0.0f : 1e-3f, seed);
      const Grid<float> expected = SolveDensely(springs.stiffness, springs.target);
      const Grid<float> height = Solve(springs.stiffness, springs.target, 30);
      EXPECT_LT(LargestDifference(height, expected), 3e-4f) << rows << " x " << cols << " " << seed;
    }
  }
}

TEST(DiffusionTest, ConvergesAtAnySize) {
  for (const int side : {100, 257, 512}) {
    const Springs springs = RandomSprings(side, side, 1e-4f, 3);
    const Grid<float> exact = Solve(springs.stiffness, springs.target, 40);
    float before = LargestDifference(Solve(springs.stiffness, springs.target, 0), exact);
    EXPECT_LT(before, 0.1f) << side;
    for (int cycles = 1; cycles <= 6; ++cycles) {
      const float error =
          LargestDifference(Solve(springs.stiffness, springs.target, cycles), exact);
      EXPECT_LT(error, 0.7f * before) << side << ", cycle " << cycles;
      before = error;
    }
    EXPECT_LT(before, 1.5e-3f) << side;
  }
}

TEST(DiffusionTest, InterpolatesAPlaneFromItsBorder) {
  // Nailed along the border, free inside: the plane is harmonic.
  Grid<float> stiffness(70, 90, 0.0f);
  Grid<float> plane(70, 90);
  for (int r = 0; r < 70; ++r) {
    for (int c = 0; c < 90; ++c) {
      plane(r, c) = 0.01f * static_cast<float>(c) - 0.02f * static_cast<float>(r);
      if (r == 0 || c == 0 || r == 69 || c == 89) stiffness(r, c) = kNail;
    }
  }
  Grid<float> target = plane;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (stiffness.data()[i] == 0.0f) target.data()[i] = 99.0f;  // says nothing there
  }
  EXPECT_LT(LargestDifference(Solve(stiffness, target, 10), plane), 1e-3f);
}

TEST(DiffusionTest, IsTheSameWithAnyNumberOfThreads) {
  const Springs springs = RandomSprings(301, 290, 1e-4f, 5);
  const Grid<float> one = Solve(springs.stiffness, springs.target, 3, 1);
  for (const int threads : {2, 3, 7}) {
    EXPECT_TRUE(one == Solve(springs.stiffness, springs.target, 3, threads)) << threads;
  }
}

TEST(DiffusionTest, HearsACancel) {
  const Springs springs = RandomSprings(64, 64, 1e-4f, 6);
  Progress progress;
  progress.Cancel();
  const Result<Grid<float>> height =
      SolveMembrane(springs.stiffness, springs.target, MembraneOptions(), progress);
  ASSERT_FALSE(height.ok());
  EXPECT_EQ(height.status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
