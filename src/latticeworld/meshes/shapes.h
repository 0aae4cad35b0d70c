#ifndef LATTICEWORLD_MESHES_SHAPES_H_
#define LATTICEWORLD_MESHES_SHAPES_H_

#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh_builder.h"

namespace latticeworld {

// What a shape is made from.
struct ShapeInput {
  const AssetModel& model;
  Vec3 size_m;  // typical half length, half width and height
  double foliage = 1.0;
  int detail = 0;
  RandomStream random;  // of the model and the variation; the same at every detail
};

// Each fills the builder with a mesh in the unit box.
void BuildBroadleafTree(ShapeInput input, MeshBuilder* builder);
void BuildConiferTree(ShapeInput input, MeshBuilder* builder);
void BuildBush(ShapeInput input, MeshBuilder* builder);
void BuildGrassTuft(ShapeInput input, MeshBuilder* builder);
void BuildReed(ShapeInput input, MeshBuilder* builder);
void BuildFlower(ShapeInput input, MeshBuilder* builder);
void BuildBranch(ShapeInput input, MeshBuilder* builder);
void BuildBoulder(ShapeInput input, MeshBuilder* builder);
void BuildSlab(ShapeInput input, MeshBuilder* builder);
void BuildCereal(ShapeInput input, MeshBuilder* builder);
void BuildMaize(ShapeInput input, MeshBuilder* builder);
void BuildRapeseed(ShapeInput input, MeshBuilder* builder);
void BuildVine(ShapeInput input, MeshBuilder* builder);
void BuildGabledHouse(ShapeInput input, MeshBuilder* builder);
void BuildRowHouse(ShapeInput input, MeshBuilder* builder);
void BuildBarn(ShapeInput input, MeshBuilder* builder);
void BuildFlatBlock(ShapeInput input, MeshBuilder* builder);
void BuildTower(ShapeInput input, MeshBuilder* builder);
void BuildParts(ShapeInput input, MeshBuilder* builder);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_SHAPES_H_
