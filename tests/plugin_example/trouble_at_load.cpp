// A library that is no good plugin, in the way that a definition says.
#include <unistd.h>

#include <csignal>

#ifdef UNDEFINED
void defined_nowhere();
#endif

namespace {

struct AtLoad {
  AtLoad() {
#ifdef CRASH_AT_LOAD
    raise(SIGSEGV);
#endif
#ifdef HANG_AT_LOAD
    while (true) sleep(1);
#endif
#ifdef EXIT_AT_LOAD
    _exit(7);
#endif
#ifdef UNDEFINED
    defined_nowhere();
#endif
  }
};

const AtLoad at_load;

}  // namespace

#ifndef NO_ENTRY
extern "C" const char* kappabench_plugin(const char* programs_stamp, void*) {
#ifdef OTHER_STAMP
  static_cast<void>(programs_stamp);
  return "interface=0 compiler=gcc-4";
#else
  return programs_stamp;  // and registers nothing
#endif
}
#endif
