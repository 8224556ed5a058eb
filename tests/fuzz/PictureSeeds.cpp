// SPDX-License-Identifier: BSD-3-Clause
#include "../support/PngMaker.h"
#include "GridSeeds.h"

#include <offmap/maps/RosMapWriter.h>

/// Writes pictures into the folder that it is given: each kind that a reader takes.
int main(int argc, char** argv) {
    if (argc != 2) return 1;
    const std::filesystem::path folder = argv[1];
    using namespace offmap::test;
    using namespace std::string_literals;
    writeFile(folder / "pgm", offmap::maps::rosPictureOf(seedGrid()));
    writeFile(folder / "ppm",
              "P6\n# colours\n2 3 255\n" + std::string(9, 0) + std::string(9, '\xff'));
    const std::string grey = std::string(6, 0) + std::string(6, '\xff');
    writeFile(folder / "grey.png", makePng({4, 3}, grey));
    writeFile(folder / "grey16.png", makePng({2, 3, 16}, grey));
    writeFile(folder / "colour.png", makePng({2, 2, 8, 2}, grey));
    writeFile(folder / "opacity.png", makePng({2, 3, 8, 4}, grey));
    writeFile(folder / "palette.png",
              makePng({4, 3, 8, 3, "\0\0\0\xff\xff\xff\x80\x80\x80"s, "\xff\xff\0"s},
                      "\0\1\2\0\1\2\0\1\2\0\1\2"s));
    // 2 x 2 pixels of 24 bits, each row filled up to 8 bytes.
    const std::string head = "BM\x46\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\2\0\0\0\2\0\0\0\1\0\x18\0"s;
    writeFile(folder / "bmp",
              head + std::string(24, 0) + std::string(8, 0) + std::string(8, '\xff'));
    // 4 x 2 grey pixels in one strip: width, height, bits, compression, kind, place, rows, size.
    const std::string tags = "\x08\0"s + "\0\1\3\0\1\0\0\0\4\0\0\0"s + "\1\1\3\0\1\0\0\0\2\0\0\0"s +
                             "\2\1\3\0\1\0\0\0\x08\0\0\0"s + "\3\1\3\0\1\0\0\0\1\0\0\0"s +
                             "\6\1\3\0\1\0\0\0\1\0\0\0"s + "\x11\1\4\0\1\0\0\0\x6e\0\0\0"s +
                             "\x16\1\3\0\1\0\0\0\2\0\0\0"s + "\x17\1\4\0\1\0\0\0\x08\0\0\0"s;
    writeFile(folder / "tiff",
              "II\x2a\0\x08\0\0\0"s + tags + std::string(4, 0) + grey.substr(2, 8));
}
