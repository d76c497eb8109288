#include "server/tls/authority.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <openssl/bn.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>

#include "server/store/files.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

template <typename T, void (*release)(T*)>
struct Release {
  void operator()(T* held) const { release(held); }
};
void release_bio(BIO* bio) { BIO_free(bio); }
using Key = std::unique_ptr<EVP_PKEY, Release<EVP_PKEY, EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, Release<X509, X509_free>>;
using Bio = std::unique_ptr<BIO, Release<BIO, release_bio>>;
using Number = std::unique_ptr<BIGNUM, Release<BIGNUM, BN_free>>;
using Extension = std::unique_ptr<X509_EXTENSION, Release<X509_EXTENSION, X509_EXTENSION_free>>;

constexpr std::int64_t kDay = 86'400;
constexpr int kSerialBits = 127;  // RFC 5280, 4.1.2.2: positive, at most 20 octets
constexpr const char* kAuthorityName = "RACE local authority";
// No name of a host, nor an address: OpenSSL holds such a name against the constraints as if it were one of a host,
// where a certificate is for addresses alone.
constexpr const char* kServerName = "RACE server";
// RFC 5280, 4.2.1.10: of addresses, private ones; of names, those of local networks.
constexpr const char* kConstraints =
    "critical,permitted;IP:10.0.0.0/255.0.0.0,permitted;IP:172.16.0.0/255.240.0.0,permitted;IP:192.168.0.0/255.255.0.0,"
    "permitted;IP:169.254.0.0/255.255.0.0,permitted;IP:127.0.0.0/255.0.0.0,"
    "permitted;IP:fc00::/fe00::,permitted;IP:fe80::/ffc0::,"
    "permitted;IP:::1/ffff:ffff:ffff:ffff:ffff:ffff:ffff:ffff,permitted;DNS:local,permitted;DNS:localhost";

tl::unexpected<Error> no_memory(const std::string& path) {
  return unexpected(ErrorCode::io, "a certificate could not be made", path);
}

bool is_address(const std::string& name) {
  std::array<unsigned char, 16> bytes{};
  return ::inet_pton(AF_INET, name.c_str(), bytes.data()) == 1 ||
         ::inet_pton(AF_INET6, name.c_str(), bytes.data()) == 1;
}

Key make_key() { return Key(EVP_EC_gen("P-256")); }

bool add_extension(X509& certificate, X509& issuer, int kind, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, &issuer, &certificate, nullptr, nullptr, 0);
  const Extension extension(X509V3_EXT_conf_nid(nullptr, &context, kind, value.c_str()));
  return extension && X509_add_ext(&certificate, extension.get(), -1) == 1;
}

bool set_serial(X509& certificate) {
  const Number serial(BN_new());
  return serial && BN_rand(serial.get(), kSerialBits, BN_RAND_TOP_ONE, BN_RAND_BOTTOM_ANY) == 1 &&
         BN_to_ASN1_INTEGER(serial.get(), X509_get_serialNumber(&certificate)) != nullptr;
}

// A certificate with everything but extensions and signature. Good from an hour before, as clocks differ.
Certificate begin_certificate(EVP_PKEY& key, const std::string& common_name, std::int64_t now, int days) {
  Certificate certificate(X509_new());
  if (!certificate || X509_set_version(certificate.get(), X509_VERSION_3) != 1 || !set_serial(*certificate)) return {};
  const std::int64_t from = now - 3600, until = now + days * kDay;
  X509_NAME* const subject = X509_get_subject_name(certificate.get());
  const bool made =
      ASN1_TIME_set(X509_getm_notBefore(certificate.get()), from) &&
      ASN1_TIME_set(X509_getm_notAfter(certificate.get()), until) && X509_set_pubkey(certificate.get(), &key) == 1 &&
      X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_UTF8,
                                 reinterpret_cast<const unsigned char*>(common_name.c_str()), -1, -1, 0) == 1;
  return made ? std::move(certificate) : Certificate();
}

std::string text_in(BIO& bio) {
  char* data = nullptr;
  const auto size = BIO_get_mem_data(&bio, &data);
  return {data, static_cast<std::size_t>(size)};
}

std::string pem_of(X509& certificate) {
  const Bio bio(BIO_new(BIO_s_mem()));
  PEM_write_bio_X509(bio.get(), &certificate);
  return text_in(*bio);
}

std::string pem_of(EVP_PKEY& key) {
  const Bio bio(BIO_new(BIO_s_mem()));
  PEM_write_bio_PrivateKey(bio.get(), &key, nullptr, nullptr, 0, nullptr, nullptr);
  return text_in(*bio);
}

Certificate certificate_of(const std::string& pem) {
  const Bio bio(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())));
  return Certificate(PEM_read_bio_X509(bio.get(), nullptr, nullptr, nullptr));
}

Key key_of(const std::string& pem) {
  const Bio bio(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())));
  return Key(PEM_read_bio_PrivateKey(bio.get(), nullptr, nullptr, nullptr));
}

std::string fingerprint_of(X509& certificate) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  X509_digest(&certificate, EVP_sha256(), digest.data(), &size);
  std::string text;
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  for (unsigned int i = 0; i < size; ++i) {
    if (i > 0) text += ':';
    text += kDigits[digest.at(i) >> 4U];
    text += kDigits[digest.at(i) & 15U];
  }
  return text;
}

constexpr mode_t kPublic = 0644;

struct Pair {
  std::string certificate, key;
};

Expected<void> check_private(const std::string& path) {
  struct stat known {};
  if (::stat(path.c_str(), &known) != 0) return unexpected(ErrorCode::io, std::strerror(errno), path);
  if ((known.st_mode & (S_IRWXG | S_IRWXO)) == 0) return {};
  return unexpected(ErrorCode::not_accepted, "others may use this key: it needs the permissions 0600", path);
}

Expected<Pair> read_pair(const fs::path& folder, const std::string& name) {
  const std::string certificate_path = folder / (name + ".pem"), key_path = folder / (name + ".key");
  if (auto own = check_private(key_path); !own) return tl::unexpected(std::move(own).error());
  ASSIGN_OR_RETURN(std::string certificate, read_file(certificate_path));
  ASSIGN_OR_RETURN(std::string key, read_file(key_path));
  const Certificate parsed = certificate_of(certificate);
  const Key parsed_key = key_of(key);
  if (!parsed || !parsed_key || X509_check_private_key(parsed.get(), parsed_key.get()) != 1)
    return unexpected(ErrorCode::corrupt, "holds no certificate of the key beside it", certificate_path);
  return Pair{std::move(certificate), std::move(key)};
}

Expected<void> write_pair(const fs::path& folder, const std::string& name, const Pair& pair) {
  if (auto written = write_file(folder / (name + ".key"), pair.key, kOwnerAlone); !written) return written;
  return write_file(folder / (name + ".pem"), pair.certificate, kPublic);
}

std::optional<Pair> make_authority(std::int64_t now) {
  const Key key = make_key();
  if (!key) return std::nullopt;
  const Certificate made = begin_certificate(*key, kAuthorityName, now, Authority::kAuthorityDays);
  if (!made || X509_set_issuer_name(made.get(), X509_get_subject_name(made.get())) != 1) return std::nullopt;
  const bool extended = add_extension(*made, *made, NID_basic_constraints, "critical,CA:TRUE,pathlen:0") &&
                        add_extension(*made, *made, NID_key_usage, "critical,keyCertSign,cRLSign") &&
                        add_extension(*made, *made, NID_subject_key_identifier, "hash") &&
                        add_extension(*made, *made, NID_name_constraints, kConstraints);
  if (!extended || X509_sign(made.get(), key.get(), EVP_sha256()) == 0) return std::nullopt;
  return Pair{pem_of(*made), pem_of(*key)};
}

std::string alternative_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += std::string(text.empty() ? "" : ",") + (is_address(name) ? "IP:" : "DNS:") + name;
  return text;
}

std::optional<Pair> make_server(const std::vector<std::string>& names, const Pair& authority, std::int64_t now) {
  const Certificate issuer = certificate_of(authority.certificate);
  const Key issuer_key = key_of(authority.key), key = make_key();
  if (!issuer || !issuer_key || !key) return std::nullopt;
  const Certificate made = begin_certificate(*key, kServerName, now, Authority::kServerDays);
  if (!made || X509_set_issuer_name(made.get(), X509_get_subject_name(issuer.get())) != 1) return std::nullopt;
  const bool extended = add_extension(*made, *issuer, NID_basic_constraints, "critical,CA:FALSE") &&
                        add_extension(*made, *issuer, NID_key_usage, "critical,digitalSignature") &&
                        add_extension(*made, *issuer, NID_ext_key_usage, "serverAuth") &&
                        add_extension(*made, *issuer, NID_subject_key_identifier, "hash") &&
                        add_extension(*made, *issuer, NID_authority_key_identifier, "keyid:always") &&
                        add_extension(*made, *issuer, NID_subject_alt_name, alternative_names(names));
  if (!extended || X509_sign(made.get(), issuer_key.get(), EVP_sha256()) == 0) return std::nullopt;
  return Pair{pem_of(*made), pem_of(*key)};
}

bool is_for(X509& certificate, const std::string& name) {
  if (is_address(name)) return X509_check_ip_asc(&certificate, name.c_str(), 0) == 1;
  return X509_check_host(&certificate, name.c_str(), name.size(), 0, nullptr) == 1;
}

// Whether the certificate is of the authority, for all names, and long enough.
bool is_good(const Pair& pair, const std::string& authority, const std::vector<std::string>& names, std::int64_t now) {
  const Certificate certificate = certificate_of(pair.certificate), issuer = certificate_of(authority);
  if (!certificate || !issuer) return false;
  time_t renew = now + Authority::kRenewDays * kDay;
  if (X509_cmp_time(X509_get0_notAfter(certificate.get()), &renew) <= 0) return false;
  if (X509_verify(certificate.get(), X509_get0_pubkey(issuer.get())) != 1) return false;
  return std::ranges::all_of(names, [&](const std::string& name) { return is_for(*certificate, name); });
}

bool has_prefix(const std::array<unsigned char, 16>& bytes, unsigned char first, unsigned char mask) {
  return (bytes[0] & mask) == first;
}

}  // namespace

bool is_local_name(const std::string& name) {
  std::array<unsigned char, 16> bytes{};
  if (::inet_pton(AF_INET, name.c_str(), bytes.data()) == 1)
    return bytes[0] == 10 || bytes[0] == 127 || (bytes[0] == 172 && bytes[1] >> 4U == 1) ||
           (bytes[0] == 192 && bytes[1] == 168) || (bytes[0] == 169 && bytes[1] == 254);
  if (::inet_pton(AF_INET6, name.c_str(), bytes.data()) == 1)
    return has_prefix(bytes, 0xfc, 0xfe) || (bytes[0] == 0xfe && bytes[1] >> 6U == 2) || name == "::1";
  return !name.empty() && (name == "localhost" || name.ends_with(".local"));
}

Expected<Authority> Authority::open(const std::string& folder, std::int64_t now) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return unexpected(ErrorCode::io, error.message(), folder);
  if (!fs::exists(fs::path(folder) / "ca.pem")) {
    const auto made = make_authority(now);
    if (!made) return no_memory(folder);
    if (auto written = write_pair(folder, "ca", *made); !written) return tl::unexpected(std::move(written).error());
  }
  ASSIGN_OR_RETURN(Pair pair, read_pair(folder, "ca"));
  std::string fingerprint = fingerprint_of(*certificate_of(pair.certificate));
  return Authority(folder, std::move(pair.certificate), std::move(pair.key), std::move(fingerprint));
}

Expected<ServerCertificate> Authority::certificate_for(const std::vector<std::string>& names, std::int64_t now) const {
  for (const std::string& name : names)
    if (!is_local_name(name))
      return unexpected(ErrorCode::out_of_range, "is no private address and no name of a local network", name);
  if (fs::exists(fs::path(folder_) / "server.pem"))
    if (const auto kept = read_pair(folder_, "server"); kept && is_good(*kept, certificate_, names, now))
      return ServerCertificate{kept->certificate + certificate_, kept->key};
  const auto made = make_server(names, {certificate_, key_}, now);
  if (!made) return no_memory(folder_);
  if (auto written = write_pair(folder_, "server", *made); !written) return tl::unexpected(std::move(written).error());
  return ServerCertificate{made->certificate + certificate_, made->key};
}

}  // namespace race::server
