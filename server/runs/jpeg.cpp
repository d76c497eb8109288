#include "server/runs/jpeg.h"

#include <turbojpeg.h>

#include <memory>

namespace race::server {
namespace {

constexpr int kQuality = 75;

struct Destroy {
  void operator()(void* compressor) const { tjDestroy(compressor); }
};
struct Free {
  void operator()(unsigned char* bytes) const { tjFree(bytes); }
};

}  // namespace

std::optional<std::string> jpeg(std::string_view colour, std::size_t width, std::size_t height) {
  if (width == 0 || height == 0 || width > 4096 || height > 4096 || colour.size() != width * height * 3) return {};
  const std::unique_ptr<void, Destroy> compressor(tjInitCompress());
  if (!compressor) return {};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const auto* pixels = reinterpret_cast<const unsigned char*>(colour.data());
  const int done = tjCompress2(compressor.get(), pixels, static_cast<int>(width), 0, static_cast<int>(height), TJPF_RGB,
                               &bytes, &size, TJSAMP_420, kQuality, 0);
  const std::unique_ptr<unsigned char, Free> owner(bytes);
  if (done != 0) return {};
  return std::string(reinterpret_cast<const char*>(bytes), size);
}

}  // namespace race::server
