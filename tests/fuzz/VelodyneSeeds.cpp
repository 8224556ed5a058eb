// SPDX-License-Identifier: BSD-3-Clause
// Writes the inputs that fuzzing starts from: VelodyneSeeds FOLDER
#include "../support/VelodyneFuzz.h"

#include <filesystem>
#include <fstream>
#include <string>

int main(int argc, char** argv) {
    if (argc != 2) return 1;
    const std::filesystem::path folder(argv[1]);
    std::filesystem::create_directories(folder);
    size_t number = 0;
    for (const auto& seed : offmap::test::velodyneFuzzSeeds()) {
        std::ofstream file(folder / ("seed" + std::to_string(number++)), std::ios::binary);
        file.write(reinterpret_cast<const char*>(seed.data()),
                   static_cast<std::streamsize>(seed.size()));
        if (!file) return 2;
    }
    return 0;
}
