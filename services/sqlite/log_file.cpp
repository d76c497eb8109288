#include "services/sqlite/log_file.h"

#include <bit>

namespace race::sqlite {
namespace {

constexpr std::size_t kHeaderBytes = 32, kFrameHeaderBytes = 24;
constexpr std::uint32_t kMagic = 0x377f0682, kVersion = 3007000;  // the last bit of the magic number: big-endian

std::uint32_t word_at(std::string_view bytes, std::size_t at, bool is_big_endian) {
  const auto byte = [&](std::size_t index) { return std::uint32_t{static_cast<unsigned char>(bytes[at + index])}; };
  if (is_big_endian) return byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
  return byte(3) << 24 | byte(2) << 16 | byte(1) << 8 | byte(0);
}

LogSalts salts_at(std::string_view bytes, std::size_t at) {
  LogSalts salts;
  bytes.copy(salts.data(), salts.size(), at);
  return salts;
}

LogChecksum checksum_at(std::string_view bytes, std::size_t at) {
  return {number_at(bytes, at), number_at(bytes, at + 4)};
}

}  // namespace

std::uint32_t number_at(std::string_view bytes, std::size_t at) { return word_at(bytes, at, true); }

LogChecksum log_checksum(std::string_view bytes, bool is_big_endian, LogChecksum from) {
  for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
    from.s0 += word_at(bytes, at, is_big_endian) + from.s1;
    from.s1 += word_at(bytes, at + 4, is_big_endian) + from.s0;
  }
  return from;
}

LogFile::LogFile(const std::string& path) : stream_(path, std::ios::binary) {}

bool LogFile::read(std::uint64_t at, char* bytes, std::size_t size) {
  stream_.clear(stream_.rdstate() & std::ios::badbit);
  if (at != at_) stream_.seekg(static_cast<std::streamoff>(at));
  const bool is_whole = static_cast<bool>(stream_.read(bytes, static_cast<std::streamsize>(size)));
  at_ = at + static_cast<std::uint64_t>(stream_.gcount());
  return is_whole;
}

bool LogFile::read(LogHeader& header) {
  std::array<char, kHeaderBytes> raw;
  if (!stream_.is_open() || !read(0, raw.data(), raw.size())) return false;
  const std::string_view bytes(raw.data(), raw.size());
  const std::uint32_t magic = number_at(bytes, 0), page_size = number_at(bytes, 8);
  header.content = bytes.substr(0, 24);
  header.layout = {page_size, (magic & 1U) != 0};
  header.salts = salts_at(bytes, 16);
  header.stored = checksum_at(bytes, 24);
  header.is_sound = (magic & ~1U) == kMagic && number_at(bytes, 4) == kVersion && std::has_single_bit(page_size) &&
                    page_size >= kLeastLogPage && page_size <= kLargestLogPage &&
                    header.stored == log_checksum(header.content, header.layout.is_big_endian, {});
  return true;
}

bool LogFile::read(const LogLayout& layout, std::uint64_t number, LogFrame& frame) {
  std::array<char, kFrameHeaderBytes> raw;
  const std::uint64_t at = kHeaderBytes + (number - 1) * (kFrameHeaderBytes + layout.page_size);
  if (!read(at, raw.data(), raw.size())) return false;
  const std::string_view bytes(raw.data(), raw.size());
  frame.salts = salts_at(bytes, 8);
  frame.stored = checksum_at(bytes, 16);
  frame.content.resize(8 + std::size_t{layout.page_size});
  bytes.copy(frame.content.data(), 8);
  return read(at + raw.size(), frame.content.data() + 8, layout.page_size);
}

}  // namespace race::sqlite
