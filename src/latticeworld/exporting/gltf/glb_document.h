#ifndef LATTICEWORLD_EXPORTING_GLTF_GLB_DOCUMENT_H_
#define LATTICEWORLD_EXPORTING_GLTF_GLB_DOCUMENT_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

// A place or direction of the frame map in glTF's axes: x east, y up, z south. What a body or model
// has along (front, left, up) is along (x, -z, y) there.
inline Eigen::Vector3f YUp(const Eigen::Vector3f& z_up) { return {z_up.x(), z_up.z(), -z_up.y()}; }

struct GlbMaterial {
  std::string name;
  Eigen::Vector4f base_color = Eigen::Vector4f::Ones();  // linear RGB and opacity, [0, 1]
  int texture = -1;  // of AddTexture, times base_color; -1: none
  float roughness = 1.0f;
  bool both_sides = false;
};

struct GlbPrimitive {
  int positions = -1;  // accessors
  int texture_coordinates = -1;
  int normals = -1;  // -1: readers shade each triangle flat
  int indices = -1;
  int material = -1;
};

// One mesh in many places, each in the frame of the node (EXT_mesh_gpu_instancing).
struct GlbInstances {
  int translations = -1, rotations = -1, scales = -1;  // accessors
  int assets = -1;                                     // "_ASSET": of each its number; -1: none
};

// What a node is of, for programs (its "extras").
struct GlbExtras {
  std::string kind;   // "": nothing is said
  std::string model;  // "": none
  std::optional<std::uint32_t> asset;
};

// What becomes of characters of names that three.js takes out, so that names could meet: brackets,
// full stops, colons, slashes and blanks.
enum class GlbNames : std::uint8_t {
  kAsGiven,
  kPlain  // each becomes "_"
};

struct GlbNode {
  std::string name;
  int mesh = -1;
  int light = -1;                                // of AddSun
  std::optional<Eigen::Vector3f> translation_m;  // in the parent's frame, glTF's axes
  std::optional<Eigen::Quaternionf> rotation;
  std::optional<Eigen::Vector3f> scale;
  std::optional<GlbInstances> instances;
  GlbExtras extras;
  std::vector<int> children;
};

// Puts a glTF 2.0 binary file together (Khronos, glTF 2.0 specification, 2021). Numbers that it
// gives are indices into the file's lists, in the order of the calls; the same calls give the same
// bytes. All data is in glTF's axes.
class GlbDocument {
 public:
  // names: of nodes, meshes, materials, textures and lights.
  explicit GlbDocument(GlbNames names = GlbNames::kAsGiven);
  ~GlbDocument();

  // Accessors. Vectors must not be empty, and every number must be finite.
  int AddPositions(const std::vector<Eigen::Vector3f>& positions_m);  // with their bounds
  // The same within [-1, 1], in steps of 1 / 32767 (KHR_mesh_quantization).
  int AddUnitPositions(const std::vector<Eigen::Vector3f>& positions);
  int AddVectors(const std::vector<Eigen::Vector3f>& vectors);
  int AddNormals(const std::vector<Eigen::Vector3f>& normals);
  int AddTextureCoordinates(const std::vector<Eigen::Vector2f>& coordinates);
  // Whole numbers as floats, exact up to 2^24: the format has no whole numbers of 32 bits here.
  int AddNumbers(const std::vector<std::uint32_t>& numbers);
  int AddRotations(const std::vector<Eigen::Quaternionf>& rotations);
  // Corners of triangles, of a list of so many vertices; 16 bit where they suffice.
  int AddIndices(const std::vector<std::uint32_t>& corners, std::size_t vertices);

  int AddTexture(const std::string& jpeg, const std::string& name);
  int AddMaterial(const GlbMaterial& material);
  int AddMesh(const std::string& name, const std::vector<GlbPrimitive>& primitives);
  // Light from infinitely far along -z of its node.
  int AddSun(const std::string& name, const Eigen::Vector3f& linear_color, double illuminance_lux);
  int AddNode(const GlbNode& node);

  // The file, with one scene of these nodes. name: of the scene. Errors: RESOURCE_EXHAUSTED (longer
  // than the format's 4 GiB, or than memory).
  Result<std::string> Finish(const std::vector<int>& root_nodes, const std::string& name) const;

 private:
  struct Parts;
  std::string Named(const std::string& name) const;
  int AddView(const void* data, std::size_t bytes, int target);
  int AddAccessor(int view, int component, std::size_t count, const char* type);

  std::unique_ptr<Parts> parts_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_GLTF_GLB_DOCUMENT_H_
