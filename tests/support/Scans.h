// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/serialization/CArchive.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace offmap::test {

/// All observations of class T in a log.
template <class T>
std::vector<std::shared_ptr<T>> observationsIn(const std::filesystem::path& rawlog) {
    mrpt::maps::registerAllClasses_mrpt_maps();
    mrpt::io::CFileGZInputStream file(rawlog.string());
    auto archive = mrpt::serialization::archiveFrom(file);
    std::vector<std::shared_ptr<T>> found;
    try {
        for (;;) {
            if (auto obs = std::dynamic_pointer_cast<T>(archive.ReadObject())) found.push_back(obs);
        }
    } catch (const mrpt::serialization::CExceptionEOF&) {
        return found;
    }
}

/// What the object is in a log.
inline std::string bytesOf(const mrpt::serialization::CSerializable& object) {
    mrpt::io::CMemoryStream memory;
    auto archive = mrpt::serialization::archiveFrom(memory);
    archive << object;
    return {static_cast<const char*>(memory.getRawBufferData()),
            static_cast<size_t>(memory.getTotalBytesCount())};
}

/// A vehicle whose pose is a function of time.
class DrivenVehicle : public rawlog::PoseSource {
 public:
    using Path = std::function<mrpt::poses::CPose3D(mrpt::Clock::time_point)>;
    explicit DrivenVehicle(Path path) : path_(std::move(path)) {}
    /// One that stands.
    explicit DrivenVehicle(const mrpt::poses::CPose3D& pose)
        : path_([pose](mrpt::Clock::time_point) { return pose; }) {}

    rawlog::PoseLookup at(mrpt::Clock::time_point time) const override {
        rawlog::PoseLookup lookup;
        lookup.vehicleInMap = path_(time);
        return lookup;
    }
    rawlog::SettledPoses settled() const override { return rawlog::allSettled; }

 private:
    Path path_;
};

/// A vehicle that nothing is known of.
class LostVehicle : public rawlog::PoseSource {
 public:
    rawlog::PoseLookup at(mrpt::Clock::time_point) const override {
        rawlog::PoseLookup lookup;
        lookup.fault = core::PoseFault::TooOld;
        return lookup;
    }
};

inline std::vector<uint8_t> randomMask(size_t size, uint32_t seed) {
    std::mt19937 random(seed);
    std::bernoulli_distribution keep(0.6);
    std::vector<uint8_t> mask(size);
    for (auto& m : mask) m = keep(random) ? 1 : 0;
    return mask;
}

inline std::vector<uint8_t> complementOf(std::vector<uint8_t> mask) {
    for (auto& m : mask) m = m ? 0 : 1;
    return mask;
}

}  // namespace offmap::test
