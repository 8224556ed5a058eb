// SPDX-License-Identifier: BSD-3-Clause
#include "FactoryCalibrations.h"
#include "VelodyneFields.h"

#include <offmap/rawlog/VelodyneModel.h>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

// Periods from the user manuals: VLP-16 (63-9243), HDL-32E (63-9113). An HDL-64E (63-9194) fires
// its 64 lasers in groups within some 48 us; its manual gives no scheme that all revisions follow,
// and the whole of it is 0.2 degrees of rotation, so they count as one flash.
constexpr VelodyneModel vlp16{"VLP-16", 16, 2, false, true, 110.592, 55.296, 2.304};
constexpr VelodyneModel hdl32{"HDL-32E", 32, 1, false, true, 46.08, 46.08, 1.152};
constexpr VelodyneModel hdl64{"HDL-64E", 64, 1, true, false, 48, 48, 0};

constexpr uint8_t hdl32Id = 0x21;
constexpr uint8_t vlp16Id = 0x22;

/// [deg] Lasers of an HDL-64E look up to some 9 degrees to the side.
constexpr double maxAzimuthCorrection = 30;

struct Identity {
    const VelodyneModel* model = nullptr;
    std::string fault;  ///< why there is no model
};

struct Banks {
    size_t upper = 0, lower = 0;  ///< blocks
};

Banks banksOf(const Scan& obs) {
    Banks banks;
    for (const auto& packet : obs.scan_packets) {
        for (const auto& block : packet.blocks) {
            banks.upper += headerOf(block) == Scan::UPPER_BANK;
            banks.lower += headerOf(block) == Scan::LOWER_BANK;
        }
    }
    return banks;
}

Identity identifyById(const Scan& obs) {
    const uint8_t id = obs.scan_packets.front().velodyne_model_ID;
    for (const auto& packet : obs.scan_packets) {
        if (packet.velodyne_model_ID != hdl32Id && packet.velodyne_model_ID != vlp16Id) {
            return {nullptr,
                    fmt::format("Velodyne model 0x{:02x} (known are HDL-32E 0x21, VLP-16 0x22)",
                                packet.velodyne_model_ID)};
        }
        if (packet.velodyne_model_ID != id) {
            return {nullptr, "a Velodyne scan with packets of both VLP-16 and HDL-32E"};
        }
    }
    return {id == hdl32Id ? &hdl32 : &vlp16, {}};
}

/// The last bytes of an HDL-64E packet, where others tell their model, hold a changing status. A
/// few blocks of other models may look like the lower bank if their bytes are damaged.
Identity identifyByPackets(const Scan& obs) {
    const bool calibrated = obs.calibration.laser_corrections.size() == hdl64.lasers;
    const Banks banks = banksOf(obs);
    if (banks.lower > 0 && (calibrated || 2 * banks.lower >= banks.upper)) {
        if (calibrated) return {&hdl64, {}};
        return {nullptr, "Velodyne HDL-64E without its calibration of 64 lasers"};
    }
    return identifyById(obs);
}

std::string faultOf(const mrpt::obs::VelodyneCalibration& calibration, const VelodyneModel& model) {
    const auto& lasers = calibration.laser_corrections;
    if (lasers.empty()) return {};
    if (lasers.size() != model.lasers) {
        return fmt::format("a Velodyne calibration of {} lasers for a {}, which has {},",
                           lasers.size(), model.name, model.lasers);
    }
    for (size_t l = 0; l < lasers.size(); ++l) {
        const auto& c = lasers[l];
        const double sum = c.azimuthCorrection + c.verticalCorrection + c.distanceCorrection +
                           c.verticalOffsetCorrection + c.horizontalOffsetCorrection +
                           c.sinVertCorrection + c.cosVertCorrection;
        if (!std::isfinite(sum)) {
            return fmt::format("a Velodyne calibration that is not finite (laser {})", l);
        }
        if (std::abs(c.azimuthCorrection) > maxAzimuthCorrection) {
            return fmt::format("a Velodyne calibration with an azimuth correction of {} degrees",
                               +c.azimuthCorrection);
        }
    }
    return {};
}

Identity identify(const Scan& obs) {
    Identity identity{&vlp16, {}};  // what an empty scan is of does not matter
    if (obs.scan_packets.empty()) {
        if (obs.point_cloud.size() > 0) return {nullptr, "a Velodyne scan without its packets"};
        return identity;
    }
    identity = identifyByPackets(obs);
    if (identity.model) identity.fault = faultOf(obs.calibration, *identity.model);
    return identity;
}

}  // namespace

std::optional<std::string> unsupportedVelodyne(const Scan& obs) {
    const std::string fault = identify(obs).fault;
    if (fault.empty()) return {};
    return fault + " is not supported, copied unchanged";
}

const VelodyneModel& modelOf(const Scan& obs) {
    const Identity identity = identify(obs);
    if (identity.fault.empty()) return *identity.model;
    throw std::invalid_argument(
        fmt::format("'{}': {} cannot be decoded", obs.sensorLabel, identity.fault));
}

LaserCalibrations calibrationOf(const Scan& obs, const VelodyneModel& model) {
    if (!obs.calibration.empty()) return obs.calibration.laser_corrections;
    const FactoryCalibrations& factory = factoryCalibrations();
    return (&model == &hdl32 ? factory.hdl32 : factory.vlp16).laser_corrections;
}

}  // namespace offmap::rawlog
