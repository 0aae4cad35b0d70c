#include "latticeworld_ros/episode/server_watch.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <string>

namespace latticeworld {
namespace {

class ServerWatchTest : public testing::Test {
 protected:
  // The first message of a connection.
  static BagMessage OfNewConnection() {
    BagMessage message;
    message.header = boost::make_shared<ros::M_string>();
    return message;
  }

  std::string address_ = "host:1";
  ServerWatch watch_{[this] { return address_; }};
};

TEST_F(ServerWatchTest, ANewConnectionToTheSameServerIsAccepted) {
  ASSERT_TRUE(watch_.Close());
  EXPECT_TRUE(watch_.Accepts(OfNewConnection()));
  EXPECT_TRUE(watch_.IsSame());
}

TEST_F(ServerWatchTest, NothingIsAcceptedOnceAnotherServerSpeaks) {
  const BagMessage first = OfNewConnection();
  EXPECT_TRUE(watch_.Accepts(first));
  ASSERT_TRUE(watch_.Close());
  address_ = "host:2";
  EXPECT_TRUE(watch_.Accepts(first)) << "what the first one still had on its way";
  EXPECT_FALSE(watch_.Accepts(OfNewConnection()));
  EXPECT_FALSE(watch_.Accepts(first));
  EXPECT_FALSE(watch_.IsSame());
  address_ = "host:1";
  EXPECT_FALSE(watch_.IsSame());
}

TEST_F(ServerWatchTest, AServerThatEndedHasNotBeenReplaced) {
  ASSERT_TRUE(watch_.Close());
  address_.clear();
  EXPECT_TRUE(watch_.Accepts(OfNewConnection()));
  EXPECT_TRUE(watch_.IsSame());
}

TEST_F(ServerWatchTest, AReplacementBeforeTheBeginIsToldWhenItCloses) {
  address_ = "host:2";
  EXPECT_TRUE(watch_.Accepts(OfNewConnection()));
  EXPECT_FALSE(watch_.Close());
}

}  // namespace
}  // namespace latticeworld
