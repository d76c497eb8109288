#include "services/world/urdf_limits.h"

#include <string>

namespace race::world {
namespace {

tl::unexpected<Error> unfit(const char* why) { return unexpected(ErrorCode::syntax, why); }

// Whether the tag after '<' is of elements of this name.
bool is_named(std::string_view tag, std::string_view name) {
  return tag.starts_with(name) && tag.size() > name.size() &&
         std::string_view(" \t\r\n/>").find(tag[name.size()]) != std::string_view::npos;
}

// Where the tag that `rest` begins with ends: at its '>', which is not within quotes.
Expected<std::size_t> end_of_tag(std::string_view rest) {
  char quote = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const char c = rest[i];
    if (c == '<') return unfit("a tag has no `<` within");
    if (quote != 0 && c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    } else if (c == '>') {
      if (quote != 0) return unfit("an attribute has no `>` within");
      return i;
    }
  }
  return unfit("a tag does not end");
}

struct Counts {
  std::size_t elements = 0, links = 0, joints = 0, depth = 0;

  Expected<void> element(std::string_view tag) {
    if (tag.starts_with('/')) {
      if (depth == 0) return unfit("an element ends that has not begun");
      --depth;
      return {};
    }
    links += is_named(tag, "link") ? 1 : 0;
    joints += is_named(tag, "joint") ? 1 : 0;
    if (links > kUrdfLinks || joints > kUrdfLinks)
      return unexpected(ErrorCode::too_large, "has at most " + std::to_string(kUrdfLinks) + " links and joints");
    if (!tag.ends_with("/>") && ++depth > kUrdfDepth)
      return unexpected(ErrorCode::too_deep, "elements are at most " + std::to_string(kUrdfDepth) + " deep");
    return {};
  }
};

}  // namespace

Expected<void> check_urdf_text(std::string_view text) {
  constexpr std::string_view kDeclaration = "<?xml ", kComment = "<!--", kCommentEnd = "-->";
  if (text.find('\0') != std::string_view::npos) return unfit("there is a zero byte in it");
  Counts counts;
  bool first = true;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    const std::string_view rest = text.substr(at);
    if (++counts.elements > kUrdfElements)
      return unexpected(ErrorCode::too_large, "has at most " + std::to_string(kUrdfElements) + " elements");
    if (rest.starts_with(kComment)) {
      const std::size_t end = rest.find(kCommentEnd, kComment.size());
      if (end == std::string_view::npos) return unfit("a comment does not end");
      at += end + kCommentEnd.size();
    } else {
      const bool declares = rest.starts_with(kDeclaration);
      if (declares ? !first : rest.starts_with("<!") || rest.starts_with("<?"))
        return unfit("there are elements and comments alone");
      ASSIGN_OR_RETURN(const std::size_t end, end_of_tag(rest.substr(1)));
      if (!declares)
        if (auto good = counts.element(rest.substr(1, end + 1)); !good) return good;
      at += end + 2;
    }
    first = false;
  }
  return {};
}

}  // namespace race::world
