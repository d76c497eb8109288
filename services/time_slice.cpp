#include "services/time_slice.h"

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace race::services {
namespace {

// sched_attr of the kernel, version 0 (SCHED_ATTR_SIZE_VER0): its header and that of the C library exclude each other.
struct SchedulingAttributes {
  std::uint32_t size = sizeof(SchedulingAttributes), policy = SCHED_OTHER;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime = 0, deadline = 0, period = 0;
};

}  // namespace

std::optional<std::chrono::nanoseconds> time_slice() {
  SchedulingAttributes attributes;
  const bool known = syscall(SYS_sched_getattr, 0, &attributes, sizeof attributes, 0U) == 0 && attributes.runtime > 0;
  if (!known) return std::nullopt;
  return std::chrono::nanoseconds(attributes.runtime);
}

void shorten_time_slice() {
  SchedulingAttributes attributes;
  attributes.nice = getpriority(PRIO_PROCESS, 0);
  attributes.runtime = static_cast<std::uint64_t>(kShortSlice.count());
  syscall(SYS_sched_setattr, 0, &attributes, 0U);
}

}  // namespace race::services
