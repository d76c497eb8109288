// Secrets that the server makes: tokens of accounts, tickets of WebSockets and codes of pairings. Each has 256 random
// bits, a code 128: so a plain SHA-256 of it cannot be searched through, and the server keeps that alone.
//
// Threads: any.
#pragma once

#include <string>
#include <string_view>

namespace race::server {

/// `prefix` and 43 characters of base64url (RFC 4648, section 5) from the random numbers of the system. A prefix tells
/// tools that look for secrets in files what they have found.
std::string make_secret(std::string_view prefix);

/// 22 characters of base64url, 128 random bits: short, as a phone reads it from a QR code, and good for a minute.
std::string make_code();
inline constexpr std::size_t kCodeLength = 22;

inline constexpr std::string_view kTokenPrefix = "race_";
inline constexpr std::string_view kTicketPrefix = "ticket_";

/// 64 hexadecimal digits, by which the server knows the secret again.
std::string digest_of_secret(std::string_view secret);

}  // namespace race::server
