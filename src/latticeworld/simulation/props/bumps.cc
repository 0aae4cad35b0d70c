#include "latticeworld/simulation/props/bumps.h"

#include <algorithm>
#include <tuple>

namespace latticeworld {
namespace {

// Normals that point up at least so much carry: what is below 45 degrees is stood on.
constexpr double kCarries = 0.7071;

struct Press {
  double force_n = 0.0;
  Eigen::Vector3d weighted_m = Eigen::Vector3d::Zero();  // sum of points times their forces
};

}  // namespace

std::map<BodyId, Bump> HardestBumps(const std::vector<Contact>& contacts) {
  std::map<std::tuple<BodyId, ContactKind, std::uint32_t>, Press> presses;
  const auto add = [&](BodyId body, ContactKind kind, std::uint32_t other, const Contact& contact,
                       double force_n, double up) {
    if (up > kCarries) return;
    Press& press = presses[{body, kind, other}];
    press.force_n += force_n;
    press.weighted_m += force_n * contact.position_m;
  };
  for (const Contact& contact : contacts) {
    if (contact.kind != ContactKind::kAsset && contact.kind != ContactKind::kBody) continue;
    const double force_n = contact.force_n.dot(contact.normal);
    if (!(force_n > 0.0)) continue;  // NaN too
    add(contact.body, contact.kind, contact.other, contact, force_n, contact.normal.z());
    if (contact.kind == ContactKind::kBody) {
      add(contact.other, contact.kind, contact.body, contact, force_n, -contact.normal.z());
    }
  }
  std::map<BodyId, Bump> bumps;
  for (const auto& [key, press] : presses) {
    Bump& bump = bumps[std::get<0>(key)];
    if (press.force_n > bump.force_n) bump = {press.force_n, press.weighted_m / press.force_n};
  }
  return bumps;
}

}  // namespace latticeworld
