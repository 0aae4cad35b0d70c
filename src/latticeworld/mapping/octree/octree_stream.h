#ifndef LATTICEWORLD_MAPPING_OCTREE_OCTREE_STREAM_H_
#define LATTICEWORLD_MAPPING_OCTREE_OCTREE_STREAM_H_

#include <memory>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {

class OctreeBytes;
struct Scene;

// A map's stream while its world changes: a tree that falls or a prop that moves costs the
// tiles that it stood in and those where it is, not the map. It keeps the stream in pieces, about
// as much memory as one message.
class OctreeStream {
 public:
  enum class Format { kBinary, kFull };

  // scene: never null. Errors as of BuildBinaryData.
  static Result<OctreeStream> Create(std::shared_ptr<const Scene> scene, Format format,
                                     const OctreeOptions& options, const Progress& progress);
  OctreeStream(OctreeStream&&) noexcept;
  OctreeStream& operator=(OctreeStream&&) noexcept;
  ~OctreeStream();

  // The stream after the changes since the world began (not since the last call): byte for byte
  // that of BuildBinaryData or BuildFullData. Errors: INVALID_ARGUMENT (changes), CANCELLED; after
  // that the next call writes all tiles anew.
  Result<OctreeData> Update(const SceneChanges& changes, const Progress& progress);
  // How many tiles the last Update wrote.
  int tiles_written() const { return tiles_written_; }

 private:
  OctreeStream();

  std::shared_ptr<const Scene> scene_;
  Format format_ = Format::kBinary;
  OctreeOptions options_;
  SceneChanges changes_;                // that bytes_ shows
  std::unique_ptr<OctreeBytes> bytes_;  // null: not written yet
  int tiles_written_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_OCTREE_STREAM_H_
