// In place of libFuzzer, which the fuzzers have where the compiler is clang: runs each file named, once. Fails if there is none.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size);

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    std::ifstream in(argv[i], std::ios::binary);
    if (!in) {
      std::fprintf(stderr, "cannot read %s\n", argv[i]);
      return 1;
    }
    std::string const bytes{std::istreambuf_iterator<char>(in), {}};
    std::fprintf(stderr, "Running: %s\n", argv[i]);  // the last one is where it fails
    LLVMFuzzerTestOneInput(reinterpret_cast<std::uint8_t const*>(bytes.data()), bytes.size());
  }
  return argc > 1 ? 0 : 1;
}
