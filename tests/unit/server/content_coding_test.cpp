#include "server/http/content_coding.h"

#include <gtest/gtest.h>

#include <array>

namespace race::server {
namespace {

using Lines = std::vector<std::string>;

// What is chosen of all three codings for a request with these lines of Accept-Encoding; "none" if nothing is.
std::string chosen(const Lines& lines, std::span<const std::string_view> codings) {
  Request request;
  for (const std::string& line : lines) request.headers.emplace_back("accept-encoding", line);
  return std::string(choose_coding(request, codings).value_or("none"));
}

std::string chosen(const Lines& lines) {
  static constexpr std::array<std::string_view, 3> kAll = {"br", "gzip", "identity"};
  return chosen(lines, kAll);
}

std::string chosen_uncompressed(const Lines& lines) {
  static constexpr std::array<std::string_view, 1> kIdentity = {"identity"};
  return chosen(lines, kIdentity);
}

TEST(ContentCoding, IsIdentityForAClientThatNamesNone) {
  EXPECT_EQ(chosen({}), "identity");
  EXPECT_EQ(chosen({""}), "identity");
  EXPECT_EQ(chosen({"deflate, zstd"}), "identity");
}

TEST(ContentCoding, IsTheOneOfTheGreatestWeight) {
  EXPECT_EQ(chosen({"gzip;q=0.5, br;q=0.4"}), "gzip");
  EXPECT_EQ(chosen({"br;q=0.998, gzip;q=0.999"}), "gzip");
  EXPECT_EQ(chosen({"gzip, br;q=0.9, identity;q=0.95"}), "gzip");
  EXPECT_EQ(chosen({"identity, br;q=0.9"}), "identity");
}

TEST(ContentCoding, IsTheServersPreferenceAtEqualWeights) {
  EXPECT_EQ(chosen({"gzip, deflate, br, zstd"}), "br");
  EXPECT_EQ(chosen({"identity, gzip"}), "gzip");
  EXPECT_EQ(chosen({"identity;q=1.0, br;q=1.000"}), "br");
}

TEST(ContentCoding, IsIdentityOnlyAsTheLastResortIfItIsNotNamed) {
  EXPECT_EQ(chosen({"gzip;q=0.001"}), "gzip");
  EXPECT_EQ(chosen({"gzip;q=0, br;q=0"}), "identity");
  EXPECT_EQ(chosen_uncompressed({"gzip, br"}), "identity");
}

TEST(ContentCoding, HasTheWeightOfTheAsteriskIfItIsNotNamed) {
  EXPECT_EQ(chosen({"*"}), "br");
  EXPECT_EQ(chosen({"br;q=0, *"}), "gzip");
  EXPECT_EQ(chosen({"identity, *;q=0.5"}), "identity");
  EXPECT_EQ(chosen({"gzip, *;q=0"}), "gzip");
}

TEST(ContentCoding, IsNoneIfWhatThereIsIsExcluded) {
  EXPECT_EQ(chosen({"identity;q=0"}), "none");
  EXPECT_EQ(chosen({"*;q=0"}), "none");
  EXPECT_EQ(chosen_uncompressed({"gzip, identity;q=0"}), "none");
  EXPECT_EQ(chosen_uncompressed({"gzip, *;q=0.000"}), "none");
  EXPECT_EQ(chosen_uncompressed({"*;q=0, identity;q=0.1"}), "identity");
}

TEST(ContentCoding, IsNamedInAnyCaseAndOnSeveralLines) {
  EXPECT_EQ(chosen({"GZip"}), "gzip");
  EXPECT_EQ(chosen({"x-gzip"}), "gzip");
  EXPECT_EQ(chosen({"gzip ; Q=0.1 ,\tbr\t;\tq=0.2"}), "br");
  EXPECT_EQ(chosen({"gzip;q=0.1", ", br;q=0.2,"}), "br");
}

TEST(ContentCoding, IsNotTakenFromWhatHasNoValidForm) {
  for (const char* element : {"gzip;q=", "gzip;q=2", "gzip;q=1.001", "gzip;q=-1", "gzip;q=0.1234", "gzip;q=.5",
                              "gzip;q=0x1", "gzip;level=9", "gzip;", ";q=1", "q=1", ",,;,"})
    EXPECT_EQ(chosen({element}), "identity") << element;
  EXPECT_EQ(chosen({"br;q=high, gzip;q=0.1"}), "gzip");
}

}  // namespace
}  // namespace race::server
