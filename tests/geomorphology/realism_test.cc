#include "latticeworld/geomorphology/realism.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <functional>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/realism_channels.h"
#include "latticeworld/geomorphology/realism_fit.h"
#include "latticeworld/geomorphology/realism_spectrum.h"

namespace latticeworld {
namespace {

// height(x, y) at the cell centres, x and y in [-1, 1], x east and y north.
Grid<float> Surface(int rows, int cols, const std::function<double(double, double)>& height) {
  Grid<float> surface(rows, cols);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      surface(r, c) =
          static_cast<float>(height((2.0 * c + 1.0) / cols - 1.0, 1.0 - (2.0 * r + 1.0) / rows));
    }
  }
  return surface;
}

// 1 outside of the circle that touches the sides.
Grid<unsigned char> OutsideOfCircle(int side) {
  Grid<unsigned char> outside(side, side);
  const Grid<float> radius =
      Surface(side, side, [](double x, double y) { return std::hypot(x, y); });
  std::transform(radius.begin(), radius.end(), outside.begin(), [](float r) { return r > 1.0f; });
  return outside;
}

// A piece of a periodic random surface twice as wide whose power falls as wave number^slope: a
// fractional Brownian surface (Voss 1985), by shaping the spectrum of noise.
Grid<float> FractionalBrownianSurface(int side, double slope, std::uint64_t seed) {
  const int n = 2 * side;
  RandomStream random(seed, "fractional Brownian surface");
  Grid<std::complex<double>> spectrum(n, n);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const double wave_number = std::hypot(std::min(r, n - r), std::min(c, n - c));
      const double amplitude = wave_number > 0.0 ? std::pow(wave_number, 0.5 * slope) : 0.0;
      const double real = random.Normal(0.0, amplitude);
      spectrum(r, c) = {real, random.Normal(0.0, amplitude)};
    }
  }
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> in(n), out(n);
  for (int r = 0; r < n; ++r) {
    fft.inv(out.data(), spectrum.row(r), n);
    std::copy(out.begin(), out.end(), spectrum.row(r));
  }
  Grid<float> surface(side, side);
  for (int c = 0; c < side; ++c) {
    for (int r = 0; r < n; ++r) in[r] = spectrum(r, c);
    fft.inv(out.data(), in.data(), n);
    // One of two independent surfaces: real and imaginary part.
    for (int r = 0; r < side; ++r) surface(r, c) = static_cast<float>(1e4 * out[r].real());
  }
  return surface;
}

// Land that rises evenly and that rivers cut into until nothing changes any more.
Grid<float> SteadyRiverLand(int rows, int cols, double area_exponent, std::uint64_t seed) {
  RandomStream random(seed, "steady river land");
  Grid<float> height_m(rows, cols);
  for (float& height : height_m) height = static_cast<float>(random.Uniform());
  const Grid<float> uplift(rows, cols, 1e-3f);
  FluvialOptions options;
  options.steps = 150;
  options.time_step_yr = 5e4;
  options.area_exponent = area_exponent;
  options.erodibility = 1e-4 * std::pow(1e4, 0.5 - area_exponent);
  ErodeFluvially(10.0, options, nullptr, &uplift, nullptr, 1, &height_m);
  return height_m;
}

// A network that Horton's law of stream numbers describes exactly: a stream of order w begins where
// two of order w - 1 meet and takes in ratio - 2 more on its way. Each stream of order 1 is one
// cell long. Gives the lowest cell of it; receivers are by index.
std::int32_t AddStream(int order, int ratio, std::vector<std::int32_t>* receiver) {
  const auto add_cell = [receiver] {
    receiver->push_back(static_cast<std::int32_t>(receiver->size()));
    return receiver->back();
  };
  if (order == 1) return add_cell();
  std::int32_t end = -1;
  for (int k = 0; k < ratio - 1; ++k) {
    const std::int32_t cell = add_cell();
    const int joining = k == 0 ? 2 : 1;
    for (int j = 0; j < joining; ++j) {
      (*receiver)[AddStream(order - 1, ratio, receiver)] = cell;
    }
    if (end >= 0) (*receiver)[end] = cell;
    end = cell;
  }
  return end;
}

FlowGraph HortonNetwork(int order, int ratio) {
  FlowGraph flow;
  const std::int32_t outlet = AddStream(order, ratio, &flow.receiver);
  flow.rows = 1;
  flow.cols = static_cast<int>(flow.receiver.size());
  std::vector<std::vector<std::int32_t>> donors(flow.receiver.size());
  for (std::size_t i = 0; i < flow.receiver.size(); ++i) {
    if (flow.receiver[i] != static_cast<std::int32_t>(i)) donors[flow.receiver[i]].push_back(i);
  }
  flow.order = {outlet};
  for (std::size_t i = 0; i < flow.order.size(); ++i) {
    for (const std::int32_t donor : donors[flow.order[i]]) flow.order.push_back(donor);
  }
  return flow;
}

std::vector<double> AllFigures(const RealismMeasures& m) {
  std::vector<double> figures = {
      m.dry_share,      m.relief_m,       m.mean_slope_rad,  m.depression_share,
      m.spectrum_min_m, m.spectrum_max_m, m.channel_area_m2, m.hypsometric_integral};
  figures.insert(figures.end(), m.slope_quantiles_rad.begin(), m.slope_quantiles_rad.end());
  figures.insert(figures.end(), m.hypsometric_curve.begin(), m.hypsometric_curve.end());
  figures.insert(figures.end(), m.streams_of_order.begin(), m.streams_of_order.end());
  for (const RealismEstimate& estimate : {m.concavity, m.hack_exponent, m.bifurcation_ratio,
                                          m.profile_spectrum_slope, m.surface_spectrum_slope}) {
    figures.insert(figures.end(),
                   {estimate.value, estimate.standard_error, static_cast<double>(estimate.count)});
  }
  return figures;
}

TEST(RealismTest, ThePlaneHasOneSlope) {
  // Rises by 0.3 to the east and by 0.4 to the north a metre.
  const Grid<float> plane =
      Surface(80, 100, [](double x, double y) { return 0.3 * 250.0 * x + 0.4 * 200.0 * y; });
  const RealismMeasures measures = MeasureRealism(plane, 5.0);
  for (const double slope : measures.slope_quantiles_rad) EXPECT_NEAR(slope, std::atan(0.5), 1e-4);
  EXPECT_NEAR(measures.mean_slope_rad, std::atan(0.5), 1e-4);
  EXPECT_NEAR(measures.relief_m, 0.3 * 495.0 + 0.4 * 395.0, 1e-2);
  EXPECT_EQ(measures.depression_share, 0.0);
}

TEST(RealismTest, SlopesAreThoseOfTheirQuantiles) {
  // Along x the steepness itself grows evenly from 0 to 1: tan(slope) at quantile q is q.
  const Grid<float> parabola = Surface(200, 400, [](double x, double) {
    return 0.5 * 400.0 * (0.5 * (x + 1.0)) * (0.5 * (x + 1.0));
  });
  const RealismMeasures measures = MeasureRealism(parabola, 1.0);
  const std::array<double, 5> quantiles = {0.05, 0.25, 0.5, 0.75, 0.95};
  for (std::size_t q = 0; q < quantiles.size(); ++q) {
    EXPECT_NEAR(std::tan(measures.slope_quantiles_rad[q]), quantiles[q], 0.004);
  }
  EXPECT_NEAR(measures.mean_slope_rad, M_PI / 4.0 - 0.5 * std::log(2.0), 1e-3);
}

TEST(RealismTest, HypsometryOfConeDomeAndTroughIsThatOfGeometry) {
  struct Shape {
    std::function<double(double, double)> height;
    double integral;
    std::function<double(double)> share_above;  // relative height
    bool round;
  };
  const std::vector<Shape> shapes = {
      {[](double x, double y) { return 7.0 - 50.0 * std::hypot(x, y); }, 1.0 / 3.0,
       [](double h) { return (1.0 - h) * (1.0 - h); }, true},
      {[](double x, double y) { return 7.0 - 50.0 * (x * x + y * y); }, 0.5,
       [](double h) { return 1.0 - h; }, true},
      {[](double x, double) { return 50.0 * x * x; }, 1.0 / 3.0,
       [](double h) { return 1.0 - std::sqrt(h); }, false}};
  const Grid<unsigned char> outside = OutsideOfCircle(400);
  for (const Shape& shape : shapes) {
    const RealismMeasures measures =
        MeasureRealism(Surface(400, 400, shape.height), 1.0, shape.round ? &outside : nullptr);
    EXPECT_NEAR(measures.hypsometric_integral, shape.integral, 0.005);
    EXPECT_EQ(measures.hypsometric_curve[0], 1.0);
    for (int k = 1; k <= 10; ++k) {
      EXPECT_NEAR(measures.hypsometric_curve[k], shape.share_above(0.1 * k), 0.01) << k;
    }
    EXPECT_NEAR(measures.dry_share, shape.round ? M_PI / 4.0 : 1.0, 0.005);
  }
}

TEST(RealismTest, SpectraOfFractionalBrownianSurfacesHaveTheirExponent) {
  for (const double slope : {-2.6, -3.0, -3.4, -3.8, -4.2}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const RealismMeasures measures =
          MeasureRealism(FractionalBrownianSurface(250, slope, seed), 10.0);
      EXPECT_NEAR(measures.surface_spectrum_slope.value, slope, 0.15) << seed;
      EXPECT_NEAR(measures.profile_spectrum_slope.value, slope + 1.0, 0.15) << slope << " " << seed;
      EXPECT_LT(measures.surface_spectrum_slope.standard_error, 0.15);
      EXPECT_DOUBLE_EQ(measures.spectrum_min_m, 40.0);
      EXPECT_LE(measures.spectrum_max_m, 625.0);
      EXPECT_GT(measures.spectrum_max_m, 625.0 / M_SQRT2);
    }
  }
}

TEST(RealismTest, SpectraDoNotSeeATrend) {
  Grid<float> land = FractionalBrownianSurface(128, -3.4, 5);
  const RealismMeasures level = MeasureRealism(land, 1.0);
  Grid<float> warped = land;  // each profile has a trend of its own
  for (int r = 0; r < land.rows(); ++r) {
    for (int c = 0; c < land.cols(); ++c) warped(r, c) += 0.5f * (r - 64) * (c - 64);
  }
  EXPECT_NEAR(MeasureRealism(warped, 1.0).profile_spectrum_slope.value,
              level.profile_spectrum_slope.value, 1e-3);
  for (int r = 0; r < land.rows(); ++r) {
    for (int c = 0; c < land.cols(); ++c) land(r, c) += 3.0f * r - 2.0f * c + 500.0f;
  }
  const RealismMeasures tilted = MeasureRealism(land, 1.0);
  EXPECT_NEAR(tilted.surface_spectrum_slope.value, level.surface_spectrum_slope.value, 1e-3);
  EXPECT_NEAR(tilted.profile_spectrum_slope.value, level.profile_spectrum_slope.value, 1e-3);
}

TEST(RealismTest, ConcavityOfSteadyRiverLandIsTheExponentOfItsRivers) {
  for (const double exponent : {0.4, 0.5, 0.6}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const RealismMeasures measures =
          MeasureRealism(SteadyRiverLand(160, 200, exponent, seed), 10.0);
      EXPECT_NEAR(measures.concavity.value, exponent, 0.02) << seed;
      EXPECT_LT(measures.concavity.standard_error, 0.02);
      EXPECT_GT(measures.concavity.count, 100);
      // What every network of rivers has.
      EXPECT_NEAR(measures.hack_exponent.value, 0.57, 0.09);
      EXPECT_NEAR(measures.bifurcation_ratio.value, 4.4, 1.0);
      EXPECT_EQ(measures.depression_share, 0.0);
    }
  }
}

TEST(RealismTest, ConcavityHoldsOnRoughChannels) {
  // Half a metre of noise on channels that fall by metres a cell.
  Grid<float> land = SteadyRiverLand(200, 200, 0.5, 9);
  RandomStream random(9, "noise");
  for (float& height : land) height += static_cast<float>(random.Uniform(-0.5, 0.5));
  EXPECT_NEAR(MeasureRealism(land, 10.0).concavity.value, 0.5, 0.05);
}

TEST(RealismTest, BifurcationOfANetworkIsKnown) {
  for (const int ratio : {2, 3, 4, 5}) {
    const FlowGraph flow = HortonNetwork(5, ratio);
    const std::vector<unsigned char> channel(flow.receiver.size(), 1);
    const std::vector<int> streams = CountStreams(flow, StrahlerOrders(flow, channel));
    ASSERT_EQ(streams.size(), 5u);
    for (int order = 1; order <= 5; ++order) {
      EXPECT_EQ(streams[order - 1], std::lround(std::pow(ratio, 5 - order))) << order;
    }
    EXPECT_NEAR(BifurcationRatio(streams).value, ratio, 1e-12);
  }
}

TEST(RealismTest, StrahlersOrderRisesOnlyWhereTwoOfTheHighestMeet) {
  //  0  1  2  3       0 and 1 meet in 4, 2 and 3 meet in 5: order 2;
  //   4     5   6     4 and 5 meet in 7: order 3; 6 (order 1) joins 8 and leaves it at 3.
  //      7
  //      8
  FlowGraph flow;
  flow.rows = 1;
  flow.cols = 9;
  flow.receiver = {4, 4, 5, 5, 7, 7, 8, 8, 8};
  flow.order = {8, 7, 6, 5, 4, 3, 2, 1, 0};
  const std::vector<unsigned char> channel(9, 1);
  const std::vector<std::uint8_t> orders = StrahlerOrders(flow, channel);
  EXPECT_EQ(orders, (std::vector<std::uint8_t>{1, 1, 1, 1, 2, 2, 1, 3, 3}));
  EXPECT_EQ(CountStreams(flow, orders), (std::vector<int>{5, 2, 1}));
}

TEST(RealismTest, BifurcationIsWeightedByStreams) {
  // (10 / 5 * 15 + 5 / 1 * 6) / 21
  EXPECT_NEAR(BifurcationRatio({10, 5, 1}).value, 60.0 / 21.0, 1e-12);
  EXPECT_EQ(BifurcationRatio({10, 5, 1}).count, 16);
  EXPECT_TRUE(std::isnan(BifurcationRatio({}).value));
  EXPECT_TRUE(std::isnan(BifurcationRatio({50}).value)) << "one order has no next";
  EXPECT_TRUE(std::isnan(BifurcationRatio({7, 2}).value)) << "too few to tell";
}

TEST(RealismTest, WaterIsWhereRiversEndAndIsNotMeasured) {
  // A bowl: without its lake the lower part is a depression.
  const auto bowl = [](double x, double y) { return 100.0 * std::hypot(x, y); };
  const Grid<float> land = Surface(120, 120, bowl);
  Grid<float> surface = land;
  Grid<unsigned char> water(120, 120);
  for (std::size_t i = 0; i < land.size(); ++i) {
    if (land.data()[i] >= 50.0f) continue;
    surface.data()[i] = 50.0f;
    water.data()[i] = 1;
  }
  EXPECT_GT(MeasureRealism(land, 10.0).depression_share, 0.5);
  const RealismMeasures measures = MeasureRealism(surface, 10.0, &water);
  EXPECT_EQ(measures.depression_share, 0.0);
  EXPECT_NEAR(measures.dry_share, 1.0 - M_PI / 16.0, 0.01);
  EXPECT_NEAR(measures.slope_quantiles_rad[2], std::atan(100.0 / 600.0), 1e-3);
  EXPECT_NEAR(measures.relief_m, 100.0 * M_SQRT2 - 50.0, 2.0);
}

TEST(RealismTest, ChannelsThatWaterFromBeyondMayReachAreLeftOut) {
  // In a piece cut out of river land the rivers that come in drain more than the piece shows.
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Grid<float> land = SteadyRiverLand(180, 180, 0.5, seed);
    Grid<float> piece(90, 90);
    for (int r = 0; r < 90; ++r) {
      std::copy(land.row(20 + r) + 20, land.row(20 + r) + 110, piece.row(r));
    }
    const RealismMeasures measures = MeasureRealism(piece, 10.0);
    ASSERT_GT(measures.concavity.count, 20);
    worst = std::max(worst, std::abs(measures.concavity.value - 0.5));
    // Of the links of the whole network none but those of closed catchments count.
    int streams = 0;
    for (const int count : measures.streams_of_order) streams += count;
    EXPECT_LT(measures.hack_exponent.count, streams);
  }
  EXPECT_LT(worst, 0.01);
}

TEST(RealismTest, SpectraLookAtTheLandBesideTheWater) {
  Grid<unsigned char> dry(300, 200, 1);
  EXPECT_EQ(DryWindow(dry).rows, 300);
  EXPECT_EQ(DryWindow(dry).cols, 200);
  for (int r = 0; r < 300; ++r) dry(r, 50) = 0;  // a brook, half a per cent
  EXPECT_EQ(DryWindow(dry).rows, 300);
  for (int r = 0; r < 150; ++r) std::fill(dry.row(r), dry.row(r) + 200, 0);  // a sea
  const Window window = DryWindow(dry);
  EXPECT_GE(window.row, 135);
  EXPECT_GE(window.rows, 130);
  EXPECT_EQ(window.rows, window.cols);
  EXPECT_EQ(DryWindow(Grid<unsigned char>(300, 200, 0)).rows, 0);

  Grid<float> land = FractionalBrownianSurface(256, -3.4, 2);
  Grid<unsigned char> water(256, 256, 0);
  for (int r = 0; r < 256; ++r) {
    for (int c = 0; c < 90; ++c) {
      water(r, c) = 1;
      land(r, c) = 0.0f;
    }
  }
  EXPECT_NEAR(MeasureRealism(land, 1.0, &water).surface_spectrum_slope.value, -3.4, 0.2);
}

TEST(RealismTest, ExponentsDoNotDependOnUnits) {
  const Grid<float> land = FractionalBrownianSurface(150, -3.5, 4);
  Grid<float> scaled = land;
  for (float& height : scaled) height *= 4.0f;
  const RealismMeasures one = MeasureRealism(land, 2.0);
  const RealismMeasures other = MeasureRealism(scaled, 8.0);
  EXPECT_NEAR(other.concavity.value, one.concavity.value, 1e-6);
  EXPECT_NEAR(other.hack_exponent.value, one.hack_exponent.value, 1e-6);
  EXPECT_EQ(other.streams_of_order, one.streams_of_order);
  EXPECT_NEAR(other.surface_spectrum_slope.value, one.surface_spectrum_slope.value, 1e-6);
  EXPECT_NEAR(other.mean_slope_rad, one.mean_slope_rad, 1e-6);
  EXPECT_NEAR(other.hypsometric_integral, one.hypsometric_integral, 1e-6);
  EXPECT_NEAR(other.relief_m, 4.0 * one.relief_m, 1e-3);
  EXPECT_NEAR(other.channel_area_m2, 16.0 * one.channel_area_m2, 1e-6);
}

TEST(RealismTest, ALandOnItsSideMeasuresTheSame) {
  const Grid<float> land = SteadyRiverLand(130, 180, 0.5, 6);
  Grid<float> turned(land.cols(), land.rows());
  for (int r = 0; r < land.rows(); ++r) {
    for (int c = 0; c < land.cols(); ++c) turned(c, land.rows() - 1 - r) = land(r, c);
  }
  const std::vector<double> one = AllFigures(MeasureRealism(land, 3.0));
  const std::vector<double> other = AllFigures(MeasureRealism(turned, 3.0));
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_NEAR(other[i], one[i], 1e-3 * std::abs(one[i])) << i;
  }
}

TEST(RealismTest, TheNumberOfThreadsDoesNotMatter) {
  const Grid<float> land = FractionalBrownianSurface(150, -3.5, 8);
  const std::vector<double> one = AllFigures(MeasureRealism(land, 2.0, nullptr, 1));
  for (const int threads : {0, 2, 3, 7}) {
    EXPECT_EQ(AllFigures(MeasureRealism(land, 2.0, nullptr, threads)), one) << threads;
  }
}

TEST(RealismTest, WhatTheLandDoesNotAllowIsNotANumber) {
  const RealismMeasures flat = MeasureRealism(Grid<float>(100, 100, 12.0f), 1.0);
  EXPECT_EQ(flat.mean_slope_rad, 0.0);
  EXPECT_EQ(flat.relief_m, 0.0);
  EXPECT_EQ(flat.depression_share, 0.0);
  for (const double value :
       {flat.hypsometric_integral, flat.hypsometric_curve[5], flat.concavity.value,
        flat.profile_spectrum_slope.value, flat.surface_spectrum_slope.standard_error}) {
    EXPECT_TRUE(std::isnan(value)) << value;
  }
  // A plane has no spectrum but its rounding.
  const RealismMeasures plane =
      MeasureRealism(Surface(100, 100, [](double x, double) { return 1000.0 + 33.3 * x; }), 1.0);
  EXPECT_TRUE(std::isnan(plane.surface_spectrum_slope.value));

  const Grid<unsigned char> sea(100, 100, 1);
  for (const RealismMeasures& none :
       {MeasureRealism(Grid<float>(63, 300, 1.0f), 1.0), MeasureRealism(Grid<float>(), 1.0),
        MeasureRealism(Grid<float>(100, 100, 1.0f), 1.0, &sea)}) {
    EXPECT_EQ(none.dry_share, 0.0);
    EXPECT_TRUE(none.streams_of_order.empty());
    for (const double value :
         {none.relief_m, none.mean_slope_rad, none.slope_quantiles_rad[0],
          none.hypsometric_integral, none.hypsometric_curve[0], none.depression_share,
          none.concavity.value, none.hack_exponent.value, none.bifurcation_ratio.value,
          none.profile_spectrum_slope.value, none.surface_spectrum_slope.value}) {
      EXPECT_TRUE(std::isnan(value)) << value;
    }
  }
}

TEST(RealismTest, ALineIsTheMedianOfAllPairs) {
  // Slopes of the pairs: 0, 0, 1/3, 1/2, 1/2, 1.
  const RealismEstimate fit = FitSlope({0, 1, 2, 3}, {0, 0, 1, 1});
  EXPECT_NEAR(fit.value, 5.0 / 12.0, 1e-12);
  EXPECT_NEAR(fit.standard_error, 1.4826 * (5.0 / 24.0) / std::sqrt(5.0), 1e-12);
}

TEST(RealismTest, HalfOctavesBeginAtTheirLowEnd) {
  HalfOctaves bins(10.0);
  for (const double key : {9.9, 10.0, 14.1, 14.2, 20.1}) bins.Add(key, 2.0 * key, 3.0);
  ASSERT_EQ(bins.bins().size(), 3u);
  EXPECT_EQ(bins.bins()[0].count, 2);
  EXPECT_EQ(bins.bins()[1].count, 1);
  EXPECT_EQ(bins.bins()[2].count, 1);
  EXPECT_DOUBLE_EQ(bins.bins()[0].value, 48.2);
  EXPECT_DOUBLE_EQ(bins.bins()[0].weight, 6.0);
  EXPECT_DOUBLE_EQ(bins.bins()[1].log_key, 3.0 * std::log(14.2));
}

TEST(RealismTest, LinesAreFittedPastBadPoints) {
  std::vector<double> x, y;
  for (int i = 0; i < 20; ++i) {
    x.push_back(i);
    y.push_back(i % 5 == 4 ? 100.0 : 3.0 - 0.5 * i);
  }
  const RealismEstimate fit = FitSlope(x, y);
  EXPECT_NEAR(fit.value, -0.5, 0.05);
  EXPECT_LT(fit.standard_error, 0.05);
  EXPECT_TRUE(std::isnan(FitSlope({1, 2, 3}, {1, 2, 3}).value));
  EXPECT_TRUE(std::isnan(FitSlope({1, 1, 1, 1}, {1, 2, 3, 4}).value));
}

}  // namespace
}  // namespace latticeworld
