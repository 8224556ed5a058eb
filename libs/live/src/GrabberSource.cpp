// SPDX-License-Identifier: BSD-3-Clause
#include "GrabberIntake.h"

#include <offmap/live/GrabberSource.h>
#include <offmap/rawlog/ShortReason.h>

#include <algorithm>
#include <utility>

namespace offmap::live {

using Steady = std::chrono::steady_clock;
using mrpt::hwdrivers::CGenericSensor;

namespace {

void waitUntil(SteadyTime time, const std::stop_token& stop) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any never;
    never.wait_until(lock, stop, time, [] { return false; });
}

/// What a thread needs of a sensor, whatever becomes of the source.
struct Sensor {
    std::shared_ptr<const GrabberFile> file;
    std::string section;
    std::shared_ptr<GrabberIntake> intake;
    std::chrono::milliseconds triesAgainAfter;

    /// Until it is stopped; or throws, as the driver does.
    void read(CGenericSensor& driver, const std::stop_token& stop) const {
        const auto period = std::chrono::duration_cast<Steady::duration>(
            std::chrono::duration<double>(1 / driver.getProcessRate()));
        auto due = Steady::now();
        while (!stop.stop_requested()) {
            driver.doProcess();
            due = std::max(due + period, Steady::now());
            if (driver.getState() == CGenericSensor::ssError) {
                // Such a driver helps itself, or is at the end of its recording.
                intake->fails(section, "its driver tells of an error");
                due = Steady::now() + triesAgainAfter;
            } else {
                intake->works(section);
            }
            intake->take(driver.getObservations());
            waitUntil(due, stop);
        }
    }

    void run(const std::stop_token& stop) const {
        while (!stop.stop_requested()) {
            try {
                const auto driver = file->makeSensor(section);
                driver->initialize();
                read(*driver, stop);
            } catch (const std::exception& error) {
                intake->fails(section, rawlog::shortReason(error));
            } catch (...) {
                intake->fails(section, "its driver failed without a reason");
            }
            waitUntil(Steady::now() + triesAgainAfter, stop);
        }
    }
};

}  // namespace

GrabberSource::GrabberSource(const std::filesystem::path& ini, const rawlog::Config& config,
                             std::shared_ptr<LivePoses> poses, const Options& options)
    : GrabberSource(std::make_shared<const GrabberFile>(ini), config, std::move(poses), options) {}

GrabberSource::GrabberSource(const std::shared_ptr<const GrabberFile>& file,
                             const rawlog::Config& config, std::shared_ptr<LivePoses> poses,
                             const Options& options)
    : waitsForDrivers_(options.waitsForDrivers),
      intake_(std::make_shared<GrabberIntake>(config, std::move(poses), options.poseLabel,
                                              options.stallsAfter, file->sections())) {
    for (const std::string& section : file->sections()) {
        const Sensor sensor{file, section, intake_, options.triesAgainAfter};
        std::packaged_task<void()> task([sensor, stop = stop_.get_token()] { sensor.run(stop); });
        auto end = task.get_future();
        workers_.push_back({std::move(end), std::thread(std::move(task))});
    }
}

GrabberSource::~GrabberSource() {
    stop_.request_stop();
    const auto latest = Steady::now() + waitsForDrivers_;
    for (Worker& worker : workers_) {
        if (worker.end.wait_until(latest) == std::future_status::ready) {
            worker.thread.join();
        } else {
            worker.thread.detach();
        }
    }
}

std::optional<ArrivedTurn> GrabberSource::next(const std::stop_token& stop) {
    return intake_->next(stop);
}

SourceHealth GrabberSource::health() const { return intake_->health(); }

}  // namespace offmap::live
