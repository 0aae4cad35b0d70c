#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_BODY_SWEEP_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_BODY_SWEEP_H_

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace latticeworld {

// Which of many bodies may touch each other: sort and sweep along x (Baraff 1992) over the balls
// around them. Hardly anything changes its place in the order from step to step, so that an
// insertion sort costs next to nothing.
//
// Body has id(), resting(), stands() (pairs of two that stand are left out), BallCenter() in the
// map and ball_radius_m().
template <typename Body>
class BodySweep {
 public:
  // body: outlives its place here.
  void Add(Body* body) { spans_.emplace_back().body = body; }
  void Remove(const Body* body) {
    spans_.erase(std::remove_if(spans_.begin(), spans_.end(),
                                [body](const Span& span) { return span.body == body; }),
                 spans_.end());
  }
  void Clear() { spans_.clear(); }
  // What rests may have been put elsewhere.
  void Unsettle() {
    for (Span& span : spans_) span.settled = false;
  }

  // Looks where the bodies are. Ties by id, so that the order never depends on what was before.
  void Sort() {
    for (Span& span : spans_) {
      if (span.settled && span.body->resting()) continue;
      span.settled = span.body->resting();
      const double x_m = span.body->BallCenter().x(), radius_m = span.body->ball_radius_m();
      span.low_m = x_m - radius_m;
      span.high_m = x_m + radius_m;
    }
    const auto before = [](const Span& a, const Span& b) {
      return a.low_m != b.low_m ? a.low_m < b.low_m : a.body->id() < b.body->id();
    };
    for (std::size_t i = 1; i < spans_.size(); ++i) {
      const Span span = spans_[i];
      std::size_t at = i;
      for (; at > 0 && before(span, spans_[at - 1]); --at) spans_[at] = spans_[at - 1];
      spans_[at] = span;
    }
  }

  // visit(Body*, Body*), once for each pair whose balls met when Sort looked.
  template <typename Visit>
  void ForEachPair(Visit&& visit) const {
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      Body* a = spans_[i].body;
      for (std::size_t j = i + 1; j < spans_.size() && spans_[j].low_m < spans_[i].high_m; ++j) {
        Body* b = spans_[j].body;
        if (a->stands() && b->stands()) continue;
        const double reach_m = a->ball_radius_m() + b->ball_radius_m();
        if ((a->BallCenter() - b->BallCenter()).squaredNorm() > reach_m * reach_m) continue;
        visit(a, b);
      }
    }
  }

 private:
  // Extent of a body along x, in the order of its low end.
  struct Span {
    double low_m = 0.0, high_m = 0.0;
    Body* body = nullptr;
    bool settled = false;  // taken where the body rests: holds until it wakes
  };
  std::vector<Span> spans_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_BODY_SWEEP_H_
