#include "services/world/urdf_tree.h"

#include <tinyxml.h>

#include <map>

namespace race::world {
namespace {

using Parents = std::map<std::string, std::string>;  // of each link that a joint leads to

std::string link_of(const TiXmlElement& joint, const char* end) {
  const TiXmlElement* const element = joint.FirstChildElement(end);
  const char* const link = element ? element->Attribute("link") : nullptr;
  return link ? link : "";
}

// A link with one parent at most is its own ancestor if as many steps towards the root as there are links do not end.
bool has_loop(const Parents& parents, std::string link) {
  for (std::size_t steps = 0; steps <= parents.size(); ++steps) {
    const auto parent = parents.find(link);
    if (parent == parents.end()) return false;
    link = parent->second;
  }
  return true;
}

}  // namespace

Expected<void> check_urdf_tree(const std::string& text) {
  TiXmlDocument xml;
  xml.Parse(text.c_str());
  const TiXmlElement* const robot = xml.FirstChildElement("robot");
  if (!robot) return {};
  Parents parents;
  for (auto* joint = robot->FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint")) {
    const std::string child = link_of(*joint, "child");
    if (!parents.emplace(child, link_of(*joint, "parent")).second)
      return unexpected(ErrorCode::duplicate, "two joints lead to the link", child);
  }
  for (const auto& [child, parent] : parents)
    if (has_loop(parents, parent)) return unexpected(ErrorCode::conflict, "the link is its own ancestor", child);
  return {};
}

}  // namespace race::world
