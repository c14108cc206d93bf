// A plugin of another version: nothing but its first field may be read.
#include <cstdint>

extern "C" {
extern std::uint32_t const jrule_plugin_entry[];
std::uint32_t const jrule_plugin_entry[] = {999, 8};
}
