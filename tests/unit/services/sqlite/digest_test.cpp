#include "services/sqlite/digest.h"

#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "tests/unit/temporary_folder.h"

namespace race::sqlite {
namespace {

// FIPS 180-4, examples of the Secure Hash Standard (NIST CSRC, SHA256.pdf); the empty message: NIST CAVP.
TEST(Sha256, GivesTheKnownAnswers) {
  EXPECT_EQ(hex(sha256("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hex(sha256("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hex(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, OfFieldsIsThatOfTheirLengthsAndBytes) {
  using namespace std::string_literals;
  EXPECT_EQ(sha256_of({"ab", ""}), sha256("\2\0\0\0\0\0\0\0ab\0\0\0\0\0\0\0\0"s));
  EXPECT_EQ(sha256_of({}), sha256(""));
}

TEST(Sha256, OfFieldsTellsWhereOneEnds) {
  EXPECT_NE(sha256_of({"ab", "c"}), sha256_of({"a", "bc"}));
  EXPECT_NE(sha256_of({"a"}), sha256_of({"a", ""}));
  EXPECT_NE(sha256_of({}), sha256_of({""}));
}

TEST(Sha256, OfAFileIsThatOfItsContent) {
  const TemporaryFolder folder;
  const std::string text(200'000, 'a');
  std::ofstream(folder.file("text")) << text;
  std::vector<std::uint64_t> read;
  EXPECT_EQ(sha256_of_file(folder.file("text"), [&](std::uint64_t bytes) { read.push_back(bytes); }).value(),
            sha256(text));
  EXPECT_EQ(read, (std::vector<std::uint64_t>{65'536, 131'072, 196'608, 200'000}));
  EXPECT_EQ(sha256_of_file(folder.file("other")).error().code, ErrorCode::io);
}

TEST(Sha256, IsABlobOf32Bytes) {
  const Digest digest = sha256("abc");
  EXPECT_EQ(bytes(digest).size(), 32U);
  EXPECT_EQ(bytes(digest).substr(0, 2), "\xba\x78");
}

}  // namespace
}  // namespace race::sqlite
