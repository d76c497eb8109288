#include "server/tls/authority.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/x509_vfy.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>

#include <fstream>
#include <memory>

#include "server/tls/network_names.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

using testing::MatchesRegex;

constexpr std::int64_t kBegin = 1'800'000'000, kDay = 86'400;  // [s] since 1970

struct FreeCertificate {
  void operator()(X509* held) const { X509_free(held); }
};
using Certificate = std::unique_ptr<X509, FreeCertificate>;

// The certificates of a PEM text, in order.
std::vector<Certificate> certificates_in(const std::string& pem) {
  BIO* bio = BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size()));
  std::vector<Certificate> all;
  while (X509* next = PEM_read_bio_X509(bio, nullptr, nullptr, nullptr)) all.emplace_back(next);
  BIO_free(bio);
  return all;
}

// Whether who trusts the authority takes this server for `name` at that time, as a browser decides it.
bool is_trusted(const ServerCertificate& server, const std::string& authority, const std::string& name,
                std::int64_t time) {
  const auto chain = certificates_in(server.chain), trusted = certificates_in(authority);
  X509_STORE* store = X509_STORE_new();
  X509_STORE_add_cert(store, trusted.at(0).get());
  X509_STORE_CTX* context = X509_STORE_CTX_new();
  X509_STORE_CTX_init(context, store, chain.at(0).get(), nullptr);
  X509_VERIFY_PARAM* wanted = X509_STORE_CTX_get0_param(context);
  X509_VERIFY_PARAM_set_time(wanted, time);
  X509_VERIFY_PARAM_set_purpose(wanted, X509_PURPOSE_SSL_SERVER);
  if (X509_VERIFY_PARAM_set1_ip_asc(wanted, name.c_str()) != 1) X509_VERIFY_PARAM_set1_host(wanted, name.c_str(), 0);
  const bool good = X509_verify_cert(context) == 1;
  X509_STORE_CTX_free(context);
  X509_STORE_free(store);
  return good;
}

struct AuthorityTest : testing::Test {
  Authority open(std::int64_t now = kBegin) { return Authority::open(place.file("tls"), now).value(); }
  TemporaryFolder place;
  const std::vector<std::string> names = {"192.168.1.20", "10.1.2.3", "cell-7.local", "localhost"};
};

TEST_F(AuthorityTest, IsMadeOnce) {
  const Authority first = open();
  EXPECT_THAT(first.fingerprint(), MatchesRegex("([0-9A-F][0-9A-F]:){31}[0-9A-F][0-9A-F]"));
  EXPECT_EQ(open(kBegin + 100).certificate(), first.certificate());
  EXPECT_EQ(open().fingerprint(), first.fingerprint());
}

TEST_F(AuthorityTest, SignsForAddressesAndNamesOfTheNetworkAndNoOthers) {
  const Authority authority = open();
  const ServerCertificate server = authority.certificate_for(names, kBegin).value();
  for (const std::string& name : names) EXPECT_TRUE(is_trusted(server, authority.certificate(), name, kBegin)) << name;
  for (const char* other : {"192.168.1.21", "cell-8.local", "example.org", "8.8.8.8"})
    EXPECT_FALSE(is_trusted(server, authority.certificate(), other, kBegin)) << other;
  TemporaryFolder elsewhere;
  const Authority stranger = Authority::open(elsewhere.file("tls"), kBegin).value();
  EXPECT_FALSE(is_trusted(server, stranger.certificate(), names[0], kBegin));
}

TEST_F(AuthorityTest, RefusesNamesOfTheWholeWorld) {
  const Authority authority = open();
  for (const char* name : {"8.8.8.8", "example.org", "cell", "2001:db8::1", ""}) {
    const auto refused = authority.certificate_for({"10.0.0.1", name}, kBegin);
    ASSERT_FALSE(refused) << name;
    EXPECT_EQ(refused.error().code, ErrorCode::out_of_range);
    EXPECT_EQ(refused.error().path, name);
  }
}

// Whoever has the key could sign for any site; who trusts the authority does not trust that.
TEST_F(AuthorityTest, ItsConstraintsHoldForWhoeverHasItsKey) {
  const Authority authority = open();
  const auto own = certificates_in(authority.certificate());
  EXPECT_GE(X509_get_ext_by_NID(own.at(0).get(), NID_name_constraints, -1), 0);
  EXPECT_EQ(X509_EXTENSION_get_critical(
                X509_get_ext(own.at(0).get(), X509_get_ext_by_NID(own.at(0).get(), NID_name_constraints, -1))),
            1);
}

TEST_F(AuthorityTest, ACertificateIsKeptUntilItDoesNotFitOrIsOld) {
  const Authority authority = open();
  const std::string first = authority.certificate_for(names, kBegin)->chain;
  EXPECT_EQ(authority.certificate_for(names, kBegin + 300 * kDay)->chain, first);
  EXPECT_EQ(authority.certificate_for({names[1]}, kBegin)->chain, first) << "for fewer names";
  const ServerCertificate renewed = authority.certificate_for(names, kBegin + 370 * kDay).value();
  EXPECT_NE(renewed.chain, first);
  EXPECT_TRUE(is_trusted(renewed, authority.certificate(), names[0], kBegin + 700 * kDay));
  EXPECT_FALSE(is_trusted(renewed, authority.certificate(), names[0], kBegin + 800 * kDay));
  EXPECT_NE(authority.certificate_for({"10.9.9.9"}, kBegin + 370 * kDay)->chain, renewed.chain) << "for another name";
}

TEST_F(AuthorityTest, KeysAreForTheirOwnerAlone) {
  open().certificate_for(names, kBegin).value();
  for (const char* file : {"tls/ca.key", "tls/server.key"}) {
    struct stat known {};
    ASSERT_EQ(::stat(place.file(file).c_str(), &known), 0);
    EXPECT_EQ(known.st_mode & 0777U, 0600U) << file;
  }
  ASSERT_EQ(::chmod(place.file("tls/ca.key").c_str(), 0644), 0);
  EXPECT_EQ(Authority::open(place.file("tls"), kBegin).error().code, ErrorCode::not_accepted);
}

TEST_F(AuthorityTest, WhatIsNoCertificateIsDamaged) {
  open();
  std::ofstream(place.file("tls/ca.pem")) << "nothing";
  const auto opened = Authority::open(place.file("tls"), kBegin);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::corrupt);
}

TEST(NetworkNames, AreNamesThatAnAuthoritySignsFor) {
  for (const std::string& name : network_names()) EXPECT_TRUE(is_local_name(name)) << name;
}

TEST(NetworkNames, PrivateIsWhatTheStandardsSay) {
  for (const char* name : {"10.0.0.0", "10.255.255.255", "172.16.0.1", "172.31.255.255", "192.168.0.1", "169.254.1.1",
                           "127.0.0.1", "::1", "fd00::1", "fe80::1", "febf::1", "localhost", "a.local", "a.b.local"})
    EXPECT_TRUE(is_local_name(name)) << name;
  for (const char* name : {"9.255.255.255", "11.0.0.0", "172.15.0.1", "172.32.0.1", "192.167.1.1", "8.8.8.8", "fec0::1",
                           "2001:db8::1", "local", "alocal", "a.locale", ""})
    EXPECT_FALSE(is_local_name(name)) << name;
}

}  // namespace
}  // namespace race::server
