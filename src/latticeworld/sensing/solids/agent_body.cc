#include "latticeworld/sensing/solids/agent_body.h"

#include <cmath>

namespace latticeworld {
namespace {

using Eigen::Vector3f;

class BodyBuilder {
 public:
  BodyMesh Take() { return std::move(mesh_); }

  void Box(BodyPart part, const Vector3f& center, const Vector3f& half) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (int i = 0; i < 8; ++i) {
      const Vector3f sign(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f);
      mesh_.vertices.push_back(center + half.cwiseProduct(sign));
    }
    constexpr std::uint32_t kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& face : kFaces) {
      Triangle(part, first + face[0], first + face[1], first + face[2]);
      Triangle(part, first + face[0], first + face[2], first + face[3]);
    }
  }

  // pitch_rad: of its long axis x, up at the front.
  void Ellipsoid(BodyPart part, const Vector3f& center, const Vector3f& radius,
                 float pitch_rad = 0.0f) {
    constexpr int kRings = 8, kSectors = 14;
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    const float c = std::cos(pitch_rad), s = std::sin(pitch_rad);
    for (int ring = 0; ring <= kRings; ++ring) {
      const float polar = static_cast<float>(M_PI) * static_cast<float>(ring) / kRings;
      for (int sector = 0; sector < kSectors; ++sector) {
        const float turn = 2.0f * static_cast<float>(M_PI) * static_cast<float>(sector) / kSectors;
        const Vector3f at = radius.cwiseProduct(Vector3f(
            std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)));
        mesh_.vertices.push_back(
            center + Vector3f(c * at.x() - s * at.z(), at.y(), s * at.x() + c * at.z()));
      }
    }
    for (std::uint32_t ring = 0; ring < kRings; ++ring) {
      for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
        const std::uint32_t next = (sector + 1) % kSectors;
        const std::uint32_t a = first + ring * kSectors + sector,
                            b = first + ring * kSectors + next;
        if (ring > 0) Triangle(part, a, a + kSectors, b);
        if (ring + 1 < kRings) Triangle(part, b, a + kSectors, b + kSectors);
      }
    }
  }

  // Four legs at (+-x, +-y).
  void Legs(float x_m, float y_m, float length_m, float half_m) {
    for (const float x : {-x_m, x_m})
      for (const float y : {-y_m, y_m})
        Box(BodyPart::kLimb, {x, y, 0.5f * length_m}, {half_m, half_m, 0.5f * length_m});
  }

  // A wheel or a rotor: a short cylinder about the axis y or z.
  void Disc(BodyPart part, const Vector3f& center, float radius_m, float half_m, bool lying) {
    constexpr std::uint32_t kSides = 14;
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const float turn = 2.0f * static_cast<float>(M_PI) * static_cast<float>(i) / kSides;
      const float u = radius_m * std::cos(turn), v = radius_m * std::sin(turn);
      for (const float w : {-half_m, half_m})
        mesh_.vertices.push_back(center + (lying ? Vector3f(u, v, w) : Vector3f(v, w, u)));
    }
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % kSides);
      Triangle(part, a, b, a + 1);
      Triangle(part, b, b + 1, a + 1);
      if (i < 2) continue;
      const std::uint32_t before = first + 2 * (i - 1);
      Triangle(part, first, a, before);
      Triangle(part, first + 1, before + 1, a + 1);
    }
  }

 private:
  void Triangle(BodyPart part, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.triangles.push_back({a, b, c});
    mesh_.parts.push_back(part);
  }

  BodyMesh mesh_;
};

// Somebody on two legs.
void AddUpright(float height_m, float half_width_m, BodyBuilder* body) {
  const float h = height_m, w = half_width_m;
  for (const float side : {-1.0f, 1.0f}) {
    body->Box(BodyPart::kLimb, {0.0f, side * 0.5f * w, 0.24f * h},
              {0.38f * w, 0.34f * w, 0.24f * h});
    body->Ellipsoid(BodyPart::kCoat, {0.1f * w, side * 1.15f * w, 0.6f * h},
                    {0.3f * w, 0.26f * w, 0.2f * h});
  }
  body->Ellipsoid(BodyPart::kCoat, {0.0f, 0.0f, 0.64f * h}, {0.62f * w, 0.95f * w, 0.21f * h});
  body->Ellipsoid(BodyPart::kHead, {0.0f, 0.0f, 0.92f * h}, {0.5f * w, 0.45f * w, 0.08f * h});
}

void AddHorse(BodyBuilder* body) {
  body->Legs(0.55f, 0.2f, 0.95f, 0.07f);
  body->Ellipsoid(BodyPart::kCoat, {0.0f, 0.0f, 1.2f}, {0.85f, 0.3f, 0.36f});
  body->Ellipsoid(BodyPart::kCoat, {0.8f, 0.0f, 1.6f}, {0.48f, 0.14f, 0.19f}, 0.95f);
  body->Ellipsoid(BodyPart::kHead, {1.08f, 0.0f, 1.93f}, {0.32f, 0.12f, 0.14f}, -0.6f);
  body->Ellipsoid(BodyPart::kDetail, {-0.9f, 0.0f, 1.0f}, {0.42f, 0.07f, 0.08f}, 1.3f);  // tail
}

void AddEagle(BodyBuilder* body) {
  body->Ellipsoid(BodyPart::kCoat, {0.0f, 0.0f, 0.16f}, {0.42f, 0.13f, 0.14f});
  body->Ellipsoid(BodyPart::kHead, {0.45f, 0.0f, 0.22f}, {0.14f, 0.08f, 0.08f});
  for (const float side : {-1.0f, 1.0f})
    body->Ellipsoid(BodyPart::kLimb, {0.02f, side * 0.6f, 0.22f}, {0.2f, 0.55f, 0.025f});
  body->Ellipsoid(BodyPart::kLimb, {-0.5f, 0.0f, 0.15f}, {0.2f, 0.14f, 0.02f});
}

void AddWhale(BodyBuilder* body) {
  body->Ellipsoid(BodyPart::kCoat, {0.4f, 0.0f, 1.2f}, {3.0f, 1.1f, 1.15f});
  body->Ellipsoid(BodyPart::kCoat, {-2.6f, 0.0f, 1.3f}, {1.7f, 0.45f, 0.4f}, -0.12f);
  body->Ellipsoid(BodyPart::kLimb, {-4.2f, 0.0f, 1.5f}, {0.5f, 1.3f, 0.1f});
  for (const float side : {-1.0f, 1.0f})
    body->Ellipsoid(BodyPart::kLimb, {1.0f, side * 1.4f, 0.7f}, {0.45f, 0.7f, 0.1f});
}

void AddWheeledRobot(BodyBuilder* body) {
  body->Box(BodyPart::kCoat, {0.0f, 0.0f, 0.3f}, {0.45f, 0.28f, 0.13f});
  for (const float x : {-0.28f, 0.28f})
    for (const float y : {-0.33f, 0.33f})
      body->Disc(BodyPart::kLimb, {x, y, 0.16f}, 0.16f, 0.05f, /*lying=*/false);
  body->Box(BodyPart::kHead, {0.2f, 0.0f, 0.55f}, {0.03f, 0.03f, 0.14f});
  body->Disc(BodyPart::kDetail, {0.2f, 0.0f, 0.73f}, 0.08f, 0.05f, /*lying=*/true);  // lidar
}

void AddAerialRobot(BodyBuilder* body) {
  body->Box(BodyPart::kCoat, {0.0f, 0.0f, 0.12f}, {0.14f, 0.1f, 0.06f});
  for (const float x : {-0.25f, 0.25f}) {
    for (const float y : {-0.25f, 0.25f}) {
      body->Disc(BodyPart::kLimb, {x, y, 0.2f}, 0.15f, 0.008f, /*lying=*/true);
      body->Box(BodyPart::kHead, {0.5f * x, 0.5f * y, 0.14f}, {0.1f, 0.1f, 0.015f});
    }
  }
  body->Box(BodyPart::kDetail, {0.12f, 0.0f, 0.05f}, {0.04f, 0.04f, 0.05f});  // camera
}

// The size of a body that BuildBody makes: the height to the top of its back or head, and the
// species' radius that it is made for.
struct BuiltSize {
  double height_m, radius_m;
};

BuiltSize BuiltSizeOf(AgentCategory category) {
  switch (category) {
    case AgentCategory::kGoblin:
      return {1.2, 0.4};
    case AgentCategory::kHumanoidRobot:
      return {1.65, 0.35};
    case AgentCategory::kAncientWarrior:
      return {1.8, 0.4};
    case AgentCategory::kRoboticDog:
      return {0.58, 0.4};
    case AgentCategory::kSheep:
      return {0.86, 0.6};
    case AgentCategory::kHorse:
      return {2.14, 1.2};
    case AgentCategory::kEagle:
      return {0.3, 0.6};
    case AgentCategory::kAerialRobot:
      return {0.21, 0.4};
    case AgentCategory::kWhale:
      return {2.35, 3.0};
    case AgentCategory::kWheeledRobot:
      break;
  }
  return {0.43, 0.6};
}

}  // namespace

BodyMesh BuildBody(AgentCategory category) {
  BodyBuilder body;
  // Bodies are in metres, x towards their front, their lowest point at z = 0.
  switch (category) {
    case AgentCategory::kGoblin:
      AddUpright(1.2f, 0.24f, &body);
      for (const float side : {-1.0f, 1.0f})  // ears
        body.Ellipsoid(BodyPart::kHead, {0.0f, side * 0.17f, 1.14f}, {0.04f, 0.12f, 0.05f});
      break;
    case AgentCategory::kHumanoidRobot:
      AddUpright(1.65f, 0.24f, &body);
      body.Box(BodyPart::kDetail, {0.1f, 0.0f, 1.53f}, {0.03f, 0.08f, 0.03f});  // visor
      break;
    case AgentCategory::kAncientWarrior:
      AddUpright(1.8f, 0.26f, &body);
      body.Disc(BodyPart::kDetail, {0.22f, 0.3f, 1.1f}, 0.3f, 0.02f, /*lying=*/false);
      body.Box(BodyPart::kDetail, {0.2f, -0.36f, 1.15f}, {0.015f, 0.015f, 1.0f});  // spear
      break;
    case AgentCategory::kRoboticDog:
      body.Legs(0.26f, 0.13f, 0.4f, 0.035f);
      body.Box(BodyPart::kCoat, {0.0f, 0.0f, 0.47f}, {0.34f, 0.12f, 0.08f});
      body.Box(BodyPart::kHead, {0.38f, 0.0f, 0.52f}, {0.07f, 0.09f, 0.06f});
      break;
    case AgentCategory::kSheep:
      body.Legs(0.28f, 0.13f, 0.36f, 0.04f);
      body.Ellipsoid(BodyPart::kCoat, {0.0f, 0.0f, 0.58f}, {0.5f, 0.28f, 0.28f});
      body.Ellipsoid(BodyPart::kHead, {0.52f, 0.0f, 0.72f}, {0.17f, 0.09f, 0.11f}, -0.5f);
      break;
    case AgentCategory::kHorse:
      AddHorse(&body);
      break;
    case AgentCategory::kEagle:
      AddEagle(&body);
      break;
    case AgentCategory::kAerialRobot:
      AddAerialRobot(&body);
      break;
    case AgentCategory::kWhale:
      AddWhale(&body);
      break;
    case AgentCategory::kWheeledRobot:
      AddWheeledRobot(&body);
      break;
  }
  return body.Take();
}

Eigen::Affine3d BaseFromBody(AgentCategory category, double height_m, double radius_m) {
  const BuiltSize built = BuiltSizeOf(category);
  const double across = radius_m / built.radius_m;
  return Eigen::Affine3d(Eigen::Scaling(across, across, height_m / built.height_m));
}

}  // namespace latticeworld
