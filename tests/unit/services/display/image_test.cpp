#include "services/display/image.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace race::display {
namespace {

namespace fs = std::filesystem;

struct ImageTest : testing::Test {
  ImageTest() {
    std::string name = (fs::temp_directory_path() / "race-image-XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~ImageTest() override { fs::remove_all(folder); }
  void write(const std::string& name, const std::string& bytes) { std::ofstream(folder / name) << bytes; }
  ErrorCode refused(const std::string& image) { return image_url(image, folder).error().code; }
  fs::path folder;
};

TEST_F(ImageTest, ADataUrlStaysAsItIs) {
  for (const char* url :
       {"data:image/png;base64,AAAA", "data:image/svg+xml;base64,PHN2Zy8+", "data:image/gif;base64,QQ=="})
    EXPECT_EQ(image_url(url, "").value(), url);
}

TEST_F(ImageTest, OnlyImagesInBase64AreDataUrls) {
  for (const char* url : {"data:text/html;base64,AAAA", "data:image/png;base64,", "data:image/png;base64,AAA",
                          "data:image/png;base64,AA\"A", "data:image/png,AAAA", "data:"})
    EXPECT_EQ(refused(url), ErrorCode::type) << url;
}

TEST_F(ImageTest, AFileOfTheCellBecomesADataUrl) {
  write("dot.png", "Man");
  EXPECT_EQ(image_url("dot.png", folder).value(), "data:image/png;base64,TWFu");
  write("dot.jpg", "Ma");
  EXPECT_EQ(image_url("dot.jpg", folder).value(), "data:image/jpeg;base64,TWE=");
  write("dot.svg", "M");
  EXPECT_EQ(image_url("dot.svg", folder).value(), "data:image/svg+xml;base64,TQ==");
}

TEST_F(ImageTest, AFileThatTheDiskDoesNotGiveIsRefused) {
  fs::create_symlink("/proc/self/mem", folder / "broken.png");  // reading it is EIO
  EXPECT_EQ(refused("broken.png"), ErrorCode::io);
}

TEST_F(ImageTest, NothingButImagesOfTheFolderCanBeShown) {
  write("scene.json", "{}");
  fs::create_directory(folder / "folder.png");
  EXPECT_EQ(refused("scene.json"), ErrorCode::type);
  EXPECT_EQ(refused("../dot.png"), ErrorCode::type);
  EXPECT_EQ(refused("/etc/dot.png"), ErrorCode::type);
  EXPECT_EQ(refused(".png"), ErrorCode::type);
  EXPECT_EQ(refused("http://x/y.png"), ErrorCode::type);
  EXPECT_EQ(refused("none.png"), ErrorCode::not_found);
  EXPECT_EQ(refused("folder.png"), ErrorCode::not_found);
  EXPECT_EQ(image_url("dot.png", "").error().code, ErrorCode::not_found);
}

TEST_F(ImageTest, TheSizeIsBounded) {
  write("large.png", std::string(kImageCharacters, 'x'));
  EXPECT_EQ(refused("large.png"), ErrorCode::too_large);
  EXPECT_EQ(refused("data:image/png;base64," + std::string(kImageCharacters, 'A')), ErrorCode::too_large);
  write("fits.png", std::string(kImageCharacters / 4 * 3 - 20, 'x'));
  EXPECT_TRUE(image_url("fits.png", folder));
}

}  // namespace
}  // namespace race::display
