#include "dataset/made_layouts.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

class Painter {
 public:
  Painter(Vocabulary vocabulary, std::uint64_t seed)
      : vocabulary_(vocabulary), noisy_(seed % 2 == 1), random_(seed, "made layout") {}

  SymbolicLayout Paint() {
    layout_.vocabulary = vocabulary_;
    layout_.cells = Grid<char>(kLayoutSize, kLayoutSize, '?');
    PaintLand();
    const int lakes = random_.UniformInt(0, 3);
    for (int i = 0; i < lakes; ++i) Blob('W', random_.Uniform(1.5, 4.5));
    if (random_.Chance(0.4)) Line('W', random_.Chance(0.3) ? 2 : 1);
    if (vocabulary_ == Vocabulary::kSuburb) {
      const int roads = random_.UniformInt(0, 3);
      for (int i = 0; i < roads; ++i) Line('R', 1);
      const int villages = random_.UniformInt(0, 3);
      for (int i = 0; i < villages; ++i) Blob('B', random_.Uniform(1.0, 3.0));
    }
    if (noisy_) Sprinkle();
    return layout_;
  }

 private:
  // Patches around random points, each nearest point's, with wavering borders.
  void PaintLand() {
    const std::string land = vocabulary_ == Vocabulary::kSuburb ? "AFGD" : "BFRS";
    struct Seed {
      double row, col;
      char letter;
    };
    std::vector<Seed> seeds(static_cast<std::size_t>(random_.UniformInt(1, 7)));
    for (Seed& seed : seeds) {
      seed = {random_.Uniform(0, 32), random_.Uniform(0, 32),
              land[static_cast<std::size_t>(random_.UniformInt(0, 3))]};
    }
    for (int row = 0; row < kLayoutSize; ++row) {
      for (int col = 0; col < kLayoutSize; ++col) {
        double best = 1e9;
        for (const Seed& seed : seeds) {
          const double away = std::hypot(row - seed.row, col - seed.col) + random_.Uniform(0, 2.5);
          if (away >= best) continue;
          best = away;
          layout_.cells(row, col) = seed.letter;
        }
      }
    }
  }

  void Blob(char letter, double radius) {
    const double row = random_.Uniform(0, 32), col = random_.Uniform(0, 32);
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        if (std::hypot(r - row, c - col) <= radius * random_.Uniform(0.9, 1.1)) {
          layout_.cells(r, c) = letter;
        }
      }
    }
  }

  // From one edge across, wandering.
  void Line(char letter, int width) {
    const bool down = random_.Chance(0.5);
    double at = random_.Uniform(3, 29);
    double drift = random_.Uniform(-0.6, 0.6);
    int before = static_cast<int>(at);
    for (int step = 0; step < kLayoutSize; ++step) {
      drift = std::clamp(drift + random_.Uniform(-0.3, 0.3), -1.0, 1.0);
      at = std::clamp(at + drift, 0.0, 31.0);
      const int here = static_cast<int>(at);
      const int low = std::min(here, before), high = std::max(here, before) + width - 1;
      for (int k = low; k <= std::min(high, kLayoutSize - 1); ++k) {
        (down ? layout_.cells(step, k) : layout_.cells(k, step)) = letter;
      }
      before = here;
    }
  }

  void Sprinkle() {
    const std::string_view letters = vocabulary_ == Vocabulary::kSuburb ? "ABDFGRW" : "BFRSW";
    const int strays = random_.UniformInt(5, 60);
    for (int i = 0; i < strays; ++i) {
      layout_.cells(random_.UniformInt(0, 31), random_.UniformInt(0, 31)) =
          letters[static_cast<std::size_t>(
              random_.UniformInt(0, static_cast<int>(letters.size()) - 1))];
    }
  }

  const Vocabulary vocabulary_;
  const bool noisy_;
  RandomStream random_;
  SymbolicLayout layout_;
};

}  // namespace

SymbolicLayout MadeLayout(Vocabulary vocabulary, std::uint64_t seed) {
  return Painter(vocabulary, seed).Paint();
}

Instance MadeInstance(Vocabulary vocabulary, std::uint64_t seed, bool relief) {
  Instance instance;
  instance.id = "made_" + std::to_string(seed);
  instance.group = instance.id;
  instance.layout = MadeLayout(vocabulary, seed);
  if (!relief) return instance;
  RandomStream random(seed, "made relief");
  const double east = random.Uniform(-1, 1), south = random.Uniform(-1, 1);
  const double hills = random.Uniform(0.0, 30.0), size = random.Uniform(4, 12);
  Grid<float> height_m(64, 64, 0.0f);
  for (int r = 0; r < 64; ++r) {
    for (int c = 0; c < 64; ++c) {
      height_m(r, c) = static_cast<float>(100.0 + east * c + south * r +
                                          hills * std::sin(r / size) * std::cos(c / size));
    }
  }
  instance.relief = std::make_shared<const Relief>(MakeRelief(std::move(height_m)));
  return instance;
}

}  // namespace latticeworld
