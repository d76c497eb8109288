#include "services/display/image.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/value/base64.h"

namespace race::display {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kTypes = {{
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".jpeg", "image/jpeg"},
    {".webp", "image/webp"},
    {".gif", "image/gif"},
    {".svg", "image/svg+xml"},
}};

tl::unexpected<Error> refuse(ErrorCode code, std::string why) { return unexpected(code, std::move(why), "image"); }

tl::unexpected<Error> too_large() {
  return refuse(ErrorCode::too_large,
                "an image has at most " + std::to_string(kImageCharacters) + " characters as a data URL");
}

Expected<std::string> check_url(const std::string& url) {
  if (url.size() > kImageCharacters) return too_large();
  for (const auto& [extension, type] : kTypes) {
    const std::string head = "data:" + std::string(type) + ";base64,";
    if (url.starts_with(head) && is_base64(std::string_view(url).substr(head.size()))) return url;
  }
  return refuse(ErrorCode::type, "expected data:image/...;base64,... of a PNG, JPEG, WebP, GIF or SVG");
}

}  // namespace

Expected<std::string> image_url(const std::string& image, const std::string& folder) {
  if (image.starts_with("data:")) return check_url(image);
  const auto type =
      std::ranges::find_if(kTypes, [&](const auto& each) { return std::string_view(image).ends_with(each.first); });
  if (type == kTypes.end() || image.starts_with('.') || image.find_first_of("/\\") != std::string::npos)
    return refuse(ErrorCode::type, "expected a data URL, or the name of an image file of the cell");
  const fs::path file = fs::path(folder) / image;
  std::error_code error;
  if (folder.empty() || !fs::is_regular_file(file, error))
    return refuse(ErrorCode::not_found, "the cell has no file `" + image + "`");
  std::string url = "data:" + std::string(type->second) + ";base64,";
  const auto bytes = fs::file_size(file, error);
  if (!error && (bytes + 2) / 3 * 4 + url.size() > kImageCharacters) return too_large();
  if (error) return refuse(ErrorCode::io, "`" + image + "` cannot be read");
  std::ifstream stream(file, std::ios::binary);
  std::string content(bytes, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(bytes));
  const bool is_whole = stream && stream.peek() == std::char_traits<char>::eof() && !stream.bad();
  if (!is_whole) return refuse(ErrorCode::io, "`" + image + "` cannot be read");
  return url + base64(content);
}

}  // namespace race::display
