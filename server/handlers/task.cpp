// GET and DELETE /api/v1/tasks/{id}: what a request comes to that was answered before its work was done.
#include "server/handlers/handlers.h"
#include "server/handlers/tasks.h"

namespace race::server {

Handled get_task(const Request& request, Tasks& tasks) {
  return answer(tasks.find(request.parameters.at("id"), request.identity));
}

Handled cancel_task(const Request& request, Tasks& tasks) {
  return answer(tasks.cancel(request.parameters.at("id"), request.identity));
}

}  // namespace race::server
