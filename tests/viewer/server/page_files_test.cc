#include "latticeworld/viewer/server/page_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "generation/test_world.h"
#include "latticeworld/viewer/server/http_answer.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

void Write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

TEST(PageFilesTest, ReadsWhatBelongsToThePageAndNothingElse) {
  const TemporaryDirectory directory;
  Write(directory.path() / "page" / "index.html", "<p>");
  Write(directory.path() / "page" / "assets" / "app.js", std::string(5000, 'a'));
  Write(directory.path() / "page" / ".git" / "config", "hidden");
  Write(directory.path() / "secret", "secret");
  fs::create_symlink(directory.path() / "secret", directory.path() / "page" / "link.txt");
  fs::create_directory_symlink(directory.path(), directory.path() / "page" / "up");
  const auto page = ReadPage(directory.path() / "page");
  ASSERT_TRUE(page.ok()) << page.status().ToString();
  ASSERT_EQ(page->size(), 3u);
  EXPECT_EQ(page->at("/").bytes, "<p>");
  EXPECT_EQ(page->at("/index.html").content_type, "text/html; charset=utf-8");
  EXPECT_EQ(page->at("/assets/app.js").content_type, "text/javascript; charset=utf-8");
  EXPECT_LT(page->at("/assets/app.js").gzip.size(), 100u);
}

TEST(PageFilesTest, WhereThereIsNoneSaysSo) {
  const TemporaryDirectory directory;
  EXPECT_EQ(ReadPage(directory.path()).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(ReadPage(directory.path() / "none").status().code(), StatusCode::kNotFound);
  const PayloadMap page = PageMissing("no <page>");
  EXPECT_NE(page.at("/").bytes.find("no &lt;page&gt;"), std::string::npos);
}

TEST(HttpAnswerTest, CodesOnlyForWhoTakesItAndOnlyWhatShrinks) {
  auto page = std::make_shared<PayloadMap>();
  page->emplace("/long.js", MakePayload("text/javascript", std::string(5000, 'a'), true));
  page->emplace("/short.js", MakePayload("text/javascript", "a", true));
  const auto is_coded = [&page](const std::string& target, const std::string& accept) {
    return AnswerHttp({"GET", target, "", accept}, page, nullptr).is_gzip;
  };
  EXPECT_TRUE(is_coded("/long.js", "gzip"));
  EXPECT_TRUE(is_coded("/long.js", "br;q=1.0, GZIP;q=0.5"));
  EXPECT_FALSE(is_coded("/long.js", ""));
  EXPECT_FALSE(is_coded("/long.js", "br, deflate"));
  EXPECT_FALSE(is_coded("/long.js", "gzip;q=0"));
  EXPECT_FALSE(is_coded("/short.js", "gzip"));
}

}  // namespace
}  // namespace latticeworld
