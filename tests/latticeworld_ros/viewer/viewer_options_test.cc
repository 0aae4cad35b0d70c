#include "latticeworld_ros/viewer/viewer_options.h"

#include <gtest/gtest.h>
#include <stdlib.h>

namespace latticeworld {
namespace {

TEST(ViewerOptionsTest, WithoutParametersThereAreTheDefaults) {
  const auto options = ViewerOptionsFromParameters(XmlRpc::XmlRpcValue());
  ASSERT_TRUE(options.ok()) << options.status().ToString();
  EXPECT_EQ(options->server.host, "127.0.0.1");
  EXPECT_EQ(options->server.port, 8080);
  EXPECT_EQ(options->state_rate_hz, 20.0);
}

TEST(ViewerOptionsTest, EverythingThatIsWrongIsNamed) {
  XmlRpc::XmlRpcValue parameters;
  parameters["hots"] = "127.0.0.1";
  parameters["host"] = "a name";
  parameters["port"] = -1;
  parameters["state_rate"] = 1000.0;
  parameters["allowed_hosts"] = "one";
  const auto options = ViewerOptionsFromParameters(parameters);
  ASSERT_FALSE(options.ok());
  EXPECT_EQ(options.status().violations().size(), 5u) << options.status().ToString();
}

TEST(ViewerOptionsTest, TheTokenIsTheVariablesAndNeverSaid) {
  XmlRpc::XmlRpcValue parameters;
  parameters["token_variable"] = "LATTICEWORLD_TEST_TOKEN";
  parameters["require_token"] = true;
  ::unsetenv("LATTICEWORLD_TEST_TOKEN");
  EXPECT_FALSE(ViewerOptionsFromParameters(parameters).ok());
  ::setenv("LATTICEWORLD_TEST_TOKEN", "secret", 1);
  const auto refused = ViewerOptionsFromParameters(parameters);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().ToString().find("secret"), std::string::npos);
  ::setenv("LATTICEWORLD_TEST_TOKEN", "long enough", 1);
  const auto options = ViewerOptionsFromParameters(parameters);
  ASSERT_TRUE(options.ok()) << options.status().ToString();
  EXPECT_EQ(options->server.access.token, "long enough");
  ::unsetenv("LATTICEWORLD_TEST_TOKEN");
}

}  // namespace
}  // namespace latticeworld
