#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

class PictureCommandTest : public ProgramTest {
 protected:
  PictureCommandTest() {
    const ProgramRun run =
        RunProgram({"generate", "--layout", "Grassland everywhere.", "--seed", "3", "--size", "64",
                    "--resolution", "1", "--out", PathOf("plain")});
    EXPECT_EQ(run.exit_status, 0) << run.err;
  }

  ProgramRun Picture(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"picture",       PathOf("plain"), "--out",
                                          PathOf("p.png"), "--width",       "96"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunProgram(arguments);
  }
};

TEST_F(PictureCommandTest, QuickPicturesAreOthers) {
  ASSERT_EQ(Picture({"--view", "oblique"}).exit_status, 0);
  const std::string fine = Read("p.png");
  ASSERT_EQ(Picture({"--view", "oblique", "--quick"}).exit_status, 0);
  EXPECT_NE(Read("p.png"), fine);
}

TEST_F(PictureCommandTest, UnusableViewsAreNamedAsTheyWereAskedFor) {
  const ProgramRun run =
      Picture({"--view", "close", "--at", "40,0", "--pitch", "90", "--eye", "0.01"});
  EXPECT_EQ(run.exit_status, 2);
  for (const char* word : {"--at x", "40", "--pitch", "90", "-80", "deg", "--eye", "0.01"})
    EXPECT_NE(run.err.find(word), std::string::npos) << word << " | " << run.err;
  for (const char* word : {"rad", "eye_height", "position"})
    EXPECT_EQ(run.err.find(word), std::string::npos) << word << " | " << run.err;
  const ProgramRun outside =
      RunProgram({"picture", PathOf("plain"), "--out", PathOf("p.png"), "--view", "close", "--at",
                  "40,0", "--eye", "0.01", "--width", "8"});
  EXPECT_EQ(outside.exit_status, 2);
  for (const char* word : {"--width", "4096", "--at x", "--eye"})
    EXPECT_NE(outside.err.find(word), std::string::npos) << word << " | " << outside.err;
}

TEST_F(PictureCommandTest, OnlyViewsThatCanBeAskedForAreOffered) {
  const ProgramRun run = Picture({"--view", "street"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.err.find("no place for --view street"), std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("middle"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace latticeworld
