#ifndef LATTICEWORLD_SENSING_SOLIDS_ASSET_MESHES_H_
#define LATTICEWORLD_SENSING_SOLIDS_ASSET_MESHES_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/sensing/solids/mesh_instances.h"

namespace latticeworld {

class Catalogue;
struct Asset;
struct FallenTree;

// Which mesh an asset has: one for each model, share of leaves, detail and individual. Increasing
// in that order, so that meshes come in one order whatever the machine.
using MeshKey = std::uint32_t;

// The meshes of a catalogue's assets, each made when it is first asked for and kept.
class AssetMeshes {
 public:
  // Device and catalogue must outlive this.
  AssetMeshes(RTCDevice device, const Catalogue& catalogue);

  // detail: [0, kMeshDetails).
  MeshKey KeyOf(const Asset& asset, int detail) const;
  std::size_t keys() const { return meshes_.size(); }
  // Makes those that are not there, on up to `threads` threads (0: as many as cores); reports the
  // stage "ray scene" up to 0.8. Errors: CANCELLED, the device's.
  Status Prepare(const std::vector<MeshKey>& wanted, int threads, const Progress& progress);
  // Null: it was not prepared.
  const std::shared_ptr<const MeshPrototype>& Of(MeshKey key) const { return meshes_[key]; }

 private:
  RTCDevice device_;
  const Catalogue& catalogue_;
  std::vector<std::shared_ptr<const MeshPrototype>> meshes_;  // by key; null: not there
};

// The meshes that a list of instances shares, numbered as they come.
class MeshList {
 public:
  explicit MeshList(const AssetMeshes& meshes) : meshes_(meshes), numbers_(meshes.keys(), -1) {}
  // Adds a mesh that was prepared if the list lacks it, and returns its number.
  std::uint16_t Add(MeshKey key) {
    if (numbers_[key] < 0) {
      numbers_[key] = static_cast<std::int32_t>(list_.size());
      list_.push_back(meshes_.Of(key));
    }
    return static_cast<std::uint16_t>(numbers_[key]);
  }
  MeshInstances::Prototypes Take() { return std::move(list_); }

 private:
  const AssetMeshes& meshes_;
  std::vector<std::int32_t> numbers_;  // by key; -1: not in the list
  MeshInstances::Prototypes list_;
};

// An asset where it stands; a tree that lies, leaned along its stem from where its foot is. Both
// without a prototype. index: the asset's.
MeshInstance StandingInstance(const Asset& asset, std::uint32_t index);
MeshInstance LyingInstance(const Asset& asset, const FallenTree& tree);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_ASSET_MESHES_H_
