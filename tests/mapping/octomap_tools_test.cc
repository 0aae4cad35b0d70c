// Our .bt files in the hands of octomap's own programs, as Debian packs them.

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "latticeworld/mapping/octree/octree.h"
#include "mapping/scene_of_everything.h"
#include "mapping/voxels_of.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class OctomapToolsTest : public testing::Test {
 protected:
  OctomapToolsTest() {
    std::string path = (fs::temp_directory_path() / "octomap_tools_XXXXXX").string();
    EXPECT_NE(mkdtemp(path.data()), nullptr);
    directory_ = path;
  }
  ~OctomapToolsTest() override { fs::remove_all(directory_); }

  fs::path PathOf(const std::string& name) const { return directory_ / name; }
  // The exit status of a program on files of the directory; what it says goes to log.txt.
  int Run(const std::string& program, const std::string& arguments) const {
    const std::string command = "cd '" + directory_.string() + "' && '" + program + "' " +
                                arguments + " > log.txt 2>&1 < /dev/null";
    return std::system(command.c_str());
  }
  std::string Read(const std::string& name) const {
    std::ifstream file(PathOf(name), std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    return std::move(content).str();
  }
  void Write(const std::string& name, const std::string& content) const {
    std::ofstream(PathOf(name), std::ios::binary) << content;
  }

 private:
  fs::path directory_;
};

TEST_F(OctomapToolsTest, ReadOurFilesAsTheSameTree) {
  for (const double voxel_m : {0.5, 0.2}) {
    const Scene scene = SceneOfEverything(3);
    const auto tree = BuildOctree(scene, {voxel_m, 1.0}, Progress()).value();
    const OctreeData data = BuildBinaryData(scene, {voxel_m, 1.0}, Progress()).value();
    Write("ours.bt", BinaryFile(data, voxel_m));

    // The binary file as a full one, read by octomap.
    ASSERT_EQ(Run(LATTICEWORLD_CONVERT_OCTREE, "ours.bt ours.ot"), 0) << Read("log.txt");
    EXPECT_EQ(Read("log.txt").find("ERROR"), std::string::npos) << Read("log.txt");
    const std::unique_ptr<octomap::AbstractOcTree> read(
        octomap::AbstractOcTree::read(PathOf("ours.ot").string()));
    const auto* converted = dynamic_cast<const octomap::OcTree*>(read.get());
    ASSERT_NE(converted, nullptr);
    EXPECT_EQ(converted->getResolution(), voxel_m);
    EXPECT_EQ(converted->size(), tree->size());
    EXPECT_EQ(VoxelsOf(*converted), VoxelsOf(*tree));

    // As many boxes to look at as there are occupied leaves.
    ASSERT_EQ(Run(LATTICEWORLD_BT2VRML, "ours.bt"), 0) << Read("log.txt");
    const std::string scene_of_boxes = Read("ours.bt.wrl");
    std::size_t boxes = 0;
    for (std::size_t at = scene_of_boxes.find("Box {"); at != std::string::npos;
         at = scene_of_boxes.find("Box {", at + 1))
      ++boxes;
    EXPECT_EQ(boxes, tree->getNumLeafNodes());
  }
}

TEST_F(OctomapToolsTest, FindNoDifferenceToATreeThatOctomapMade) {
  const Scene scene = SceneOfEverything(4);
  const OctreeData data = BuildBinaryData(scene, {0.5, 1.0}, Progress()).value();
  Write("ours.bt", BinaryFile(data, 0.5));
  ASSERT_EQ(Run(LATTICEWORLD_CONVERT_OCTREE, "ours.bt ours.ot"), 0);
  // Voxel by voxel, as octomap does it.
  octomap::OcTree theirs(0.5);
  for (const VoxelKey& key : VoxelsOf(*BuildOctree(scene, {0.5, 1.0}, Progress()).value())) {
    theirs.setNodeValue(octomap::OcTreeKey(static_cast<octomap::key_type>(key[0]),
                                           static_cast<octomap::key_type>(key[1]),
                                           static_cast<octomap::key_type>(key[2])),
                        theirs.getClampingThresMaxLog());
  }
  theirs.prune();
  ASSERT_TRUE(theirs.write(PathOf("theirs.ot").string()));
  ASSERT_EQ(Run(LATTICEWORLD_COMPARE_OCTREES, "ours.ot theirs.ot"), 0) << Read("log.txt");
  EXPECT_NE(Read("log.txt").find("KLD: 0\n"), std::string::npos) << Read("log.txt");
  ASSERT_TRUE(theirs.writeBinary(PathOf("theirs.bt").string()));
  EXPECT_EQ(Read("ours.bt"), Read("theirs.bt"));
}

}  // namespace
}  // namespace latticeworld
