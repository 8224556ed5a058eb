// SPDX-License-Identifier: BSD-3-Clause
// The observations of a rawlog, one by one, read and written with MRPT's own streams.
#include <offmap/maps/TextMap.h>
#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/PoseTrack.h>
#include <offmap/rawlog/RegisterClasses.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/TurnReducer.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/serialization/CArchive.h>

#include <iostream>

using namespace offmap;
using mrpt::obs::CObservation, mrpt::obs::CObservationRobotPose;

namespace {

/// Calls visit(entry) for each entry. MRPT does not survive every damaged file: for logs that you
/// do not trust, see offmap/rawlog/RawlogReader.h and GuardedRun.h.
template <class Visit>
void readLog(const std::string& file, Visit&& visit) {
    mrpt::io::CFileGZInputStream stream(file);
    auto archive = mrpt::serialization::archiveFrom(stream);
    try {
        for (;;) visit(archive.ReadObject());
    } catch (const mrpt::serialization::CExceptionEOF&) {
        return;  // the clean end
    }
}

/// The observation without what the map knows. What is no 3D scan is returned as it is.
CObservation::Ptr reduced(const CObservation::Ptr& observation, rawlog::TurnReducer& reducer,
                          const rawlog::Config& config, const std::string& logFile) {
    // A 2D scan is a column of a scanner that turns; TurnCollector.h makes turns of columns.
    const bool isColumn = IS_CLASS(*observation, mrpt::obs::CObservation2DRangeScan);
    const rawlog::ScanClass* scanClass =
        rawlog::scanClassOf(*observation, config.sensorOf(observation->sensorLabel));
    if (isColumn || !scanClass) return observation;
    scanClass->loadExternal(*observation, logFile);  // if its points are in a file of their own
    const rawlog::ReducedTurn turn = reducer.reduce({observation}, *scanClass);
    const auto& record = turn.record;
    std::cout << record.className << ' ' << record.label << ": " << record.counts.returns
              << " returns, " << record.onVerticalSegments << " on vertical segments, "
              << record.removed() << " removed\n";
    if (!record.notReduced.empty()) std::cout << "  kept whole: " << record.notReduced << '\n';
    return turn.reduced[0] ? turn.reduced[0] : observation;  // null: nothing was removed
}

void run(const std::string& logFile, const std::string& mapFile, const std::string& outFile,
         const char* configFile) {
    rawlog::registerMrptClasses();  // or MRPT cannot read them
    rawlog::Config config;
    if (configFile) rawlog::applyYaml(config, configFile);
    const core::LineMap map(maps::readTextMap(mapFile, config.map.sigma));

    std::vector<rawlog::StampedPose> poses;
    readLog(logFile, [&](const auto& entry) {
        rawlog::forEachObservation(entry, [&](const CObservation::Ptr& observation, size_t) {
            const auto pose = std::dynamic_pointer_cast<CObservationRobotPose>(observation);
            if (pose) poses.push_back(rawlog::stampedPose(*pose));
        });
    });
    const rawlog::PoseTrack track(poses, config.pose.maxAge);
    const rawlog::FixedPose origin({0, 0, 0}, config.pose.sigmaPosition, config.pose.sigmaYaw);
    const rawlog::PoseSource* source = &track;
    if (poses.empty()) source = &origin;  // then the vehicle stood at the map's origin

    rawlog::TurnReducer reducer(map, *source, config, rawlog::OutputClass::Same);
    mrpt::io::CFileGZOutputStream stream(outFile);
    auto archive = mrpt::serialization::archiveFrom(stream);
    readLog(logFile, [&](mrpt::serialization::CSerializable::Ptr entry) {
        if (auto observation = std::dynamic_pointer_cast<CObservation>(entry)) {
            entry = reduced(observation, reducer, config, logFile);
        } else if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entry)) {
            for (CObservation::Ptr& member : *frame) {
                if (member) member = reduced(member, reducer, config, logFile);
            }
        }
        archive << entry;
    });
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 4) throw std::runtime_error("it takes LOG MAP OUT [CONFIG.yaml]");
        run(argv[1], argv[2], argv[3], argc > 4 ? argv[4] : nullptr);
    } catch (const std::exception& error) {
        std::cerr << argv[0] << ": " << error.what() << '\n';
        return 1;
    }
}
