// What tools such as `top -H`, gdb and perf call a thread (Linux).
#pragma once

#include <pthread.h>

namespace race::services {

/// Names the thread that calls; at most 15 bytes.
inline void name_thread(const char* name) { pthread_setname_np(pthread_self(), name); }

}  // namespace race::services
