// SPDX-License-Identifier: BSD-3-Clause
#include "CellOfChance.h"

#include <offmap/maps/GridDrawing.h>
#include <offmap/maps/GridFile.h>

#include <fmt/format.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <zlib.h>

// MRPT's deserializer makes a grid as large as four numbers of the file say, before it knows
// whether the file holds that many cells. Here the beginning of the object is read by itself; what
// stands behind the cells is of no use to a map.

namespace offmap::maps {

namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw std::runtime_error(fmt::format("{}: {}", name, what));
}

/// The bytes of a file, decompressed if need be.
class Bytes {
 public:
    explicit Bytes(const std::filesystem::path& file)
        : name_(file.string()), file_(gzopen(name_.c_str(), "rb"), gzclose) {
        if (!file_) refuse(name_, "cannot read the grid map; is there such a file?");
    }

    void read(void* to, size_t size) {
        if (readSome(to, size) != size) refuse(name_, "is cut off; write the grid map again");
    }

    /// What stands behind the cells is not used, but gzip's checksum stands at the very end.
    void readToTheEnd() {
        std::array<char, 65536> rest{};
        constexpr int most = 1000;  // a bomb; MRPT writes about 200 bytes
        for (int i = 0; readSome(rest.data(), rest.size()) > 0; ++i) {
            if (i == most) refuse(name_, "goes on far behind the cells: is no grid map");
        }
    }

    /// Numbers stand in the file as in the memory of this computer.
    template <class Number>
    Number number() {
        static_assert(std::endian::native == std::endian::little);
        Number value;
        read(&value, sizeof value);
        return value;
    }

    std::string text(size_t size) {
        std::string bytes(size, '\0');
        read(bytes.data(), size);
        return bytes;
    }

    const std::string& name() const { return name_; }

 private:
    size_t readSome(void* to, size_t size) {
        const int got = gzread(file_.get(), to, static_cast<unsigned>(size));
        int status = Z_OK;
        gzerror(file_.get(), &status);
        if (got < 0 || (status != Z_OK && status != Z_STREAM_END)) {
            refuse(name_, "is damaged or cannot be read; write the grid map again");
        }
        return static_cast<size_t>(got);
    }

    std::string name_;
    std::unique_ptr<gzFile_s, int (*)(gzFile)> file_;
};

void readHeader(Bytes& in) {
    constexpr uint8_t isText = 0x80;  // its length stands in the other bits
    const auto size = in.number<uint8_t>();
    const std::string className = (size & isText) != 0 ? in.text(size & ~isText) : "";
    // Older versions of MRPT wrote no namespace.
    if (className != "mrpt::maps::COccupancyGridMap2D" && className != "COccupancyGridMap2D") {
        refuse(in.name(),
               "is no MRPT occupancy grid; one is written by "
               "grid.saveToFile or by offmap map convert");
    }
    constexpr int oldest = 3, newest = 6;  // since 3 cells are log-odds
    const int version = in.number<uint8_t>();
    if (version < oldest || version > newest) {
        refuse(in.name(), fmt::format("is a grid map of version {}; {} to {} can be read: load and "
                                      "save it with MRPT 2.5",
                                      version, oldest, newest));
    }
    constexpr int bits = 8;
    if (const int found = in.number<uint8_t>(); found != bits) {
        refuse(in.name(), fmt::format("has cells of {} bits; only 8 can be read", found));
    }
}

struct Bounds {
    uint32_t width, height;
    float xMin, xMax, yMin, yMax, resolution;
};

Bounds readBounds(Bytes& in) {
    const auto width = in.number<uint32_t>(), height = in.number<uint32_t>();
    const auto xMin = in.number<float>(), xMax = in.number<float>(), yMin = in.number<float>(),
               yMax = in.number<float>(), resolution = in.number<float>();
    return {width, height, xMin, xMax, yMin, yMax, resolution};
}

void requireConsistent(const Bounds& bounds, const std::string& name) {
    for (const float corner : {bounds.xMin, bounds.xMax, bounds.yMin, bounds.yMax}) {
        constexpr float mostMetres = 1e6;
        if (!(std::abs(corner) <= mostMetres)) {
            refuse(name, fmt::format("a corner of the grid at {} m", corner));
        }
    }
    const auto fits = [&](float low, float high, uint32_t cells) {
        return std::abs((high - low) / bounds.resolution - static_cast<float>(cells)) <=
               1 + 1e-4F * static_cast<float>(cells);  // single precision, far from the origin
    };
    if (fits(bounds.xMin, bounds.xMax, bounds.width) &&
        fits(bounds.yMin, bounds.yMax, bounds.height)) {
        return;
    }
    refuse(name, fmt::format("{} x {} cells of {} m do not fill x {} to {}, y {} to {} m: the grid "
                             "map is damaged",
                             bounds.width, bounds.height, bounds.resolution, bounds.xMin,
                             bounds.xMax, bounds.yMin, bounds.yMax));
}

/// What each byte of a file means.
std::array<Cell, 256> meaningOfBytes() {
    std::array<Cell, 256> meaning{};
    for (int value = -128; value < 128; ++value) {
        meaning[static_cast<uint8_t>(value)] =
            cellOfChance(mrpt::maps::COccupancyGridMap2D::l2p(static_cast<int8_t>(value)));
    }
    return meaning;
}

}  // namespace

OccupancyGrid readGridMap(const std::filesystem::path& file) {
    Bytes in(file);
    readHeader(in);
    const Bounds bounds = readBounds(in);
    requireConsistent(bounds, in.name());
    // 0.05 as a float is 0.0500000007: over a thousand cells that is nothing, but it is not read.
    const double resolution = std::stod(fmt::format("{}", bounds.resolution));
    OccupancyGrid grid =
        makeGrid(bounds.width, bounds.height, resolution, Cell::Unknown, in.name());
    grid.origin = {static_cast<double>(bounds.xMin), static_cast<double>(bounds.yMin), 0};
    const std::array<Cell, 256> meaning = meaningOfBytes();
    std::string row(bounds.width, '\0');
    auto cell = grid.cells.begin();
    for (uint32_t y = 0; y < bounds.height; ++y) {
        in.read(row.data(), row.size());
        for (const char value : row) *cell++ = meaning[static_cast<uint8_t>(value)];
    }
    in.readToTheEnd();
    return grid;
}

Drawing readGridMapDrawing(const std::filesystem::path& file, const MapOptions& options) {
    Drawing drawing = drawingOf(readGridMap(file), options, "grid map", file.string());
    warnOfUnusedOptions(options, drawing);
    return drawing;
}

}  // namespace offmap::maps
