// Runs a fuzz target where there is no libFuzzer: over the files of a corpus, and over files made of them at random.
//   program [--random COUNT] [--seed SEED] FILE_OR_FOLDER...
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Input = std::vector<std::uint8_t>;

Input read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return Input(std::istreambuf_iterator<char>(file), {});
}

std::vector<Input> read_all(const std::vector<std::string>& places) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& place : places) {
    if (!std::filesystem::is_directory(place)) {
      paths.emplace_back(place);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(place)) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Input> inputs;
  for (const auto& path : paths) inputs.push_back(read(path));
  return inputs;
}

// A few bytes changed, put in or taken out, or the end of another input.
Input altered(const std::vector<Input>& inputs, std::mt19937_64& random) {
  Input input = inputs[random() % inputs.size()];
  const int changes = 1 + static_cast<int>(random() % 6);
  for (int change = 0; change < changes; ++change) {
    const std::size_t at = random() % (input.size() + 1);
    const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
    const std::uint64_t way = random() % 8;
    if (way < 4 && at < input.size()) *place = static_cast<std::uint8_t>(random());
    if (way == 4) input.insert(place, static_cast<std::uint8_t>(random()));
    if (way == 5 && at < input.size()) input.erase(place);
    if (way == 6) {
      const Input& other = inputs[random() % inputs.size()];
      input.resize(at);
      if (at < other.size()) input.insert(input.end(), other.begin() + static_cast<std::ptrdiff_t>(at), other.end());
    }
    if (way == 7)
      for (std::uint64_t more = random() % 24; more > 0; --more) input.push_back(static_cast<std::uint8_t>(random()));
  }
  return input;
}

// A crash leaves the input that caused it behind.
void keep(const Input& input) {
  const char* path = std::getenv("BEMPD_FUZZ_LAST");
  if (path == nullptr) return;
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
}

void run(const Input& input) {
  keep(input);
  LLVMFuzzerTestOneInput(input.data(), input.size());
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::string> places;
  long altered_inputs = 0;
  std::mt19937_64 random(1);
  for (int k = 1; k < count; ++k) {
    const std::string argument = arguments[k];
    if (argument == "--random" && k + 1 < count)
      altered_inputs = std::atol(arguments[++k]);
    else if (argument == "--seed" && k + 1 < count)
      random.seed(std::strtoull(arguments[++k], nullptr, 10));
    else
      places.push_back(argument);
  }
  const std::vector<Input> inputs = read_all(places);
  if (inputs.empty()) return std::fprintf(stderr, "no inputs; name files or folders\n"), EXIT_FAILURE;
  for (const Input& input : inputs) run(input);
  for (long k = 0; k < altered_inputs; ++k) run(altered(inputs, random));
  std::printf("%zu inputs and %ld altered ones\n", inputs.size(), altered_inputs);
  return EXIT_SUCCESS;
}
