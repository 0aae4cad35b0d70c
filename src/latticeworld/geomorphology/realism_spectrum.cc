#include "latticeworld/geomorphology/realism_spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/geomorphology/realism_fit.h"

namespace latticeworld {
namespace {

constexpr int kMinSide = 64;
constexpr int kMaxTile = 2048;
constexpr double kMaxWetShare = 0.05;
constexpr double kMaxWaveNumber = 0.25;  // [1/cell]: wavelengths of at least four cells
constexpr int kBlock = 32;               // lines whose power is added up by one thread
// Below this share of the heights themselves the shape is lost in the rounding of floats.
constexpr double kRounding = 1e-6;

using Complex = std::complex<double>;

// Least length from n on that is a product of 4 and of powers of 2, 3 and 5, which are fast.
int FastLength(int n) {
  for (int length = (n + 3) / 4 * 4;; length += 4) {
    int rest = length;
    for (const int factor : {2, 3, 5}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return length;
  }
}

std::vector<double> HannWindow(int n) {
  std::vector<double> window(n);
  for (int i = 0; i < n; ++i) window[i] = 0.5 - 0.5 * std::cos(2.0 * M_PI * (i + 0.5) / n);
  return window;
}

double SumOfSquares(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum;
}

// Half octaves of wave number below kMaxWaveNumber, down to at least four waves a side.
class Band {
 public:
  explicit Band(int side)
      : bins_(static_cast<int>(2.0 * std::log2(kMaxWaveNumber * side / 4.0) + 1e-9)) {}

  int bins() const { return bins_; }
  double low() const { return kMaxWaveNumber * std::exp2(-0.5 * bins_); }
  // -1: outside the band.
  int BinOf(double wave_number) const {
    if (!(wave_number >= low() && wave_number < kMaxWaveNumber)) return -1;
    return std::min(static_cast<int>(2.0 * std::log2(wave_number / low())), bins_ - 1);
  }

 private:
  int bins_;
};

// What falls into the bins of a band.
struct Power {
  explicit Power(const Band& band)
      : sum(band.bins()), log_wave_number(band.bins()), count(band.bins()) {}
  void Add(int bin, double wave_number_log, double power) {
    sum[bin] += power;
    log_wave_number[bin] += wave_number_log;
    ++count[bin];
  }
  void Add(const Power& other) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += other.sum[i];
      log_wave_number[i] += other.log_wave_number[i];
      count[i] += other.count[i];
    }
  }
  std::vector<double> sum;
  std::vector<double> log_wave_number;
  std::vector<std::int64_t> count;
};

RealismEstimate FitPower(const Power& power) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < power.sum.size(); ++i) {
    if (power.count[i] == 0 || !(power.sum[i] > 0.0)) continue;
    x.push_back(power.log_wave_number[i] / power.count[i]);
    y.push_back(std::log(power.sum[i] / power.count[i]));
  }
  RealismEstimate fit = FitSlope(x, y);
  fit.count = static_cast<int>(x.size());
  return fit;
}

// Calls add(begin, end, power) for blocks of [0, count), several at once, and adds up what they
// give in order, so that the sum does not depend on the threads.
template <typename AddBlock>
void AddInBlocks(int count, int threads, const Band& band, AddBlock add, Power* power) {
  const int blocks = (count + kBlock - 1) / kBlock;
  std::vector<Power> parts(blocks, Power(band));
  ParallelFor(blocks, threads, [&](int begin, int end) {
    for (int b = begin; b < end; ++b) add(b * kBlock, std::min(count, (b + 1) * kBlock), &parts[b]);
  });
  for (const Power& part : parts) power->Add(part);
}

// A line less its trend.
void Detrend(std::vector<double>* line) {
  const auto n = static_cast<double>(line->size());
  const double middle = 0.5 * (n - 1.0);
  double mean = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < line->size(); ++i) {
    mean += (*line)[i];
    moment += (i - middle) * (*line)[i];
  }
  mean /= n;
  const double trend = moment / (n * (n * n - 1.0) / 12.0);
  for (std::size_t i = 0; i < line->size(); ++i) (*line)[i] -= mean + trend * (i - middle);
}

// Adds the power of every row of the tile.
void AddProfiles(const Grid<float>& tile, const Band& band, int threads, Power* power) {
  const int n = tile.cols();
  const int length = FastLength(n);
  const std::vector<double> window = HannWindow(n);
  const double scale = 1.0 / SumOfSquares(window);
  const auto add = [&](int begin, int end, Power* part) {
    Eigen::FFT<double> fft;
    fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<double> padded(length);
    std::vector<Complex> spectrum(length / 2 + 1);
    for (int r = begin; r < end; ++r) {
      std::vector<double> line(tile.row(r), tile.row(r) + n);
      Detrend(&line);
      for (int i = 0; i < n; ++i) padded[i] = line[i] * window[i];
      fft.fwd(spectrum.data(), padded.data(), length);
      for (int j = 1; j < length / 2; ++j) {
        const double wave_number = static_cast<double>(j) / length;
        const int bin = band.BinOf(wave_number);
        if (bin >= 0) part->Add(bin, std::log(wave_number), scale * std::norm(spectrum[j]));
      }
    }
  };
  AddInBlocks(tile.rows(), threads, band, add, power);
}

// The least-squares plane a + b * (row - middle) + c * (col - middle): those terms are orthogonal
// on a full rectangle.
struct Plane {
  double mean = 0.0;
  double per_row = 0.0;
  double per_col = 0.0;
};

Plane FitPlane(const Grid<float>& tile) {
  const double rows = tile.rows();
  const double cols = tile.cols();
  Plane plane;
  for (int r = 0; r < tile.rows(); ++r) {
    for (int c = 0; c < tile.cols(); ++c) {
      plane.mean += tile(r, c);
      plane.per_row += (r - 0.5 * (rows - 1.0)) * tile(r, c);
      plane.per_col += (c - 0.5 * (cols - 1.0)) * tile(r, c);
    }
  }
  plane.mean /= rows * cols;
  plane.per_row /= rows * cols * (rows * rows - 1.0) / 12.0;
  plane.per_col /= rows * cols * (cols * cols - 1.0) / 12.0;
  return plane;
}

// The tile less its plane; empty when nothing but rounding is left.
Grid<float> WithoutPlane(const Grid<float>& tile) {
  const Plane plane = FitPlane(tile);
  Grid<float> rest(tile.rows(), tile.cols());
  double squares = 0.0;
  double largest = 0.0;
  for (int r = 0; r < tile.rows(); ++r) {
    for (int c = 0; c < tile.cols(); ++c) {
      const double value = tile(r, c) - plane.mean - plane.per_row * (r - 0.5 * (tile.rows() - 1)) -
                           plane.per_col * (c - 0.5 * (tile.cols() - 1));
      rest(r, c) = static_cast<float>(value);
      squares += value * value;
      largest = std::max(largest, std::abs(static_cast<double>(tile(r, c))));
    }
  }
  if (!(std::sqrt(squares / rest.size()) > kRounding * largest)) return {};
  return rest;
}

// Adds the power of the tile's surface.
void AddSurface(const Grid<float>& tile, const Band& band, int threads, Power* power) {
  const int rows = FastLength(tile.rows());
  const int cols = FastLength(tile.cols());
  const int half = cols / 2 + 1;
  const std::vector<double> window_of_row = HannWindow(tile.rows());
  const std::vector<double> window_of_col = HannWindow(tile.cols());
  const double scale = 1.0 / (SumOfSquares(window_of_row) * SumOfSquares(window_of_col));
  std::vector<Complex> spectrum(static_cast<std::size_t>(rows) * half);
  ParallelFor(tile.rows(), threads, [&](int begin, int end) {
    Eigen::FFT<double> fft;
    fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<double> padded(cols);
    for (int r = begin; r < end; ++r) {
      for (int c = 0; c < tile.cols(); ++c) {
        padded[c] = tile(r, c) * window_of_row[r] * window_of_col[c];
      }
      fft.fwd(&spectrum[static_cast<std::size_t>(r) * half], padded.data(), cols);
    }
  });
  const auto add = [&](int begin, int end, Power* part) {
    Eigen::FFT<double> fft;
    std::vector<Complex> column(rows), transformed(rows);
    for (int c = begin; c < end; ++c) {
      for (int r = 0; r < rows; ++r) column[r] = spectrum[static_cast<std::size_t>(r) * half + c];
      fft.fwd(transformed.data(), column.data(), rows);
      const double per_col = static_cast<double>(c) / cols;
      // Half of the plane holds all: the other half is its mirror image, column 0 its own.
      const int end_row = c == 0 ? rows / 2 + 1 : rows;
      for (int r = 0; r < end_row; ++r) {
        const double per_row = static_cast<double>(r <= rows / 2 ? r : r - rows) / rows;
        const double wave_number = std::hypot(per_row, per_col);
        const int bin = band.BinOf(wave_number);
        if (bin >= 0) part->Add(bin, std::log(wave_number), scale * std::norm(transformed[r]));
      }
    }
  };
  AddInBlocks(half, threads, band, add, power);
}

Grid<float> Transposed(const Grid<float>& values) {
  Grid<float> transposed(values.cols(), values.rows());
  for (int r = 0; r < values.rows(); ++r) {
    for (int c = 0; c < values.cols(); ++c) transposed(c, r) = values(r, c);
  }
  return transposed;
}

Grid<float> Cut(const Grid<float>& values, const Window& window) {
  Grid<float> part(window.rows, window.cols);
  for (int r = 0; r < window.rows; ++r) {
    const float* begin = values.row(window.row + r) + window.col;
    std::copy(begin, begin + window.cols, part.row(r));
  }
  return part;
}

}  // namespace

Window DryWindow(const Grid<unsigned char>& dry) {
  // wet_before(r, c): cells that are not dry above row r and left of column c.
  Grid<std::int32_t> wet_before(dry.rows() + 1, dry.cols() + 1);
  for (int r = 0; r < dry.rows(); ++r) {
    for (int c = 0; c < dry.cols(); ++c) {
      wet_before(r + 1, c + 1) =
          wet_before(r, c + 1) + wet_before(r + 1, c) - wet_before(r, c) + (dry(r, c) == 0 ? 1 : 0);
    }
  }
  const auto is_dry = [&wet_before](const Window& w) {
    const int wet = wet_before(w.row + w.rows, w.col + w.cols) - wet_before(w.row, w.col + w.cols) -
                    wet_before(w.row + w.rows, w.col) + wet_before(w.row, w.col);
    return wet <= kMaxWetShare * w.rows * w.cols;
  };
  const Window whole{0, 0, dry.rows(), dry.cols()};
  if (is_dry(whole)) return whole;
  for (int side = std::min(dry.rows(), dry.cols()); side >= kMinSide; side -= (side + 9) / 10) {
    const int step = std::max(side / 16, 1);
    for (int row = 0; row + side <= dry.rows(); row += step) {
      for (int col = 0; col + side <= dry.cols(); col += step) {
        const Window square{row, col, side, side};
        if (is_dry(square)) return square;
      }
    }
  }
  return {};
}

void MeasureSpectra(const Grid<float>& height_m, double resolution_m, const Window& window,
                    int threads, RealismMeasures* measures) {
  if (window.rows < kMinSide || window.cols < kMinSide) return;
  const int down = (window.rows + kMaxTile - 1) / kMaxTile;
  const int across = (window.cols + kMaxTile - 1) / kMaxTile;
  const int rows = window.rows / down;
  const int cols = window.cols / across;
  const Band band(std::min(rows, cols));
  Power profiles(band);
  Power surface(band);
  for (int i = 0; i < down * across; ++i) {
    const Window place{window.row + i / across * rows, window.col + i % across * cols, rows, cols};
    const Grid<float> tile = WithoutPlane(Cut(height_m, place));
    if (tile.empty()) continue;
    AddProfiles(tile, band, threads, &profiles);
    AddProfiles(Transposed(tile), band, threads, &profiles);
    AddSurface(tile, band, threads, &surface);
  }
  measures->profile_spectrum_slope = FitPower(profiles);
  measures->surface_spectrum_slope = FitPower(surface);
  measures->spectrum_min_m = resolution_m / kMaxWaveNumber;
  measures->spectrum_max_m = resolution_m / band.low();
}

}  // namespace latticeworld
