#include "latticeworld/layout/claims/course_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace latticeworld::internal {
namespace {

constexpr int kSmoothingRounds = 2;
constexpr double kSmoothing = 0.4;
constexpr int kPointsPerStep = 5;

struct Node {
  int row = 0;
  int col = 0;
  bool thick = false;
  LayoutPoint place;
  std::vector<int> neighbours;  // in the order of ForEachStep
};

// The eight steps to neighbours, sides first.
constexpr int kSteps[8][2] = {{-1, 0}, {0, -1}, {0, 1}, {1, 0}, {-1, -1}, {-1, 1}, {1, -1}, {1, 1}};

std::vector<Node> NodesOf(const Grid<unsigned char>& mask) {
  const Grid<unsigned char> thick = ThickCells(mask);
  std::vector<Node> nodes;
  Grid<int> index(mask.rows(), mask.cols(), -1);
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (mask(row, col) == 0) continue;
      index(row, col) = static_cast<int>(nodes.size());
      nodes.push_back({row, col, thick(row, col) != 0, {col + 0.5, row + 0.5}, {}});
    }
  }
  for (Node& node : nodes) {
    for (const auto& step : kSteps) {
      const int row = node.row + step[0], col = node.col + step[1];
      if (!mask.Contains({row, col}) || mask(row, col) == 0) continue;
      const bool diagonal = step[0] != 0 && step[1] != 0;
      // A diagonal step is one only where no way goes around its corner.
      if (diagonal && (mask(row, node.col) != 0 || mask(node.row, col) != 0)) continue;
      if (!diagonal && node.thick && thick(row, col) != 0) continue;
      node.neighbours.push_back(index(row, col));
    }
  }
  return nodes;
}

// Rounds the corners of lines; ends and areas stay in their place.
void SmoothPlaces(std::vector<Node>* nodes) {
  std::vector<LayoutPoint> moved(nodes->size());
  for (int round = 0; round < kSmoothingRounds; ++round) {
    for (std::size_t i = 0; i < nodes->size(); ++i) {
      const Node& node = (*nodes)[i];
      moved[i] = node.place;
      if (node.thick || node.neighbours.size() < 2) continue;
      LayoutPoint mean;
      for (const int neighbour : node.neighbours) {
        mean.u += (*nodes)[neighbour].place.u / static_cast<double>(node.neighbours.size());
        mean.v += (*nodes)[neighbour].place.v / static_cast<double>(node.neighbours.size());
      }
      moved[i].u += kSmoothing * (mean.u - node.place.u);
      moved[i].v += kSmoothing * (mean.v - node.place.v);
    }
    for (std::size_t i = 0; i < nodes->size(); ++i) (*nodes)[i].place = moved[i];
  }
}

// The direction of the line at a node on its way to a neighbour: through a node with two
// neighbours it runs on, elsewhere it starts anew.
LayoutPoint TangentAt(const std::vector<Node>& nodes, int from, int to) {
  const Node& node = nodes[from];
  const LayoutPoint& ahead = nodes[to].place;
  if (node.thick || node.neighbours.size() != 2) {
    return {ahead.u - node.place.u, ahead.v - node.place.v};
  }
  const int other = node.neighbours[0] == to ? node.neighbours[1] : node.neighbours[0];
  const LayoutPoint& behind = nodes[other].place;
  return {0.5 * (ahead.u - behind.u), 0.5 * (ahead.v - behind.v)};
}

// Cubic Hermite curve, t in [0, 1].
LayoutPoint CurveAt(const LayoutPoint& a, const LayoutPoint& tangent_a, const LayoutPoint& b,
                    const LayoutPoint& tangent_b, double t) {
  const double t2 = t * t, t3 = t2 * t;
  const double h00 = 2 * t3 - 3 * t2 + 1, h10 = t3 - 2 * t2 + t;
  const double h01 = -2 * t3 + 3 * t2, h11 = t3 - t2;
  return {h00 * a.u + h10 * tangent_a.u + h01 * b.u + h11 * tangent_b.u,
          h00 * a.v + h10 * tangent_a.v + h01 * b.v + h11 * tangent_b.v};
}

}  // namespace

Grid<unsigned char> ThickCells(const Grid<unsigned char>& mask) {
  Grid<unsigned char> thick(mask.rows(), mask.cols(), 0);
  for (int row = 0; row + 1 < mask.rows(); ++row) {
    for (int col = 0; col + 1 < mask.cols(); ++col) {
      if (mask(row, col) == 0 || mask(row, col + 1) == 0 || mask(row + 1, col) == 0 ||
          mask(row + 1, col + 1) == 0) {
        continue;
      }
      thick(row, col) = thick(row, col + 1) = thick(row + 1, col) = thick(row + 1, col + 1) = 1;
    }
  }
  return thick;
}

CourseLines::CourseLines(const Grid<unsigned char>& mask) : near_(mask.rows(), mask.cols()) {
  std::vector<Node> nodes = NodesOf(mask);
  SmoothPlaces(&nodes);
  for (int from = 0; from < static_cast<int>(nodes.size()); ++from) {
    const Node& node = nodes[from];
    // A cell alone is a line of no length.
    if (node.neighbours.empty() && !node.thick) AddSegment({node.place, node.place});
    for (const int to : node.neighbours) {
      if (to < from) continue;
      const LayoutPoint tangent_from = TangentAt(nodes, from, to);
      LayoutPoint tangent_to = TangentAt(nodes, to, from);
      tangent_to = {-tangent_to.u, -tangent_to.v};
      LayoutPoint last = node.place;
      for (int k = 1; k <= kPointsPerStep; ++k) {
        const LayoutPoint next = CurveAt(node.place, tangent_from, nodes[to].place, tangent_to,
                                         static_cast<double>(k) / kPointsPerStep);
        AddSegment({last, next});
        last = next;
      }
    }
  }
}

void CourseLines::AddSegment(const Segment& segment) {
  const auto cell = [](double low, int count) {
    return std::clamp(static_cast<int>(std::floor(low)), 0, count - 1);
  };
  const auto [u_low, u_high] = std::minmax(segment.from.u, segment.to.u);
  const auto [v_low, v_high] = std::minmax(segment.from.v, segment.to.v);
  for (int row = cell(v_low - 1.0, near_.rows()); row <= cell(v_high + 1.0, near_.rows()); ++row) {
    for (int col = cell(u_low - 1.0, near_.cols()); col <= cell(u_high + 1.0, near_.cols());
         ++col) {
      near_(row, col).push_back(segment);
    }
  }
}

CourseLines::Nearest CourseLines::NearestTo(LayoutPoint place) const {
  Nearest nearest{std::numeric_limits<double>::infinity(), place};
  const int row = std::clamp(static_cast<int>(place.v), 0, near_.rows() - 1);
  const int col = std::clamp(static_cast<int>(place.u), 0, near_.cols() - 1);
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& segment : near_(row, col)) {
    const double du = segment.to.u - segment.from.u, dv = segment.to.v - segment.from.v;
    const double length2 = du * du + dv * dv;
    const double along =
        length2 > 0.0
            ? ((place.u - segment.from.u) * du + (place.v - segment.from.v) * dv) / length2
            : 0.0;
    const double t = std::clamp(along, 0.0, 1.0);
    const LayoutPoint point{segment.from.u + t * du, segment.from.v + t * dv};
    const double distance2 =
        (place.u - point.u) * (place.u - point.u) + (place.v - point.v) * (place.v - point.v);
    if (distance2 < least) {
      least = distance2;
      nearest.point = point;
    }
  }
  if (least <= 1.0) nearest.distance = std::sqrt(least);
  return nearest;
}

}  // namespace latticeworld::internal
