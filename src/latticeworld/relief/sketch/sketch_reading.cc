#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/relief/height_map/colour_picture.h"
#include "latticeworld/relief/sketch/sketch.h"
#include "latticeworld/relief/sketch/sketch_ink.h"
#include "latticeworld/relief/sketch/sketch_paper.h"

namespace latticeworld {
namespace {

using internal::Ink;

constexpr char kLegal[] =
    "; legal are blue strokes (valleys) and black strokes (ridges) on white paper";

// Strokes with fewer pixels than kSpeck, or than a 100th of the longer side, are dirt.
constexpr int kSpeck = 5;
constexpr double kMostStrokes = 0.6;  // of the picture
constexpr double kMostTint = 0.25;    // of the picture
constexpr double kMostOthers = 0.25;  // of the ink
// Ink is blue from this colourfulness on, in 63rds; the emptiest place in this range is taken.
constexpr int kLeastBlue = 7;
constexpr int kMostBlue = 19;
constexpr int kUsualBlue = 11;

using Histogram = std::array<std::size_t, 256>;

std::string Percent(double share) {
  const double percent = 100.0 * share;
  if (percent > 0.0 && percent < 0.1) return "under 0.1 %";
  std::string text = std::to_string(static_cast<int>(percent * 10.0 + 0.5) / 10);
  return text + " %";
}

// Removes strokes of a few pixels.
void RemoveSpecks(Grid<Ink>* ink) {
  const int rows = ink->rows();
  const int cols = ink->cols();
  const std::size_t least = static_cast<std::size_t>(std::max(kSpeck, std::max(rows, cols) / 100));
  const auto is_ink = [](Ink i) { return i < internal::kTint; };
  Grid<unsigned char> seen(rows, cols, 0);
  std::vector<CellIndex> part;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      if (seen(r, c) != 0 || !is_ink((*ink)(r, c))) continue;
      part.assign(1, {r, c});
      seen(r, c) = 1;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const CellIndex cell = part[i];
        for (int y = std::max(0, cell.row - 1); y <= std::min(rows - 1, cell.row + 1); ++y) {
          for (int x = std::max(0, cell.col - 1); x <= std::min(cols - 1, cell.col + 1); ++x) {
            if (seen(y, x) != 0 || !is_ink((*ink)(y, x))) continue;
            seen(y, x) = 1;
            part.push_back({y, x});
          }
        }
      }
      if (part.size() >= least) continue;
      for (const CellIndex cell : part) (*ink)[cell] = internal::kNoInk;
    }
  }
}

// Returns where neutral ink ends and blue begins: inks of one sketch lie in heaps, and the place
// between them differs with lamp and camera.
Ink BlueFrom(const Histogram& count) {
  const auto weight = [&count](int i) {
    std::size_t sum = 0;
    for (int k = i - 2; k <= i + 2; ++k) sum += count[std::max(0, k)] * (3 - std::abs(k - i));
    return sum;
  };
  int best = kUsualBlue;
  for (int i = kLeastBlue; i <= kMostBlue; ++i) {
    const std::size_t here = weight(i);
    const std::size_t there = weight(best);
    if (here < there || (here == there && std::abs(i - kUsualBlue) < std::abs(best - kUsualBlue))) {
      best = i;
    }
  }
  return static_cast<Ink>(best);
}

// OK when the ink can be a sketch.
Status CheckInk(const Histogram& count, std::size_t pixels) {
  const auto share = [pixels](std::size_t n) {
    return static_cast<double>(n) / static_cast<double>(pixels);
  };
  std::size_t strokes = 0;
  for (int i = 0; i <= internal::kFullBlue; ++i) strokes += count[i];
  static constexpr const char* kNames[] = {"red", "orange or brown", "yellow", "green", "violet"};
  std::size_t others = 0;
  int most = internal::kRed;
  for (int i = internal::kRed; i <= internal::kViolet; ++i) {
    others += count[i];
    if (count[i] > count[most]) most = i;
  }
  const std::size_t ink = strokes + others;
  if (ink > kMostStrokes * pixels) {
    return InvalidArgument("the sketch is nearly all strokes: " + Percent(share(ink)) +
                           " of it is ink, at most " + Percent(kMostStrokes) + " may be" + kLegal);
  }
  if (count[internal::kTint] > kMostTint * pixels) {
    return InvalidArgument("this is no sketch: " + Percent(share(count[internal::kTint])) +
                           " of the picture is shaded, neither white paper nor a stroke" + kLegal);
  }
  if (others > kMostOthers * ink) {
    return InvalidArgument("the sketch has strokes of other colours: " +
                           Percent(static_cast<double>(others) / static_cast<double>(ink)) +
                           " of the ink, most of it " + kNames[most - internal::kRed] + kLegal);
  }
  if (strokes == 0) {
    return InvalidArgument(std::string("the sketch has no strokes: the picture is blank") + kLegal);
  }
  return Status();
}

}  // namespace

Result<Sketch> ReadSketch(std::string_view bytes, int threads) {
  LW_ASSIGN_OR_RETURN(const Grid<internal::Rgb> picture,
                      internal::ReadColourPicture(bytes, "sketch"));
  LW_ASSIGN_OR_RETURN(const internal::Paper paper, internal::Paper::Estimate(picture, threads));
  Grid<Ink> ink = internal::FindInk(picture, paper, threads);
  RemoveSpecks(&ink);
  Histogram count{};
  for (const Ink i : ink) ++count[i];
  LW_RETURN_IF_ERROR(CheckInk(count, ink.size()));
  const Ink blue_from = BlueFrom(count);
  Sketch sketch(ink.rows(), ink.cols());
  std::transform(ink.begin(), ink.end(), sketch.begin(), [blue_from](Ink i) {
    if (i > internal::kFullBlue) return Stroke::kNone;
    return i >= blue_from ? Stroke::kValley : Stroke::kRidge;
  });
  return sketch;
}

}  // namespace latticeworld
