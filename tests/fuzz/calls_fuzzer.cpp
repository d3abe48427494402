// Sequences of calls that follow from bytes: whatever comes, every call answers as bempd.h says.
#include "scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int most_calls = 40;
  fuzz::Bytes bytes(data, size);
  fuzz::Scene scene(bytes);
  switch (bytes.pick(8)) {
    case 0:
      break;
    case 1:
      scene.build_cracked();
      break;
    default:
      scene.build();
  }
  for (int call = 0; call < most_calls && !bytes.is_empty(); ++call) scene.act();
  return 0;
}
