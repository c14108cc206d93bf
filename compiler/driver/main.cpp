#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "compiler/driver/command_line.h"
#include "compiler/driver/commands.h"

namespace {

constexpr char const* request = "this is a fault of jrule, not of your file: please report it, with the command and the file";

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate([] {
    std::fprintf(stderr, "jrule: internal error\n%s\n", request);
    std::_Exit(jrule::driver::exit_internal);
  });
  try {
    return jrule::driver::run(argc, argv);
  } catch (std::bad_alloc const&) {
    std::fprintf(stderr, "jrule: error: not enough memory\n");
    return jrule::driver::exit_usage;
  } catch (std::exception const& fault) {
    std::fprintf(stderr, "jrule: internal error: %s\n%s\n", fault.what(), request);
    return jrule::driver::exit_internal;
  }
}
