#include "latticeworld/viewer/server/access.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(AccessTest, KnowsTheMachineItselfByItsNames) {
  for (const char* host :
       {"localhost", "LOCALHOST:80", "127.0.0.1", "127.1.2.3:8080", "[::1]:80"}) {
    EXPECT_TRUE(IsLoopbackHost(host)) << host;
  }
  for (const char* host : {"", "127.0.0.1.evil.example", "localhost.evil.example", "127.evil",
                           "192.168.1.2", "[::2]", "[::1"}) {
    EXPECT_FALSE(IsLoopbackHost(host)) << host;
  }
}

TEST(AccessTest, TakesAddressesAndTheNamesItWasGiven) {
  AccessOptions options;
  options.allowed_hosts = {"World.example"};
  for (const char* host :
       {"192.168.1.2:8080", "[fe80::1]:80", "world.example", "world.EXAMPLE:1"}) {
    EXPECT_TRUE(CheckHost(host, options).ok()) << host;
  }
  for (const char* host : {"", "evil.example", "world.example.evil", "1.2.3.4.5"}) {
    EXPECT_EQ(CheckHost(host, options).code(), StatusCode::kPermissionDenied) << host;
  }
}

TEST(AccessTest, APageIsOfTheHostThatItCalls) {
  EXPECT_TRUE(CheckOrigin("", "a:80").ok());  // no browser
  EXPECT_TRUE(CheckOrigin("http://a:80", "A:80").ok());
  EXPECT_TRUE(CheckOrigin("https://a", "a").ok());
  EXPECT_FALSE(CheckOrigin("http://b:80", "a:80").ok());
  EXPECT_FALSE(CheckOrigin("http://a:81", "a:80").ok());
  EXPECT_FALSE(CheckOrigin("file://a:80", "a:80").ok());
}

TEST(AccessTest, WhoSitsAtTheMachineMayControlUnlessItTakesAToken) {
  AccessOptions options;
  const ClientFacts here = {true, false, "localhost:8080", ""};
  EXPECT_TRUE(MayControl(here, options));
  ClientFacts elsewhere = here;
  elsewhere.from_loopback = false;
  EXPECT_FALSE(MayControl(elsewhere, options));
  ClientFacts through_proxy = here;
  through_proxy.forwarded = true;
  EXPECT_FALSE(MayControl(through_proxy, options));
  ClientFacts by_name = here;  // as a proxy that says nothing of itself
  by_name.host = "world.example";
  EXPECT_FALSE(MayControl(by_name, options));
  options.require_token = true;
  EXPECT_FALSE(MayControl(here, options));
}

TEST(AccessTest, OnlyTheTokenIsTheToken) {
  AccessOptions options;
  EXPECT_FALSE(IsToken("", options));  // without a token nobody has the right one
  options.token = "secret";
  EXPECT_TRUE(IsToken("secret", options));
  for (const char* given : {"", "secre", "secrets", "SECRET", "secret\n"}) {
    EXPECT_FALSE(IsToken(given, options)) << given;
  }
}

}  // namespace
}  // namespace latticeworld
