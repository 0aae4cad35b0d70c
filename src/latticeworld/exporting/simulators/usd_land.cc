#include "latticeworld/exporting/simulators/usd_land.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/exporting/gltf/media.h"
#include "latticeworld/exporting/simulators/usd_text.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/surface_table.h"

namespace latticeworld {
namespace {

constexpr char kLooks[] = "/World/looks/";

using Triangles = std::vector<std::uint32_t>;  // numbers of them
using ByClass = std::array<Triangles, kSurfaceClassCount>;

// Sorts triangles by the class of the cell that their middle lies in.
ByClass TrianglesByClass(const Terrain& terrain, const SurfaceMesh& mesh) {
  ByClass triangles;
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    const Eigen::Vector3f middle_m =
        (mesh.positions_m[mesh.corners[i]] + mesh.positions_m[mesh.corners[i + 1]] +
         mesh.positions_m[mesh.corners[i + 2]]) /
        3.0f;
    const CellIndex cell = terrain.geometry().CellAt({middle_m.x(), middle_m.y()});
    triangles[static_cast<std::size_t>(terrain.surface[cell])].push_back(
        static_cast<std::uint32_t>(i / 3));
  }
  return triangles;
}

// The classes that have triangles. Readers that know one friction a mesh (newton) take the first
// subset's.
std::vector<SurfaceClass> LargestFirst(const ByClass& triangles) {
  std::vector<SurfaceClass> classes;
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    if (!triangles[static_cast<std::size_t>(entry.value)].empty()) classes.push_back(entry.value);
  }
  std::stable_sort(classes.begin(), classes.end(), [&](SurfaceClass a, SurfaceClass b) {
    return triangles[static_cast<std::size_t>(a)].size() >
           triangles[static_cast<std::size_t>(b)].size();
  });
  return classes;
}

void AddPoints(const SurfaceMesh& mesh, UsdText* world) {
  UsdExtent extent;
  for (const Eigen::Vector3f& position : mesh.positions_m) extent.Add(position);
  world->Value("float3[] extent", extent.Text());
  world->Value("int[] faceVertexCounts", UsdArray(Triangles(mesh.corners.size() / 3, 3)));
  world->Value("int[] faceVertexIndices", UsdArray(mesh.corners));
  world->Value("point3f[] points", UsdArray(mesh.positions_m));
  world->Value("uniform token subdivisionScheme", "\"none\"");
}

void AddFriction(const std::string& name, double friction, UsdText* looks) {
  looks->Open({"Material", name, {"PhysicsMaterialAPI"}});
  looks->Number("float physics:dynamicFriction", friction);
  looks->Number("float physics:staticFriction", friction);
  looks->Number("float physics:restitution", 0.0);
  looks->Close();
}

// UsdPreviewSurface with the picture of the ground.
void AddGroundLook(UsdText* looks) {
  const std::string path = std::string(kLooks) + "ground";
  looks->Open({"Material", "ground"});
  looks->Value("token outputs:surface.connect", "<" + path + "/surface.outputs:surface>");
  looks->Open({"Shader", "surface"});
  looks->Value("uniform token info:id", "\"UsdPreviewSurface\"");
  looks->Value("color3f inputs:diffuseColor.connect", "<" + path + "/picture.outputs:rgb>");
  looks->Number("float inputs:roughness", 1.0);
  looks->Declare("token outputs:surface");
  looks->Close();
  looks->Open({"Shader", "picture"});
  looks->Value("uniform token info:id", "\"UsdUVTexture\"");
  looks->Value("asset inputs:file", "@./ground.jpg@");
  looks->Value("token inputs:sourceColorSpace", "\"sRGB\"");
  looks->Value("token inputs:wrapS", "\"clamp\"");
  looks->Value("token inputs:wrapT", "\"clamp\"");
  looks->Value("float2 inputs:st.connect", "<" + path + "/st.outputs:result>");
  looks->Declare("float3 outputs:rgb");
  looks->Close();
  looks->Open({"Shader", "st"});
  looks->Value("uniform token info:id", "\"UsdPrimvarReader_float2\"");
  looks->Value("string inputs:varname", "\"st\"");
  looks->Declare("float2 outputs:result");
  looks->Close();
  looks->Close();
}

}  // namespace

void AddUsdGround(const Scene& scene, const SurfaceLattice& lattice, UsdText* looks,
                  UsdText* world) {
  SurfaceMesh mesh = GroundMesh(*scene.terrain, lattice);
  for (Eigen::Vector2f& st : mesh.texture_coordinates) st.y() = 1.0f - st.y();  // from the south
  AddGroundLook(looks);
  world->Open({"Mesh",
               "ground",
               {"MaterialBindingAPI", "PhysicsCollisionAPI", "PhysicsMeshCollisionAPI",
                "SemanticsLabelsAPI:class"}});
  AddPoints(mesh, world);
  world->Primvar("texCoord2f[] primvars:st", "vertex", UsdArray(mesh.texture_coordinates));
  world->Label("ground");
  world->Value("uniform token physics:approximation", "\"none\"");
  world->Relation("material:binding", {std::string(kLooks) + "ground"});
  world->Relation("material:binding:physics", {std::string(kLooks) + "friction_ground"});
  world->Value("uniform token subsetFamily:materialBind:familyType", "\"partition\"");

  const ByClass triangles = TrianglesByClass(*scene.terrain, mesh);
  const SurfaceTable surfaces(scene, scene.atmosphere.ground());
  double sum = 0.0;
  for (const SurfaceClass surface : LargestFirst(triangles)) {
    const Triangles& of_class = triangles[static_cast<std::size_t>(surface)];
    const std::string name = internal::PlainName(std::string(NameOf(surface)));
    const double friction = surfaces.Of(surface).friction;
    sum += friction * static_cast<double>(of_class.size());
    AddFriction("friction_" + name, friction, looks);
    world->Open({"GeomSubset", name, {"MaterialBindingAPI", "SemanticsLabelsAPI:class"}});
    world->Value("uniform token elementType", "\"face\"");
    world->Value("uniform token familyName", "\"materialBind\"");
    world->Value("int[] indices", UsdArray(of_class));
    world->Label(NameOf(surface));
    world->Relation("material:binding:physics", {std::string(kLooks) + "friction_" + name});
    world->Close();
  }
  AddFriction("friction_ground", 3.0 * sum / static_cast<double>(mesh.corners.size()), looks);
  world->Close();
}

void AddUsdWater(const Scene& scene, const SurfaceLattice& lattice, UsdText* world) {
  const SurfaceMesh mesh = WaterMesh(*scene.terrain, lattice);
  if (mesh.corners.empty()) return;
  world->Open({"Mesh", "water", {"SemanticsLabelsAPI:class"}});
  AddPoints(mesh, world);
  world->Value("uniform bool doubleSided", "true");
  world->Value("color3f[] primvars:displayColor", "[(0.03, 0.09, 0.11)]");
  world->Value("float[] primvars:displayOpacity", "[0.72]");
  world->Label("water");
  world->Close();
}

}  // namespace latticeworld
