#include "latticeworld/sensing/solids/asset_tiles.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "latticeworld/common/parallel.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr double kFarthestTile = 1e6;  // beyond it all is equally far

bool IsPlant(AssetKind kind) { return kind != AssetKind::kStone && kind != AssetKind::kBuilding; }

}  // namespace

AssetTiles::AssetTiles(RTCDevice device, const Scene& scene, const SensorSceneOptions& options)
    : device_(device),
      scene_(scene),
      options_(options),
      meshes_(device, *scene.catalogue),
      group_(device) {
  std::map<std::pair<Place, bool>, std::vector<std::uint32_t>> by_place;
  for (std::size_t i = 0; i < scene.assets.size(); ++i) {
    const Asset& asset = scene.assets[i];
    by_place[{PlaceOf(asset.x_m, asset.y_m), IsPlant(asset.kind)}].push_back(
        static_cast<std::uint32_t>(i));
  }
  tile_of_.resize(scene.assets.size());
  for (auto& [place, assets] : by_place) {
    for (const std::uint32_t asset : assets)
      tile_of_[asset] = static_cast<std::uint32_t>(tiles_.size());
    tiles_.push_back({place.first, place.second, std::move(assets)});
  }
  looks_.resize(tiles_.size());
}

Result<std::unique_ptr<AssetTiles>> AssetTiles::Create(RTCDevice device, const Scene& scene,
                                                       const SensorSceneOptions& options,
                                                       const Progress& progress) {
  std::unique_ptr<AssetTiles> tiles(new AssetTiles(device, scene, options));
  LW_RETURN_IF_ERROR(tiles->Change({}, progress));
  return tiles;
}

AssetTiles::Place AssetTiles::PlaceOf(double x_m, double y_m) const {
  const auto along = [this](double value_m) {
    return static_cast<int>(
        std::clamp(std::floor(value_m / options_.tile_m), -kFarthestTile, kFarthestTile));
  };
  return {along(x_m), along(y_m)};
}

double AssetTiles::DistanceFrom(const std::vector<Place>& focus, Place place) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Place& eye : focus)
    nearest = std::min(nearest, std::hypot(eye.first - place.first, eye.second - place.second));
  return nearest * options_.tile_m;
}

int AssetTiles::DetailAt(const std::vector<Place>& focus, Place place) const {
  const double away_m = DistanceFrom(focus, place);
  return away_m < options_.finest_within_m ? 0 : away_m < options_.medium_within_m ? 1 : 2;
}

std::vector<std::uint32_t> AssetTiles::StandingIn(std::size_t tile,
                                                  const Situation& situation) const {
  const std::vector<std::uint32_t>& assets = tiles_[tile].assets;
  const auto& absent = situation.absent;
  std::vector<std::uint32_t> standing;
  standing.reserve(assets.size());
  std::set_difference(assets.begin(), assets.end(),
                      std::lower_bound(absent.begin(), absent.end(), assets.front()), absent.end(),
                      std::back_inserter(standing));
  return standing;
}

std::vector<bool> AssetTiles::ToBake(const Situation& situation,
                                     const std::vector<int>& details) const {
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    const double away_m = DistanceFrom(situation.focus, tiles_[i].place);
    if (away_m < options_.baked_within_m) near.emplace_back(away_m, i);
  }
  std::sort(near.begin(), near.end());
  std::vector<bool> baked(tiles_.size());
  std::size_t triangles = 0;
  for (const auto& [away_m, tile] : near) {
    const std::size_t own =
        TrianglesOf(meshes_, scene_.assets, StandingIn(tile, situation), details[tile]);
    if (triangles + own > options_.max_baked_triangles) continue;
    triangles += own;
    baked[tile] = own > 0;
  }
  return baked;
}

Result<AssetTiles::Look> AssetTiles::Make(std::size_t tile, const Situation& situation, int detail,
                                          bool baked) const {
  Look look = {detail, baked, nullptr};
  const std::vector<std::uint32_t> standing = StandingIn(tile, situation);
  if (standing.empty()) return look;
  const std::vector<Asset>& assets = scene_.assets;
  if (baked) {
    const bool closed = !tiles_[tile].plants;
    LW_ASSIGN_OR_RETURN(look.tile,
                        AssetTile::Baked(device_, meshes_, assets, standing, detail, closed));
  } else {
    LW_ASSIGN_OR_RETURN(look.tile,
                        AssetTile::Instanced(device_, meshes_, assets, standing, detail));
  }
  return look;
}

Status AssetTiles::Change(Situation next, const Progress& progress) {
  // Tiles whose assets fell or came back must be made anew.
  std::vector<bool> stale(tiles_.size());
  std::vector<std::uint32_t> differing;
  std::set_symmetric_difference(now_.absent.begin(), now_.absent.end(), next.absent.begin(),
                                next.absent.end(), std::back_inserter(differing));
  for (const std::uint32_t asset : differing) stale[tile_of_[asset]] = true;

  // Tiles whose detail changes need other meshes.
  std::vector<int> details(tiles_.size());
  std::vector<MeshKey> keys;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    details[i] = DetailAt(next.focus, tiles_[i].place);
    if (details[i] == looks_[i].detail) continue;
    for (const std::uint32_t asset : tiles_[i].assets)
      keys.push_back(meshes_.KeyOf(scene_.assets[asset], details[i]));
  }
  LW_RETURN_IF_ERROR(meshes_.Prepare(keys, options_.threads, progress));

  // What is there is taken, the rest made.
  const std::vector<bool> baked = ToBake(next, details);
  std::vector<Look> looks = looks_;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (!stale[i] && looks[i].detail == details[i] && looks[i].baked == baked[i]) continue;
    const auto kept = kept_.find({i, details[i]});
    if (baked[i] && !stale[i] && kept != kept_.end()) {
      looks[i] = {details[i], true, kept->second.tile};
    } else {
      missing.push_back(i);
    }
  }
  // The missing ones are made side by side; an error leaves everything as it was.
  std::vector<Status> statuses(missing.size());
  ParallelInPieces(static_cast<int>(missing.size()), 1, options_.threads, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const std::size_t tile = missing[k];
      if (progress.cancelled()) return;
      Result<Look> made = Make(tile, next, details[tile], baked[tile]);
      statuses[k] = made.status();
      if (made.ok()) looks[tile] = *std::move(made);
    }
  });
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  for (const Status& status : statuses) LW_RETURN_IF_ERROR(status);

  std::vector<RTCScene> scenes;
  for (const Look& look : looks)
    scenes.push_back(look.tile == nullptr ? nullptr : look.tile->scene());
  LW_RETURN_IF_ERROR(group_.Prepare(scenes));

  // Nothing fails from here on.
  group_.Use();
  ++changes_;
  // Baked tiles are kept for another time, until they are stale or too many.
  for (auto kept = kept_.begin(); kept != kept_.end();)
    kept = stale[kept->first.first] ? kept_.erase(kept) : std::next(kept);
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (!baked[i] || looks[i].tile == nullptr) continue;
    Kept& kept = kept_[{i, details[i]}];
    if (kept.tile == nullptr) {
      kept = {looks[i].tile, looks[i].tile->triangles(), 0};
    }
    kept.last_used = changes_;
  }
  looks_ = std::move(looks);
  now_ = std::move(next);
  ForgetTheOldest();
  return Status();
}

void AssetTiles::ForgetTheOldest() {
  std::size_t triangles = 0;
  std::vector<std::pair<std::uint64_t, KeptTiles::iterator>> unused;
  for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) {
    triangles += kept->second.triangles;
    if (kept->second.last_used != changes_) unused.emplace_back(kept->second.last_used, kept);
  }
  std::stable_sort(unused.begin(), unused.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [last_used, kept] : unused) {
    if (triangles <= options_.max_baked_triangles) return;
    triangles -= kept->second.triangles;
    kept_.erase(kept);
  }
}

Status AssetTiles::Focus(const std::vector<Eigen::Vector3d>& eyes_m) {
  Situation next;
  for (const Eigen::Vector3d& eye_m : eyes_m)
    if (eye_m.allFinite()) next.focus.push_back(PlaceOf(eye_m.x(), eye_m.y()));
  std::sort(next.focus.begin(), next.focus.end());
  next.focus.erase(std::unique(next.focus.begin(), next.focus.end()), next.focus.end());
  if (next.focus == now_.focus) return Status();
  next.absent = now_.absent;
  return Change(std::move(next), Progress());
}

Status AssetTiles::SetAbsent(std::vector<std::uint32_t> absent) {
  if (absent == now_.absent) return Status();
  return Change({now_.focus, std::move(absent)}, Progress());
}

Result<std::shared_ptr<const MeshPrototype>> AssetTiles::MeshOf(const Asset& asset,
                                                                WorldPoint position) {
  const MeshKey key =
      meshes_.KeyOf(asset, DetailAt(now_.focus, PlaceOf(position.x_m, position.y_m)));
  if (meshes_.Of(key) == nullptr) LW_RETURN_IF_ERROR(meshes_.Prepare({key}, 1, Progress()));
  return meshes_.Of(key);
}

void AssetTiles::Describe(const RayPacket& packet, int lane, RayHit* hit) const {
  const RTCHit16& met = packet.rays.hit;
  looks_[met.instID[0][lane]].tile->Describe(met.geomID[lane], met.primID[lane], hit);
}

}  // namespace latticeworld
