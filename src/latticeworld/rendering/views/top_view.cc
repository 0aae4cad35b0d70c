#include "latticeworld/rendering/views/top_view.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/rendering/looks/bridge_looks.h"
#include "latticeworld/rendering/looks/ground_shading.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

class MapPainter {
 public:
  MapPainter(const Scene& scene, const PictureLight& light, int side_px, cv::Mat bgr)
      : scene_(scene),
        light_(light),
        px_per_m_(static_cast<float>(side_px / scene.geometry().size_m())),
        half_size_m_(static_cast<float>(scene.geometry().half_size_m())),
        bgr_(std::move(bgr)) {}

  Eigen::Vector2f PixelOf(float x_m, float y_m) const {
    return Eigen::Vector2f(x_m + half_size_m_, half_size_m_ - y_m) * px_per_m_;
  }

  // Decks, and railings as lines along them.
  void PaintBridges() {
    const ArtisticStyle style = scene_.environment.coarse.artistic_style;
    for (const Bridge& bridge : scene_.terrain->bridges) {
      const std::vector<BridgePart> parts = PartsOf(bridge, scene_.terrain->ground);
      const Color deck = InStyle(style, ColorOfBridge(bridge.kind, BridgePartKind::kDeck, true));
      const Color lit = Times(deck, Shade(light_, Eigen::Vector3f::UnitZ(), 1.0f));
      // The rim first, so that it stays beside all pieces of a deck.
      for (const float rim_m : {0.5f, 0.0f}) {
        for (const BridgePart& part : parts) {
          if (part.kind == BridgePartKind::kDeck)
            PaintBox(part, rim_m, rim_m > 0.0f ? lit * 0.45f : lit);
        }
      }
    }
  }

  void Paint(std::size_t index) {
    const Asset& asset = scene_.assets[index];
    switch (asset.kind) {
      case AssetKind::kTree:
      case AssetKind::kBush:
        PaintPlant(asset, LookOfPlant(scene_, asset));
        break;
      case AssetKind::kStone:
        PaintRound(asset, StoneColor(scene_, asset), 0.25f);
        break;
      case AssetKind::kBuilding:
        PaintBuilding(asset, LookOfBuilding(scene_, asset));
        break;
      case AssetKind::kDeadBranch:
        PaintRound(asset, FromRgb(104, 84, 64), 0.3f);
        break;
      case AssetKind::kGrassTuft:
      case AssetKind::kCrop:
      case AssetKind::kFlower:
        break;  // the ground's colours show them
    }
  }

 private:
  // Seen from above, wider by rim_m on both sides.
  void PaintBox(const BridgePart& part, float rim_m, const Color& color) {
    const Eigen::Vector2f along(std::cos(part.yaw_rad), std::sin(part.yaw_rad));
    const Eigen::Vector2f across(-along.y(), along.x());
    const auto corner = [&](float l, float w) {
      const Eigen::Vector2f at = Eigen::Vector2f(part.middle.x_m, part.middle.y_m) +
                                 along * (l * static_cast<float>(part.half_length_m)) +
                                 across * (w * (static_cast<float>(part.half_width_m) + rim_m));
      return PixelOf(at.x(), at.y());
    };
    FillPolygon({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, color, &bgr_);
  }

  void PaintPlant(const Asset& asset, const PlantLook& look) {
    Ball ball = BallOf(asset);
    ball.color = look.leaf;
    ball.foliage = look.foliage;
    ball.roughness = 0.4f;
    ball.snow = 0.75f * look.snow;
    PaintBall(ball, light_, &bgr_);
  }

  void PaintRound(const Asset& asset, const Color& color, float roughness) {
    Ball ball = BallOf(asset);
    ball.color = color;
    ball.roughness = roughness;
    PaintBall(ball, light_, &bgr_);
  }

  Ball BallOf(const Asset& asset) const {
    Ball ball;
    ball.center = PixelOf(asset.x_m, asset.y_m);
    ball.radius = Eigen::Vector2f::Constant(std::max(0.9f, asset.half_length_m * px_per_m_));
    return ball;
  }

  // The two slopes of a roof, split along the ridge, or one flat one with its rim.
  void PaintBuilding(const Asset& asset, const BuildingLook& look) {
    const Eigen::Vector2f along(std::cos(asset.yaw_rad), std::sin(asset.yaw_rad));
    const Eigen::Vector2f across(-along.y(), along.x());
    const auto corner = [&](float l, float w) -> Eigen::Vector2f {
      const Eigen::Vector2f at = Eigen::Vector2f(asset.x_m, asset.y_m) +
                                 along * (l * asset.half_length_m) +
                                 across * (w * asset.half_width_m);
      return PixelOf(at.x(), at.y());
    };
    const auto quad = [&](float w_low, float w_high, float grow, const Color& color) {
      FillPolygon(
          {corner(-grow, w_low), corner(grow, w_low), corner(grow, w_high), corner(-grow, w_high)},
          color, &bgr_);
    };
    const Color roof = Mix(look.roof, FromRgb(240, 244, 250), 0.8f * look.snow);
    const float rim = 1.0f + 0.5f / std::max(1.0f, asset.half_width_m);
    quad(-rim, rim, rim, InkColor() * 1.2f);
    if (look.gabled) {
      for (const float side : {-1.0f, 1.0f}) {
        const Eigen::Vector3f normal =
            Eigen::Vector3f(side * across.x() * 0.55f, side * across.y() * 0.55f, 0.83f);
        quad(std::min(0.0f, side), std::max(0.0f, side), 1.0f,
             Times(roof, Shade(light_, normal, 1.0f)));
      }
      quad(-0.05f, 0.05f, 1.0f, roof * 1.15f);
    } else {
      const Color flat = Times(roof, Shade(light_, Eigen::Vector3f::UnitZ(), 1.0f));
      quad(-1.0f, 1.0f, 1.0f, flat * 1.08f);
      quad(-0.82f, 0.82f, 0.86f, flat * 0.92f);
    }
  }

  const Scene& scene_;
  const PictureLight& light_;
  const float px_per_m_;
  const float half_size_m_;
  cv::Mat bgr_;
};

// Low things first, so that crowns lie over what they cover.
std::vector<std::size_t> ByTop(const std::vector<Asset>& assets) {
  std::vector<std::size_t> order(assets.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return assets[a].height_m < assets[b].height_m;
  });
  return order;
}

}  // namespace

cv::Mat PaintTopView(const Scene& scene, const GroundMaterials& materials, const Footer& footer,
                     int width_px, bool agents) {
  const Sheet sheet(width_px, footer.lines);
  const cv::Vec3b paper = ToBytes(PaperColor());
  cv::Mat bgr(sheet.height * kSupersample, sheet.width * kSupersample, CV_8UC3,
              cv::Scalar(paper[0], paper[1], paper[2]));
  const int side_px = sheet.map_side() * kSupersample;
  cv::Mat map =
      bgr(cv::Rect(sheet.margin * kSupersample, sheet.margin * kSupersample, side_px, side_px));

  const PictureLight light = MapLight();
  const cv::Mat ground = ShadeGround(scene, materials, light);
  cv::Mat bytes;
  ground.convertTo(bytes, CV_8UC3, 255.0);
  cv::resize(bytes, map, map.size(), 0, 0,
             side_px < ground.cols ? cv::INTER_AREA : cv::INTER_CUBIC);

  MapPainter painter(scene, light, side_px, map);
  painter.PaintBridges();
  for (const std::size_t asset : ByTop(scene.assets)) painter.Paint(asset);
  if (agents) {
    const float radius = std::max(1.5f, 0.0062f * sheet.width);
    for (const AgentStart& agent : scene.agents)
      DrawMarker(painter.PixelOf(agent.position.x_m, agent.position.y_m), radius,
                 AgentColor(agent.category), &map);
  }
  DrawFrame({sheet.margin, sheet.margin, sheet.map_side(), sheet.map_side()}, &bgr);
  DrawNorthArrow(sheet, &bgr);
  DrawScaleBar(scene, sheet, &bgr);
  DrawFooter(footer, sheet, &bgr);
  return bgr;
}

}  // namespace latticeworld
