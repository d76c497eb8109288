#include "server/http/static_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

using Headers = std::vector<std::pair<std::string, std::string>>;

// An answer's header; empty if it is absent.
std::string header(const std::optional<Reply>& reply, const std::string& name) {
  for (const auto& [field, value] : reply->headers)
    if (field == name) return value;
  return "";
}

struct StaticFiles : testing::Test {
  StaticFiles() {
    fs::create_directories(folder / "web" / "assets");
    write("web/index.html", "<p>");
    write("web/assets/a-1f.js", "1;");
    write("web/assets/b-2f.js", "2;");
    write("web/assets/b-2f.js.gz", "2 by gzip");
    write("web/assets/b-2f.js.br", "2 by brotli");
    write("secret.txt", "s");
    fs::create_symlink(folder / "secret.txt", folder / "web" / "link.txt");
  }
  void write(const char* name, const char* text) { std::ofstream(folder / name) << text; }
  std::optional<Reply> get(const std::string& path, Headers headers = {}) {
    Request request;
    request.method = "GET";
    request.path = path;
    request.headers = std::move(headers);
    return static_file(folder / "web", request);
  }

  const TemporaryFolder place;
  const fs::path folder = place.path;
};

TEST_F(StaticFiles, AreServedWithTheirTypes) {
  ASSERT_TRUE(get("/"));
  EXPECT_EQ(get("/")->text, "<p>");
  EXPECT_EQ(get("/")->type, "text/html; charset=utf-8");
  EXPECT_EQ(header(get("/"), "Cache-Control"), "no-cache");
  EXPECT_EQ(get("/assets/a-1f.js")->type, "text/javascript; charset=utf-8");
  EXPECT_EQ(header(get("/assets/a-1f.js"), "Cache-Control"), "public, max-age=31536000, immutable");
}

TEST_F(StaticFiles, EndAtTheirFolder) {
  for (const char* path :
       {"/../secret.txt", "/assets/../../secret.txt", "/link.txt", "//etc/passwd", "/nothing", "/assets", "/.."})
    EXPECT_FALSE(get(path)) << path;
  Request request;
  request.path = "/etc/passwd";
  EXPECT_FALSE(static_file("", request));
  request.path = "/";
  EXPECT_FALSE(static_file("/nowhere", request));
}

TEST_F(StaticFiles, AreSentInTheCodingThatTheClientPrefers) {
  const auto answer = get("/assets/b-2f.js", {{"accept-encoding", "gzip, deflate, br"}});
  EXPECT_EQ(answer->text, "2 by brotli");
  EXPECT_EQ(header(answer, "Content-Encoding"), "br");
  EXPECT_EQ(answer->type, "text/javascript; charset=utf-8");
  EXPECT_EQ(header(answer, "Cache-Control"), "public, max-age=31536000, immutable");
  EXPECT_EQ(get("/assets/b-2f.js", {{"accept-encoding", "br;q=0.5, gzip"}})->text, "2 by gzip");
  EXPECT_EQ(get("/assets/b-2f.js", {{"accept-encoding", "identity, br;q=0.5"}})->text, "2;");
}

TEST_F(StaticFiles, AreSentAsTheyAreWithoutACompressedCopyOrAWishForOne) {
  for (const auto& answer : {get("/assets/a-1f.js", {{"accept-encoding", "br, gzip"}}), get("/assets/a-1f.js")}) {
    EXPECT_EQ(answer->text, "1;");
    EXPECT_EQ(header(answer, "Content-Encoding"), "");
  }
  EXPECT_EQ(get("/assets/b-2f.js")->text, "2;");
  EXPECT_EQ(header(get("/assets/b-2f.js"), "Content-Encoding"), "");
}

TEST_F(StaticFiles, AreRefusedIfNoCodingIsAcceptable) {
  const auto answer = get("/assets/a-1f.js", {{"accept-encoding", "gzip, identity;q=0"}});
  EXPECT_EQ(answer->status, 406);
  EXPECT_EQ(header(answer, "ETag"), "");
  EXPECT_EQ(get("/assets/b-2f.js", {{"accept-encoding", "gzip, identity;q=0"}})->text, "2 by gzip");
}

TEST_F(StaticFiles, AlwaysVaryByTheCodingsOfTheRequest) {
  for (const char* accepted : {"gzip", "identity", "identity;q=0"})
    for (const char* path : {"/", "/assets/b-2f.js"})
      EXPECT_EQ(header(get(path, {{"accept-encoding", accepted}}), "Vary"), "Accept-Encoding") << path << accepted;
}

TEST_F(StaticFiles, HaveAStrongTagForEachCodingThatFollowsTheContent) {
  std::set<std::string> tags;
  for (const char* accepted : {"gzip", "br", "identity"})
    tags.insert(header(get("/assets/b-2f.js", {{"accept-encoding", accepted}}), "ETag"));
  tags.insert(header(get("/"), "ETag"));
  write("web/index.html", "<p>changed");
  tags.insert(header(get("/"), "ETag"));
  EXPECT_EQ(tags.size(), 5U);
  for (const std::string& tag : tags) EXPECT_TRUE(tag.starts_with('"') && tag.ends_with('"') && tag.size() > 2) << tag;
}

TEST_F(StaticFiles, AreNotSentAgainToAClientThatHasThem) {
  const std::string tag = header(get("/assets/b-2f.js", {{"accept-encoding", "br"}}), "ETag");
  for (const std::string& known : {tag, "W/" + tag, "\"a,b\" , " + tag, std::string("*")}) {
    const auto answer = get("/assets/b-2f.js", {{"accept-encoding", "br"}, {"if-none-match", known}});
    EXPECT_EQ(answer->status, 304) << known;
    EXPECT_EQ(answer->text, "");
    EXPECT_EQ(header(answer, "ETag"), tag);
    EXPECT_EQ(header(answer, "Vary"), "Accept-Encoding");
    EXPECT_EQ(header(answer, "Cache-Control"), "public, max-age=31536000, immutable");
  }
  for (const std::string& known : {std::string("\"other\""), tag.substr(1), std::string()})
    EXPECT_EQ(get("/assets/b-2f.js", {{"accept-encoding", "br"}, {"if-none-match", known}})->status, 200) << known;
  EXPECT_EQ(get("/assets/b-2f.js", {{"accept-encoding", "gzip"}, {"if-none-match", tag}})->status, 200)
      << "the tag of another coding";
}

TEST_F(StaticFiles, HideTheirCompressedCopies) {
  fs::create_symlink(folder / "web/assets/b-2f.js.gz", folder / "web/other.js");
  for (const char* path : {"/assets/b-2f.js.gz", "/assets/b-2f.js.br", "/other.js"})
    EXPECT_FALSE(get(path, {{"accept-encoding", "gzip, br"}})) << path;
}

TEST_F(StaticFiles, HaveNoCompressedCopiesOutsideOfTheirFolder) {
  fs::create_symlink(folder / "secret.txt", folder / "web/assets/a-1f.js.gz");
  fs::create_directory(folder / "web/assets/a-1f.js.br");
  EXPECT_EQ(get("/assets/a-1f.js", {{"accept-encoding", "gzip, br"}})->text, "1;");
}

}  // namespace
}  // namespace race::server
