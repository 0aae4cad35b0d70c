#include "latticeworld/rendering/looks/picture_style.h"

#include <algorithm>

namespace latticeworld {
namespace {

float Luma(const Color& color) { return 0.114f * color[0] + 0.587f * color[1] + 0.299f * color[2]; }

Color Clamped(Color color) {
  for (int channel = 0; channel < 3; ++channel)
    color[channel] = std::clamp(color[channel], 0.0f, 1.0f);
  return color;
}

// Away from grey, for share > 1.
Color Saturated(const Color& color, float share) {
  const float grey = Luma(color);
  return Mix({grey, grey, grey}, color, share);
}

}  // namespace

Color InStyle(ArtisticStyle style, const Color& natural) {
  switch (style) {
    case ArtisticStyle::kRealistic:
      return natural;
    case ArtisticStyle::kCartoon:  // bright and pure
      return Clamped(Mix(Saturated(natural, 1.55f), FromRgb(255, 255, 255), 0.1f));
    case ArtisticStyle::kCyberpunk: {  // dark violet to pale cyan, a hint of the hue left
      const float luma = Luma(natural);
      const Color toned = luma < 0.5f
                              ? Mix(FromRgb(14, 10, 34), FromRgb(84, 62, 132), 2.0f * luma)
                              : Mix(FromRgb(84, 62, 132), FromRgb(176, 226, 240), 2.0f * luma - 1);
      return Clamped(Mix(toned, Saturated(natural, 1.2f) * 0.8f, 0.28f));
    }
  }
  return natural;
}

void ApplyStyle(ArtisticStyle style, PictureSky* sky) {
  switch (style) {
    case ArtisticStyle::kRealistic:
      return;
    case ArtisticStyle::kCartoon:
      sky->high = InStyle(style, sky->high);
      sky->low = InStyle(style, sky->low);
      return;
    case ArtisticStyle::kCyberpunk:
      sky->high = Mix(sky->high, FromRgb(22, 12, 58), 0.88f);
      sky->low = Mix(sky->low, FromRgb(206, 54, 150), 0.72f);
      return;
  }
}

Proportions ProportionsOf(ArtisticStyle style, const AssetModel& model) {
  const AssetKind kind = model.kind;
  switch (style) {
    case ArtisticStyle::kRealistic:
      return {};
    case ArtisticStyle::kCartoon:  // round and big
      if (kind == AssetKind::kTree) return {1.3f, 1.0f};
      if (kind == AssetKind::kBush || kind == AssetKind::kStone) return {1.2f, 1.15f};
      if (kind == AssetKind::kFlower) return {1.7f, 1.5f};
      return {};
    case ArtisticStyle::kCyberpunk:  // houses tower; benches and wells do not
      if (model.is_house()) return {1.0f, 2.0f};
      return {};
  }
  return {};
}

Color WindowLight(ArtisticStyle style, double draw) {
  if (style != ArtisticStyle::kCyberpunk) return FromRgb(255, 206, 120);
  return draw < 0.4   ? FromRgb(72, 244, 255)
         : draw < 0.8 ? FromRgb(255, 84, 214)
                      : FromRgb(255, 232, 110);
}

Color RoadRim(ArtisticStyle style, const Color& road) {
  return style == ArtisticStyle::kCyberpunk ? FromRgb(64, 220, 236)
                                            : Mix(road, FromRgb(226, 216, 192), 0.6f);
}

}  // namespace latticeworld
