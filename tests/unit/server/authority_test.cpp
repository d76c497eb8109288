#include "server/tls/authority.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/x509_vfy.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <thread>

#include "server/tls/network_names.h"
#include "server/tls/renewal.h"
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

TEST_F(AuthorityTest, SignsForAnAddressAlone) {
  const Authority authority = open();
  const ServerCertificate server = authority.certificate_for({"10.1.2.3"}, kBegin).value();
  EXPECT_TRUE(is_trusted(server, authority.certificate(), "10.1.2.3", kBegin));
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

// What whoever has the key of the authority could sign, as `name`.
std::string signed_with_its_key(const std::string& authority, const std::string& key_file, const std::string& name) {
  const auto issuer = certificates_in(authority);
  FILE* const file = std::fopen(key_file.c_str(), "r");
  EVP_PKEY* const key = PEM_read_PrivateKey(file, nullptr, nullptr, nullptr);
  std::fclose(file);
  const Certificate made(X509_new());
  X509_set_version(made.get(), X509_VERSION_3);
  ASN1_INTEGER_set(X509_get_serialNumber(made.get()), 7);
  ASN1_TIME_set(X509_getm_notBefore(made.get()), kBegin - kDay);
  ASN1_TIME_set(X509_getm_notAfter(made.get()), kBegin + kDay);
  X509_set_issuer_name(made.get(), X509_get_subject_name(issuer.at(0).get()));
  X509_set_pubkey(made.get(), key);
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, issuer.at(0).get(), made.get(), nullptr, nullptr, 0);
  X509_EXTENSION* const names = X509V3_EXT_conf_nid(nullptr, &context, NID_subject_alt_name, name.c_str());
  X509_add_ext(made.get(), names, -1);
  X509_EXTENSION_free(names);
  X509_sign(made.get(), key, EVP_sha256());
  EVP_PKEY_free(key);
  BIO* const bio = BIO_new(BIO_s_mem());
  PEM_write_bio_X509(bio, made.get());
  char* text = nullptr;
  const auto size = BIO_get_mem_data(bio, &text);
  std::string pem(text, static_cast<std::size_t>(size));
  BIO_free(bio);
  return pem;
}

// RFC 5280, 4.2.1.10: whoever had the key could sign for any site; who trusts the authority does not trust that.
TEST_F(AuthorityTest, ItsConstraintsHoldForWhoeverHasItsKey) {
  const Authority authority = open();
  const auto is_taken_for = [&](const std::string& name) {
    const std::string pem =
        signed_with_its_key(authority.certificate(), place.file("tls/ca.key"),
                            (std::isdigit(static_cast<unsigned char>(name[0])) != 0 ? "IP:" : "DNS:") + name);
    return is_trusted({pem, ""}, authority.certificate(), name, kBegin);
  };
  for (const char* name : {"cell-7.local", "localhost", "10.1.2.3", "192.168.1.20"}) EXPECT_TRUE(is_taken_for(name));
  for (const char* name : {"example.org", "bank.example", "local.example", "notlocal", "8.8.8.8", "172.32.0.1"})
    EXPECT_FALSE(is_taken_for(name)) << name;
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

TEST_F(AuthorityTest, ACertificateIsRenewedWhileTheServerRunsAndTheAuthorityStays) {
  const Authority authority = open();
  const ServerCertificate first = authority.certificate_for(names, kBegin).value();
  std::atomic<std::int64_t> now{kBegin};
  services::Mutex mutex;
  std::vector<ServerCertificate> told;
  std::size_t failed = 0;
  const auto wait_for = [&](auto&& is_so) {
    for (;; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
      const services::MutexLock lock(mutex);
      if (is_so()) return;
    }
  };
  std::atomic<int> looks{0};
  const CertificateRenewal renewal({open(), names, first.chain},
                                   {[&] {
                                      ++looks;
                                      return now.load();
                                    },
                                    std::chrono::milliseconds(1)},
                                   [&](const Expected<ServerCertificate>& made) {
                                     const services::MutexLock lock(mutex);
                                     made ? told.push_back(*made) : void(++failed);
                                   });
  wait_for([&] { return looks > 3; });
  EXPECT_TRUE(told.empty()) << "it is good";
  now = kBegin + 368 * kDay;
  wait_for([&] { return !told.empty(); });
  const int then = looks;
  wait_for([&] { return looks > then + 3; });
  EXPECT_EQ(told.size(), 1U) << "once";
  EXPECT_NE(told[0].chain, first.chain);
  EXPECT_TRUE(is_trusted(told[0], authority.certificate(), names[0], kBegin + 400 * kDay));
  EXPECT_FALSE(is_trusted(first, authority.certificate(), names[0], kBegin + 400 * kDay));
  ASSERT_EQ(::chmod(place.path.c_str(), 0500), 0);
  ASSERT_EQ(::chmod(place.file("tls").c_str(), 0500), 0);
  if (::geteuid() != 0) {  // whom no permission keeps out
    now = kBegin + 740 * kDay;
    wait_for([&] { return failed > 2; });
  }
  ASSERT_EQ(::chmod(place.path.c_str(), 0700), 0);
  ASSERT_EQ(::chmod(place.file("tls").c_str(), 0700), 0);
  now = kBegin + 740 * kDay;
  wait_for([&] { return told.size() == 2; });
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
