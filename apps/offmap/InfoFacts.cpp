// SPDX-License-Identifier: BSD-3-Clause
#include "InfoFacts.h"

#include "SensorLabels.h"
#include "input/Progress.h"

#include <algorithm>
#include <set>
#include <string>

namespace offmap::app {

namespace {

/// Tells the place and the progress of one of two passes.
class PassWatch {
 public:
    PassWatch(const rawlog::RawlogReader& reader, rawlog::GuardedStatus& status, Progress& progress,
              int pass)
        : reader_(reader), status_(status), progress_(progress), pass_(pass) {}

    void atEntry() const {
        status_.atEntry(reader_.place());
        const double share = static_cast<double>(reader_.compressedPosition()) /
                             static_cast<double>(reader_.compressedSize());
        progress_.tellSurvey((pass_ + share) / 2);
    }

 private:
    const rawlog::RawlogReader& reader_;
    rawlog::GuardedStatus& status_;
    Progress& progress_;
    int pass_;  ///< 0 or 1
};

void readFirst(const rawlog::Config& config, const ReadableLog& readable,
               rawlog::GuardedStatus& status, Progress& progress, LogFacts& facts) {
    rawlog::RawlogReader reader(facts.file);
    const PassWatch watch(reader, status, progress, 0);
    facts.survey = std::make_unique<rawlog::LogSurvey>(
        rawlog::surveyLog(reader, config, readable.entries, [&] { watch.atEntry(); }));
    facts.fileBytes = reader.compressedSize();
    facts.unpackedBytes = reader.place().offset;
    facts.gzip = reader.isGzip();
    facts.damage = readable.endsBecause;
    if (!facts.survey->damage) return;
    if (facts.survey->entries == 0) throw *facts.survey->damage;
    facts.damage = facts.survey->damage->what();
}

void readSecond(rawlog::GuardedStatus& status, Progress& progress, LogFacts& facts) {
    rawlog::RawlogReader reader(facts.file);
    const PassWatch watch(reader, status, progress, 1);
    for (uint64_t entry = 0; entry < facts.survey->entries; ++entry) {
        watch.atEntry();
        const auto next = reader.next();
        if (!next) {
            throw std::runtime_error(facts.file.string() + " became shorter while it was read");
        }
        facts.inventory->add(*next);
    }
    facts.inventory->finish();
}

}  // namespace

void InfoOptions::addTo(CLI::App& command) {
    command.add_option("IN", input, "Rawlog; it is only read")->required()->type_name("FILE");
    shared.addTo(command);
    command.get_option("--map")->required(false);
    command.add_option("--sensor", sensors, "Look at this 3D sensor only; may be repeated")
        ->type_name("LABEL")
        ->allow_extra_args(false);
    command.add_flag("--json", json, "The same facts as JSON");
    command.add_flag("--quiet", quiet, "No progress");
}

void InfoOptions::rememberForReduce(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (!name.starts_with("--") || name == "--json" || name == "--quiet") continue;
        for (const std::string& value : option->results()) {
            forReduce.insert(forReduce.end(), {name, value});
        }
    }
}

bool InfoOptions::chooses(const std::string& label) const {
    return sensors.empty() || std::ranges::count(sensors, label) > 0;
}

LogFacts gatherFacts(const InfoOptions& options, const rawlog::Config& config,
                     const ReadableLog& readable, rawlog::GuardedStatus& status) {
    Progress progress(options.quiet);
    LogFacts facts;
    facts.file = options.input;
    readFirst(config, readable, status, progress, facts);
    facts.warnings = checkSingleSensors(config, *facts.survey, options.input);
    facts.poses = findPoses(options.shared, config, options.input, *facts.survey);
    std::vector<rawlog::PoseCoverage*> coverages;
    for (const PoseSourceFacts& source : facts.poses.sources) {
        if (source.coverage) coverages.push_back(source.coverage.get());
    }
    facts.inventory = std::make_unique<rawlog::LogInventory>(
        *facts.survey, config, options.input,
        std::set<std::string>(options.sensors.begin(), options.sensors.end()),
        std::move(coverages));
    readSecond(status, progress, facts);
    facts.poses.chooseBest();
    return facts;
}

}  // namespace offmap::app
