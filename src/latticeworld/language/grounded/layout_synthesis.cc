#include "latticeworld/language/grounded/layout_synthesis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/area_grower.h"
#include "latticeworld/language/grounded/canvas.h"
#include "latticeworld/language/grounded/course_router.h"
#include "latticeworld/language/grounded/island_painter.h"
#include "latticeworld/language/grounded/relation_painter.h"
#include "latticeworld/language/grounded/smooth_field.h"
#include "latticeworld/language/grounded/tidy.h"

namespace latticeworld {
namespace {

constexpr int kCellCount = kLayoutSize * kLayoutSize;

CellIndex CellOf(int id) { return {id / kLayoutSize, id % kLayoutSize}; }

bool IsInAny(const std::vector<UnitBox>& boxes, CellIndex cell) {
  return boxes.empty() || std::any_of(boxes.begin(), boxes.end(),
                                      [&](const UnitBox& box) { return IsIn(box, cell); });
}

class Synthesis {
 public:
  Synthesis(const LayoutPlan& plan, const Relief* relief, std::uint64_t seed)
      : plan_(plan), random_(seed, "language/layout"), canvas_(plan.claims, relief) {}

  SymbolicLayout Run() {
    DrawCourses();
    for (std::size_t i = 0; i < plan_.areas.size(); ++i) {
      if (IsCompact(plan_.areas[i]) && !plan_.areas[i].laid_by_relation)
        GrowThing(static_cast<int>(i));
    }
    GrowMasses(/*placed=*/true);
    GrowMasses(/*placed=*/false);
    const char background = Background();
    for (int id = 0; id < kCellCount; ++id) {
      if (canvas_.at(CellOf(id)) == Canvas::kFree) {
        canvas_.Paint(CellOf(id), BackgroundAt(background, CellOf(id)), -1);
      }
    }
    TidySmallPieces(KeptSmall(), &canvas_);
    for (const RelationWish& relation : plan_.relations) {
      PaintRelation(relation, &random_, &canvas_);
    }
    for (const IslandWish& island : plan_.islands) PaintIslands(island, &canvas_);
    return {plan_.vocabulary, canvas_.cells()};
  }

 private:
  // What is laid as separate pieces of known size, not as a share of its place.
  static bool IsCompact(const AreaWish& wish) {
    return wish.texture == Texture::kScattered || wish.pieces > 0 ||
           (wish.shape == WordShape::kThing && wish.amount != Amount::kMost);
  }

  void DrawCourses() {
    // Water first, so that roads cross it and not the other way about.
    int unplaced = random_.UniformInt(0, 1);
    for (const bool water : {true, false}) {
      for (CourseWish wish : plan_.courses) {
        if ((wish.letter == 'W') != water) continue;
        CompleteEnds(&wish, &unplaced);
        bool drawn = false;
        for (int attempt = 0; attempt < 4 && !drawn; ++attempt) {
          drawn = DrawCourse(wish, &random_, &canvas_);
        }
      }
    }
  }

  // Ends that the text leaves open: opposite the one that is said, else across the map, every other
  // course the other way.
  void CompleteEnds(CourseWish* wish, int* unplaced) {
    const auto opposite = [&](Region region) {
      const Heading heading = HeadingOf(region);
      if (heading.east == 0 && heading.south == 0) return RandomSide();
      return RegionOf({-heading.east, -heading.south});
    };
    if (wish->from == Region::kAnywhere && wish->to == Region::kAnywhere) {
      const bool vertical = (*unplaced)++ % 2 == 0;
      wish->from = vertical ? Region::kUpper : Region::kMiddleLeft;
      wish->to = vertical ? Region::kLower : Region::kMiddleRight;
      if (wish->through.empty() && *unplaced > 2) {
        // Further courses keep off the middle.
        wish->through.push_back(RandomSide());
      }
    } else if (wish->from == Region::kAnywhere) {
      wish->from = opposite(wish->to);
    } else if (wish->to == Region::kAnywhere) {
      wish->to = opposite(wish->from);
    }
  }

  Region RandomSide() {
    constexpr std::array<Region, 4> kSides = {Region::kUpper, Region::kMiddleLeft,
                                              Region::kMiddleRight, Region::kLower};
    return kSides[static_cast<std::size_t>(random_.UniformInt(0, 3))];
  }

  // The most open cell among random ones of the boxes, near where `target` is when it has cells.
  CellIndex ChooseSeed(const std::vector<UnitBox>& boxes, char letter, char near, bool keep_apart) {
    std::vector<CellIndex> candidates;
    for (int id = 0; id < kCellCount; ++id) {
      const CellIndex cell = CellOf(id);
      if (canvas_.at(cell) != Canvas::kFree || !IsInAny(boxes, cell) ||
          canvas_.IsForbidden(letter, cell) || (keep_apart && canvas_.HasNeighbour(cell, letter))) {
        continue;
      }
      candidates.push_back(cell);
    }
    if (candidates.empty()) return {-1, -1};
    CellIndex best = candidates.front();
    double best_score = -1e18;
    for (int trial = 0; trial < 24; ++trial) {
      const CellIndex cell =
          candidates[random_.UniformInt(0, static_cast<int>(candidates.size()) - 1)];
      const double score = Openness(cell, letter, boxes, near) + random_.Uniform();
      if (score > best_score) {
        best_score = score;
        best = cell;
      }
    }
    return best;
  }

  double Openness(CellIndex cell, char letter, const std::vector<UnitBox>& boxes, char near) const {
    double clearance = 7.0;
    double partner = 1e9;
    for (int id = 0; id < kCellCount; ++id) {
      const CellIndex other = CellOf(id);
      const char there = canvas_.at(other);
      if (there == Canvas::kFree) continue;
      const int rows = other.row - cell.row;
      const int cols = other.col - cell.col;
      const double distance = std::sqrt(static_cast<double>(rows * rows + cols * cols));
      if (there == near) {
        partner = std::min(partner, distance);
      } else if (!canvas_.locked(other)) {
        clearance = std::min(clearance, distance);
      }
    }
    double score = 0.5 * clearance - 8.0 * canvas_.Aversion(letter, cell);
    if (partner < 1e8) score -= 1.5 * std::abs(partner - 3.0);
    // Within its place rather the middle than the rim.
    if (boxes.size() == 1) {
      const UnitBox& box = boxes.front();
      const double u = (UnitOf(cell.col) - box.u_min) / (box.u_max - box.u_min) - 0.5;
      const double v = (UnitOf(cell.row) - box.v_min) / (box.v_max - box.v_min) - 0.5;
      score -= 5.0 * (u * u + v * v);
    }
    return score;
  }

  char PartnerOf(int area) const {
    for (const RelationWish& relation : plan_.relations) {
      if (relation.subject_area == area) return relation.object;
      if (relation.object_area == area) return relation.subject;
    }
    return Canvas::kFree;
  }

  struct PieceSizes {
    int pieces;
    int cells;
  };
  static PieceSizes SizesOf(const AreaWish& wish) {
    double cells = wish.shape == WordShape::kMass ? 40.0 : wish.cells;
    if (wish.amount == Amount::kLittle) cells *= 0.5;
    if (wish.amount == Amount::kMuch) cells *= 2.0;
    int pieces = wish.pieces > 0 ? wish.pieces : 1;
    if (wish.texture == Texture::kScattered) {
      if (wish.pieces == 0) {
        cells = std::min(cells, 5.0);
        double share = 0.0;
        for (const Place& place : wish.places) {
          share += (place.box.u_max - place.box.u_min) * (place.box.v_max - place.box.v_min);
        }
        if (wish.places.empty()) share = 1.0;
        const double fill = wish.amount == Amount::kLittle ? 0.05 : 0.12;
        pieces = std::clamp(static_cast<int>(fill * share * kCellCount / cells), 6, 24);
      }
    } else if (pieces > 1) {
      // Many pieces must find room.
      cells = std::clamp(cells, 3.0, std::max(3.0, 300.0 / pieces));
    }
    return {std::min(pieces, 40), std::max(3, static_cast<int>(cells))};
  }

  void GrowThing(int area) {
    const AreaWish& wish = plan_.areas[static_cast<std::size_t>(area)];
    const PieceSizes sizes = SizesOf(wish);
    const bool apart = sizes.pieces > 1;
    const char near = PartnerOf(area);
    const bool spread = sizes.pieces > 1 || wish.texture == Texture::kScattered;
    for (int piece = 0; piece < sizes.pieces; ++piece) {
      // One thing stands in the main ninth of its place; several share out over all of it.
      std::vector<std::vector<UnitBox>> targets;
      if (spread) {
        targets.push_back(PieceBoxes(wish, piece));
      } else if (wish.places.empty()) {
        targets.push_back({});
      } else {
        for (const Place& place : wish.places) targets.push_back({ThingBox(place)});
      }
      for (const std::vector<UnitBox>& boxes : targets) {
        const CellIndex seed = ChooseSeed(boxes, wish.letter, near, apart);
        if (seed.row < 0) continue;
        GrowOptions options;
        options.letter = wish.letter;
        options.boxes = boxes;
        options.roundness = 0.5;
        options.stay_inside = apart;
        options.keep_apart = apart;
        const int cells = std::max(2, static_cast<int>(sizes.cells * random_.Uniform(0.8, 1.2)));
        AreaGrower grower(options, seed, random_.NextBits(), &canvas_);
        while (grower.cells() < cells && grower.Step()) {
        }
      }
    }
  }

  // Pieces go round the places, and within a place round its ninths, the main one first.
  static std::vector<UnitBox> PieceBoxes(const AreaWish& wish, int piece) {
    if (wish.places.empty()) return {};
    const int places = static_cast<int>(wish.places.size());
    Place place = wish.places[static_cast<std::size_t>(piece % places)];
    if (place.regions.size() < 2) return {place.box};
    std::stable_partition(place.regions.begin(), place.regions.end(),
                          [&](Region region) { return region == place.main; });
    place.main = place.regions[static_cast<std::size_t>(piece / places) % place.regions.size()];
    return {ThingBox(place)};
  }

  static UnitBox ThingBox(const Place& place) {
    if (place.regions.size() == 1 || place.main == Region::kAnywhere) return place.box;
    // The part of the place that lies in its main ninth.
    const UnitBox ninth = BoxOf(place.main);
    return {std::max(ninth.u_min, place.box.u_min), std::min(ninth.u_max, place.box.u_max),
            std::max(ninth.v_min, place.box.v_min), std::min(ninth.v_max, place.box.v_max)};
  }

  // The part of a side or half that is abreast of one of its ninths.
  static UnitBox StripOf(const Place& place, Region region) {
    if (place.regions.size() < 2) return place.box;
    const UnitBox ninth = BoxOf(region);
    UnitBox strip = place.box;
    if (strip.u_max - strip.u_min > 0.9) {
      strip.u_min = ninth.u_min;
      strip.u_max = ninth.u_max;
    }
    if (strip.v_max - strip.v_min > 0.9) {
      strip.v_min = ninth.v_min;
      strip.v_max = ninth.v_max;
    }
    return strip;
  }

  struct MassInGrowth {
    AreaGrower grower;
    int target;
    bool stuck = false;  // no cell is left for it
  };

  // All masses that say where they lie (or all that do not) grow in turns, the one that lacks most
  // of its share first.
  void GrowMasses(bool placed) {
    std::vector<MassInGrowth> growing;
    for (std::size_t i = 0; i < plan_.areas.size(); ++i) {
      const AreaWish& wish = plan_.areas[i];
      if (IsCompact(wish) || wish.laid_by_relation || wish.places.empty() == placed) continue;
      if (wish.letter == plan_.background && wish.places.empty()) continue;
      const char near = PartnerOf(static_cast<int>(i));
      if (placed) {
        for (const Place& place : wish.places) {
          const double share = PlacedShare(wish, place);
          if (wish.texture == Texture::kClustered) {
            AddMass(wish, {place.box}, share, near, &growing);
            continue;
          }
          // A blob for every ninth, so that none goes bare; they grow together.
          for (const Region region : place.regions) {
            AddMass(wish, {StripOf(place, region)}, share, near, &growing);
          }
        }
      } else {
        const int blobs = wish.texture == Texture::kClustered || wish.amount == Amount::kLittle
                              ? 1
                              : random_.UniformInt(1, 2);
        const double share = wish.amount == Amount::kMost     ? 0.62
                             : wish.amount == Amount::kMuch   ? 0.26
                             : wish.amount == Amount::kLittle ? 0.04
                                                              : 0.16;
        for (int blob = 0; blob < blobs; ++blob) {
          AddMass(wish, {}, share / blobs, near, &growing);
        }
      }
    }
    while (true) {
      MassInGrowth* hungriest = nullptr;
      double least = 1.0;
      for (MassInGrowth& mass : growing) {
        const double progress = static_cast<double>(mass.grower.cells()) / mass.target;
        if (!mass.stuck && progress < least) {
          least = progress;
          hungriest = &mass;
        }
      }
      if (hungriest == nullptr) break;
      hungriest->stuck = !hungriest->grower.Step();
    }
  }

  // Share of its own place that a wish takes, given who else wants it.
  double PlacedShare(const AreaWish& wish, const Place& place) const {
    double rivals = 0.0;
    bool rival_dominates = false;
    for (const AreaWish& other : plan_.areas) {
      if (&other == &wish || other.letter == wish.letter || IsCompact(other)) continue;
      for (const Place& there : other.places) {
        const double u =
            std::min(there.box.u_max, place.box.u_max) - std::max(there.box.u_min, place.box.u_min);
        const double v =
            std::min(there.box.v_max, place.box.v_max) - std::max(there.box.v_min, place.box.v_min);
        if (u <= 0.02 || v <= 0.02) continue;
        const double area =
            (place.box.u_max - place.box.u_min) * (place.box.v_max - place.box.v_min);
        rivals += std::min(1.0, u * v / area);
        rival_dominates = rival_dominates || other.amount == Amount::kMost;
      }
    }
    if (wish.amount == Amount::kLittle) return 0.12;
    if (wish.amount == Amount::kMost) return rivals > 0 ? 0.62 : 0.9;
    if (rival_dominates) return 0.22 / std::max(1.0, rivals);
    return (wish.amount == Amount::kMuch ? 0.92 : 0.8) / (1.0 + rivals);
  }

  void AddMass(const AreaWish& wish, std::vector<UnitBox> boxes, double share, char near,
               std::vector<MassInGrowth>* growing) {
    int room = 0;
    for (int id = 0; id < kCellCount; ++id) room += IsInAny(boxes, CellOf(id)) ? 1 : 0;
    const CellIndex seed = ChooseSeed(boxes, wish.letter, near, false);
    if (seed.row < 0) return;
    GrowOptions options;
    options.letter = wish.letter;
    options.roundness = boxes.empty() ? 0.3 : 0.02;
    options.boxes = std::move(boxes);
    const int target = std::max(4, static_cast<int>(share * room * random_.Uniform(0.93, 1.05)));
    growing->push_back({AreaGrower(options, seed, random_.NextBits(), &canvas_), target});
  }

  char Background() const {
    if (plan_.background != Canvas::kFree) return plan_.background;
    return plan_.vocabulary == Vocabulary::kSuburb ? 'G' : 'B';
  }

  char BackgroundAt(char background, CellIndex cell) const {
    if (!canvas_.IsForbidden(background, cell)) return background;
    const std::string_view order = plan_.vocabulary == Vocabulary::kSuburb ? "GADFWRB" : "BRFWS";
    for (const char letter : order) {
      if (!canvas_.IsForbidden(letter, cell)) return letter;
    }
    return background;
  }

  // Letters whose small pieces are wanted.
  std::string KeptSmall() const {
    std::string kept;
    for (const AreaWish& wish : plan_.areas) {
      if (IsCompact(wish)) kept += wish.letter;
    }
    return kept;
  }

  const LayoutPlan& plan_;
  RandomStream random_;
  Canvas canvas_;
};

}  // namespace

SymbolicLayout SynthesizeLayout(const LayoutPlan& plan, const Relief* relief, std::uint64_t seed) {
  return Synthesis(plan, relief, seed).Run();
}

SymbolicLayout LayoutFromRelief(Vocabulary vocabulary, const Relief& relief, std::uint64_t seed) {
  const Grid<float> patches = SmoothField(StreamSeed(seed, "language/relief patches"), 7.0);
  const bool wild = vocabulary == Vocabulary::kWild;
  const auto [low, high] = std::minmax_element(relief.summary.begin(), relief.summary.end());
  const bool flat = *high - *low < 0.05f;
  Canvas canvas({}, nullptr);
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    const double height = relief.summary[cell] + 0.12 * (patches[cell] - 0.5);
    const bool wooded = patches[cell] > 0.56f;
    char letter = wild ? 'B' : 'G';
    if (flat) {
      letter = wooded ? 'F' : letter;
    } else if (height < 0.12) {
      letter = 'W';
    } else if (wild && height > 0.82) {
      letter = 'S';
    } else if (wild && height > 0.62) {
      letter = 'R';
    } else if (!wild && height > 0.8) {
      letter = 'D';
    } else if (!wild && height < 0.35 && patches[cell] < 0.4f) {
      letter = 'A';
    } else if (wooded) {
      letter = 'F';
    }
    canvas.Paint(cell, letter, -1);
  }
  TidySmallPieces("", &canvas);
  return {vocabulary, canvas.cells()};
}

}  // namespace latticeworld
