// The services that people meet: `display` and `audio`, as further services of a cell.
#pragma once

#include <string>
#include <vector>

#include "server/cell/cell.h"
#include "services/display/screens.h"

namespace race::server {

/// Both on `screens`, which outlive the cell, also where they are processes. `folder`: where `display` finds images
/// here (CellSetup::folder).
std::vector<ExtraService> screen_services(display::Screens& screens, const std::string& folder);

}  // namespace race::server
