#include <gtest/gtest.h>

#include "tools/run_program.h"

namespace latticeworld {
namespace {

class ViewCommandTest : public ProgramTest {};

TEST_F(ViewCommandTest, UnusableArgumentsAreAllNamed) {
  const ProgramRun run =
      RunProgram({"view", PathOf("none"), "--port", "99999", "--host", "somewhere"});
  EXPECT_EQ(run.exit_status, 2);
  for (const char* word : {"--port", "99999", "65535", "--host", "somewhere"})
    EXPECT_NE(run.err.find(word), std::string::npos) << word << " | " << run.err;
  EXPECT_EQ(RunProgram({"view"}).exit_status, 2);
}

TEST_F(ViewCommandTest, WhatIsNoBundleOrNoPageIsAFailureThatNamesIt) {
  const ProgramRun no_bundle = RunProgram({"view", PathOf("none"), "--port", "0"});
  EXPECT_EQ(no_bundle.exit_status, 1);
  EXPECT_NE(no_bundle.err.find("none"), std::string::npos) << no_bundle.err;
  const ProgramRun no_page =
      RunProgram({"view", PathOf("none"), "--port", "0", "--page", PathOf("page")});
  EXPECT_EQ(no_page.exit_status, 1);
  EXPECT_NE(no_page.err.find("page"), std::string::npos) << no_page.err;
}

}  // namespace
}  // namespace latticeworld
