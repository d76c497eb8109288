// DELETE /api/v1/cores/{id}: a run is stopped first.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

void delete_core(const Request& request, Respond respond, Cores& cores) {
  cores.remove(request.parameters.at("id"),
               [respond = std::move(respond)](const Expected<std::shared_ptr<Core>>& removed) {
                 respond(removed ? Handled(ok((*removed)->info())) : failed(removed.error()));
               });
}

}  // namespace race::server
