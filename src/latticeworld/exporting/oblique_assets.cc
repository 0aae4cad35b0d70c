#include "latticeworld/exporting/oblique_assets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/exporting/asset_looks.h"
#include "latticeworld/exporting/oblique_ground.h"
#include "latticeworld/exporting/picture_style.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr float kWallShare = 0.62f;  // of a gabled building's height below its eaves

class AssetPainter {
 public:
  AssetPainter(const Scene& scene, const ShadedGround& ground, const PictureLight& light,
               const ObliqueCamera& camera, Canvas* canvas)
      : scene_(scene),
        ground_(ground),
        light_(light),
        camera_(camera),
        axes_(camera.axes()),
        haze_(scene),
        canvas_(canvas) {}

  void Paint(std::size_t index) {
    const Asset& asset = scene_.assets[index];
    switch (asset.kind) {
      case AssetKind::kTree:
        PaintTree(asset, LookOfPlant(scene_, index));
        break;
      case AssetKind::kBush:
        PaintBush(asset, LookOfPlant(scene_, index));
        break;
      case AssetKind::kStone:
        PaintStone(asset, StoneColor(scene_, index));
        break;
      case AssetKind::kBuilding:
        PaintBuilding(index);
        break;
      case AssetKind::kDeadBranch:
      case AssetKind::kGrassTuft:
      case AssetKind::kFlower:
      case AssetKind::kCrop:
        PaintLow(index);
        break;
    }
  }

 private:
  float DrawnHeight(float z_m) const { return (z_m - ground_.base_m) * ground_.exaggeration; }

  Ball BallOf(const Asset& asset, const Color& color, float bottom_share) const {
    const float distance_m = camera_.DistanceOf(asset.y_m);
    const float scale = camera_.PixelsPerMetre(distance_m);
    Ball ball;
    ball.center =
        camera_.Project(asset.x_m, distance_m,
                        DrawnHeight(asset.z_m) + 0.5f * (1.0f + bottom_share) * asset.height_m);
    ball.radius = {std::max(0.8f, asset.half_length_m * scale),
                   std::max(0.8f, 0.5f * (1.0f - bottom_share) * asset.height_m * scale)};
    ball.distance = distance_m - asset.half_length_m;
    ball.color = color;
    ball.haze = haze_.At(asset.y_m);
    return ball;
  }

  void PaintTree(const Asset& asset, const PlantLook& look) {
    const float distance_m = camera_.DistanceOf(asset.y_m);
    const float z_m = DrawnHeight(asset.z_m);
    const float half_m = std::max(asset.trunk_radius_m, 0.14f);
    Ball crown = BallOf(asset, look.leaf, look.conifer ? 0.12f : 0.28f);
    crown.roughness = 0.45f;
    crown.foliage = look.foliage;
    crown.snow = look.snow;
    // A cone of the crown's own radius reads as a needle beside round crowns.
    if (look.conifer) crown.radius.x() *= 1.3f;
    const Color bark =
        Mix(Times(look.bark, Shade(light_, axes_.viewer, 0.5f)), light_.fog, crown.haze);
    const float trunk_top_m = z_m + (look.foliage < 1.0f ? 0.75f : 0.4f) * asset.height_m;
    FillPolygon({camera_.Project(asset.x_m - half_m, distance_m, z_m),
                 camera_.Project(asset.x_m - 0.5f * half_m, distance_m, trunk_top_m),
                 camera_.Project(asset.x_m + 0.5f * half_m, distance_m, trunk_top_m),
                 camera_.Project(asset.x_m + half_m, distance_m, z_m)},
                bark, crown.distance, canvas_);
    if (look.conifer) {
      PaintConifer({crown.center.x(), crown.center.y() - crown.radius.y()}, 2.0f * crown.radius.y(),
                   crown, axes_, light_, canvas_);
    } else {
      PaintBall(crown, axes_, light_, canvas_);
    }
  }

  void PaintBush(const Asset& asset, const PlantLook& look) {
    Ball ball = BallOf(asset, look.leaf, -0.3f);
    ball.roughness = 0.4f;
    ball.foliage = std::max(0.75f, look.foliage);
    ball.snow = look.snow;
    PaintBall(ball, axes_, light_, canvas_);
  }

  void PaintStone(const Asset& asset, const Color& color) {
    Ball ball = BallOf(asset, color, -0.6f);
    ball.roughness = 0.2f;
    PaintBall(ball, axes_, light_, canvas_);
  }

  // Flowers, crops, tufts and branches: specks of their colour.
  void PaintLow(std::size_t index) {
    const Asset& asset = scene_.assets[index];
    const double draw = HashToUnit(51, static_cast<std::int64_t>(index), 0);
    Color color = FromRgb(122, 142, 74);
    if (asset.kind == AssetKind::kFlower)
      color = draw < 0.4   ? FromRgb(240, 214, 92)
              : draw < 0.7 ? FromRgb(214, 96, 130)
                           : FromRgb(236, 232, 240);
    if (asset.kind == AssetKind::kCrop)
      color = Mix(FromRgb(186, 166, 84), FromRgb(120, 142, 64), static_cast<float>(draw));
    if (asset.kind == AssetKind::kDeadBranch) color = FromRgb(106, 86, 66);
    color = InStyle(scene_.environment.coarse.artistic_style, color);
    // Too small for shading: specks of less than a pixel would only darken the ground.
    if (asset.half_length_m * camera_.PixelsPerMetre(camera_.DistanceOf(asset.y_m)) < 0.8f) return;
    Ball speck = BallOf(asset, color, 0.0f);
    speck.color = Times(color, Shade(light_, Eigen::Vector3f::UnitZ(), 1.0f));
    speck.color = Mix(speck.color, light_.fog, speck.haze);
    const Eigen::Vector2f& c = speck.center;
    const Eigen::Vector2f& r = speck.radius;
    FillPolygon({{c.x() - r.x(), c.y()},
                 {c.x(), c.y() - r.y()},
                 {c.x() + r.x(), c.y()},
                 {c.x(), c.y() + r.y()}},
                speck.color, speck.distance, canvas_);
  }

  void PaintBuilding(std::size_t index) {
    const Asset& asset = scene_.assets[index];
    const BuildingLook look = LookOfBuilding(scene_, index);
    Building building;
    building.asset = &asset;
    building.base_m = DrawnHeight(asset.z_m);
    building.eaves_m = building.base_m + asset.height_m * (look.gabled ? kWallShare : 1.0f);
    building.distance_m =
        camera_.DistanceOf(asset.y_m) - std::hypot(asset.half_length_m, asset.half_width_m);
    building.haze = haze_.At(asset.y_m);

    const Eigen::Vector3f along(std::cos(asset.yaw_rad), std::sin(asset.yaw_rad), 0.0f);
    const Eigen::Vector3f across(-along.y(), along.x(), 0.0f);
    const Color roof = Mix(look.roof, FromRgb(240, 244, 250), 0.85f * look.snow);
    // Walls that face the viewer, then the roof's sides.
    for (const float side : {-1.0f, 1.0f}) {
      PaintWall(building, side * across, side * asset.half_width_m, along, asset.half_length_m,
                0.0f, look.wall);
      PaintWall(building, side * along, side * asset.half_length_m, across, asset.half_width_m,
                look.gabled ? (1.0f - kWallShare) * asset.height_m : 0.0f, look.wall);
    }
    const float ridge_m = building.base_m + asset.height_m;
    const float l = asset.half_length_m * 1.05f, w = asset.half_width_m * 1.12f;
    if (!look.gabled) {
      PaintFace(building,
                {PointOf(asset, along * l + across * w, ridge_m),
                 PointOf(asset, along * l - across * w, ridge_m),
                 PointOf(asset, -along * l - across * w, ridge_m),
                 PointOf(asset, -along * l + across * w, ridge_m)},
                Eigen::Vector3f::UnitZ(), roof);
      return;
    }
    const float rise_m = ridge_m - building.eaves_m;
    // The side behind the ridge first.
    const float back = across.y() > 0.0f ? 1.0f : -1.0f;
    for (const float side : {back, -back}) {
      const Eigen::Vector3f normal =
          (side * across * rise_m + Eigen::Vector3f(0.0f, 0.0f, asset.half_width_m)).normalized();
      const float eaves_m = building.eaves_m - 0.12f * rise_m;
      PaintFace(building,
                {PointOf(asset, along * l + across * (side * w), eaves_m),
                 PointOf(asset, along * l, ridge_m), PointOf(asset, -along * l, ridge_m),
                 PointOf(asset, -along * l + across * (side * w), eaves_m)},
                normal, roof);
    }
  }

  struct Building {
    const Asset* asset;
    float base_m;  // drawn heights
    float eaves_m;
    float distance_m;
    float haze;
  };

  static Eigen::Vector3f PointOf(const Asset& asset, const Eigen::Vector3f& offset, float z_m) {
    return {asset.x_m + offset.x(), asset.y_m + offset.y(), z_m};
  }

  bool FacesViewer(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const {
    // The eye lies at x = 0, behind by the point's distance.
    const Eigen::Vector3f to_eye(-point.x(), -camera_.DistanceOf(point.y()),
                                 camera_.eye_z_m() - point.z());
    return normal.dot(to_eye) > 0.0f;
  }

  void PaintFace(const Building& building, const std::vector<Eigen::Vector3f>& corners,
                 const Eigen::Vector3f& normal, const Color& color) {
    if (!FacesViewer(corners[0], normal)) return;
    std::vector<Eigen::Vector2f> outline;
    for (const Eigen::Vector3f& corner : corners)
      outline.push_back(camera_.Project(corner.x(), camera_.DistanceOf(corner.y()), corner.z()));
    FillPolygon(outline, Mix(Times(color, Shade(light_, normal, 1.0f)), light_.fog, building.haze),
                building.distance_m, canvas_);
  }

  // An upright wall, `out` from the middle along its normal and `half` wide to both sides; gable_m
  // above the eaves in its middle.
  void PaintWall(const Building& building, const Eigen::Vector3f& normal, float out,
                 const Eigen::Vector3f& sideways, float half, float gable_m, const Color& color) {
    const Asset& asset = *building.asset;
    const Eigen::Vector3f middle = normal * std::abs(out);
    // Walls go on below the ground, for slopes.
    const float foot_m = building.base_m - 1.0f;
    std::vector<Eigen::Vector3f> corners = {
        PointOf(asset, middle - sideways * half, foot_m),
        PointOf(asset, middle - sideways * half, building.eaves_m),
        PointOf(asset, middle, building.eaves_m + gable_m),
        PointOf(asset, middle + sideways * half, building.eaves_m),
        PointOf(asset, middle + sideways * half, foot_m)};
    if (!FacesViewer(corners[0], normal)) return;
    PaintFace(building, corners, normal, color);

    // Windows in storeys of three metres, lit at night.
    const int storeys = std::max(1, static_cast<int>((building.eaves_m - building.base_m) / 3.0f));
    const int windows = std::max(1, static_cast<int>(2.0f * half / 3.2f));
    const ArtisticStyle style = scene_.environment.coarse.artistic_style;
    const bool neon = style == ArtisticStyle::kCyberpunk;
    for (int storey = 0; storey < storeys; ++storey) {
      for (int window = 0; window < windows; ++window) {
        const float s = (2.0f * (window + 0.5f) / windows - 1.0f) * half;
        const float low_m = building.base_m + 3.0f * storey + 0.9f;
        const float high_m = std::min(low_m + 1.4f, building.eaves_m - 0.3f);
        if (high_m <= low_m) continue;
        const bool lit =
            (light_.is_night || neon) && HashToUnit(52, static_cast<int>(s * 10.0f + asset.x_m),
                                                    storey * 7 + static_cast<int>(asset.y_m)) < 0.6;
        std::vector<Eigen::Vector2f> outline;
        for (const auto& [along_m, z_m] : {std::pair<float, float>{-0.5f, low_m},
                                           {-0.5f, high_m},
                                           {0.5f, high_m},
                                           {0.5f, low_m}}) {
          const Eigen::Vector3f p = PointOf(asset, middle + sideways * (s + along_m), z_m);
          outline.push_back(camera_.Project(p.x(), camera_.DistanceOf(p.y()), p.z()));
        }
        const Color glass = lit ? WindowLight(style, HashToUnit(53, window, storey))
                                : Times(FromRgb(86, 100, 116), Shade(light_, normal, 1.0f));
        FillPolygon(outline, Mix(glass, light_.fog, building.haze), building.distance_m, canvas_);
      }
    }
  }

  const Scene& scene_;
  const ShadedGround& ground_;
  const PictureLight& light_;
  const ObliqueCamera& camera_;
  const ViewAxes axes_;
  const Haze haze_;
  Canvas* canvas_;
};

}  // namespace

void PaintObliqueAssets(const Scene& scene, const ShadedGround& ground, const PictureLight& light,
                        const ObliqueCamera& camera, Canvas* canvas) {
  std::vector<std::size_t> order(scene.assets.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scene.assets[a].y_m > scene.assets[b].y_m;
  });
  AssetPainter painter(scene, ground, light, camera, canvas);
  for (const std::size_t asset : order) painter.Paint(asset);
}

}  // namespace latticeworld
