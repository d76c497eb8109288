#include "server/http/static_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace race::server {
namespace {

namespace fs = std::filesystem;

struct StaticFiles : testing::Test {
  StaticFiles() {
    fs::remove_all(folder);
    fs::create_directories(folder / "web" / "assets");
    write("web/index.html", "<p>");
    write("web/assets/a-1f.js", "1;");
    write("secret.txt", "s");
    fs::create_symlink(folder / "secret.txt", folder / "web" / "link.txt");
  }
  ~StaticFiles() override { fs::remove_all(folder); }
  void write(const char* name, const char* text) { std::ofstream(folder / name) << text; }
  std::optional<Reply> get(const std::string& path) { return static_file(folder / "web", path); }
  fs::path folder = fs::path(testing::TempDir()) / "race_static_files_test";
};

TEST_F(StaticFiles, AreServedWithTheirTypes) {
  ASSERT_TRUE(get("/"));
  EXPECT_EQ(get("/")->text, "<p>");
  EXPECT_EQ(get("/")->type, "text/html; charset=utf-8");
  EXPECT_EQ(get("/")->headers[0].second, "no-cache");
  EXPECT_EQ(get("/assets/a-1f.js")->type, "text/javascript; charset=utf-8");
  EXPECT_EQ(get("/assets/a-1f.js")->headers[0].second, "public, max-age=31536000, immutable");
}

TEST_F(StaticFiles, EndAtTheirFolder) {
  for (const char* path :
       {"/../secret.txt", "/assets/../../secret.txt", "/link.txt", "//etc/passwd", "/nothing", "/assets"})
    EXPECT_FALSE(get(path)) << path;
  EXPECT_FALSE(static_file("", "/etc/passwd"));
  EXPECT_FALSE(static_file("/nowhere", "/"));
}

}  // namespace
}  // namespace race::server
