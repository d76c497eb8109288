#include "services/camera/view.h"

#include "services/camera/marker.h"
#include "services/camera/vector_internal.h"

namespace race::camera {

std::vector<Item> view(const world::World& world, const world::Pose& o_t_c) {
  const world::Pose c_t_o = inverse(o_t_c);
  std::vector<Item> items;
  for (const world::Body& body : world.scene().bodies) {
    if (!world.present(body.name)) continue;
    const world::Pose c_t_body = compose(c_t_o, world.pose(body.name));
    items.push_back({body.shape, c_t_body, parse_colour(body.colour)});
    for (const world::Marker& marker : body.markers) add_marker(marker, c_t_body, items);
  }
  for (const world::Link& link : world.model().links) {
    if (link.visuals.empty()) continue;
    const world::Pose c_t_link = compose(c_t_o, world.pose(link.name));
    for (const world::Visual& visual : link.visuals)
      items.push_back({visual.shape, compose(c_t_link, visual.link_t_shape), parse_colour(visual.colour)});
  }
  return items;
}

}  // namespace race::camera
